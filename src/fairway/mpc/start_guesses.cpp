// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/start_guesses.hpp"

#include <array>

namespace fairway {
namespace {

// Element `index` of the van der Corput sequence: 1/b, 2/b, ..., always inside (0, 1).
double radical_inverse(std::size_t index, std::size_t base) noexcept {
  double result = 0.0;
  double digit = 1.0;
  for (; index > 0; index /= base) {
    digit /= static_cast<double>(base);
    result += digit * static_cast<double>(index % base);
  }
  return result;
}

// The commands of both halves of the horizon, as shares (0..1) of their range.
struct Shares {
  std::array<double, 2> linear;
  std::array<double, 2> angular;
};

Shares shares_of(std::size_t index) noexcept {
  if (index == 1) return {.linear = {1.0, 1.0}, .angular = {1.0, 1.0}};
  if (index == 2) return {.linear = {1.0, 1.0}, .angular = {0.0, 0.0}};
  if (index == 3) return {.linear = {1.0, 1.0}, .angular = {0.5, 0.5}};
  const std::size_t i = index - 3;
  return {.linear = {radical_inverse(i, 2), radical_inverse(i, 5)},
          .angular = {radical_inverse(i, 3), radical_inverse(i, 7)}};
}

}  // namespace

void spread_guesses(const ControlProblem& problem,
                    const InitialGuess& first,
                    std::span<InitialGuess> guesses) noexcept {
  const auto between = [](double low, double high, double share) {
    return low + share * (high - low);
  };
  for (std::size_t i = 0; i < guesses.size(); ++i) {
    if (i == 0) {
      guesses[0] = first;
      continue;
    }
    const Shares shares = shares_of(i);
    guesses[i].count = problem.horizon;
    for (int k = 0; k < problem.horizon; ++k) {
      const std::size_t half = 2 * k < problem.horizon ? 0 : 1;
      guesses[i].commands[static_cast<std::size_t>(k)] = {
          .linear =
              between(problem.command_min.linear, problem.command_max.linear, shares.linear[half]),
          .angular = between(problem.command_min.angular, problem.command_max.angular,
                             shares.angular[half])};
    }
  }
}

}  // namespace fairway
