// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/starts.hpp"

#include <algorithm>

namespace fairway {
namespace {

InitialGuess arc_start(const ControlProblem& problem, double angular) noexcept {
  InitialGuess guess;
  guess.count = std::clamp(problem.horizon, 1, kMaxHorizon);
  const int turning = (guess.count + 2) / 3;
  const double linear = 0.5 * (problem.command_min.linear + problem.command_max.linear);
  for (int k = 0; k < guess.count; ++k) {
    guess.commands[static_cast<std::size_t>(k)] = {.linear = linear,
                                                   .angular = k < turning ? angular : 0.0};
  }
  return guess;
}

}  // namespace

InitialGuess straight_start(const ControlProblem& problem) noexcept {
  return arc_start(problem, 0.0);
}

InitialGuess left_start(const ControlProblem& problem) noexcept {
  return arc_start(problem, problem.command_max.angular);
}

InitialGuess right_start(const ControlProblem& problem) noexcept {
  return arc_start(problem, problem.command_min.angular);
}

InitialGuess shifted_start(const MpcSolution& solution) noexcept {
  InitialGuess guess;
  guess.count = std::clamp(solution.horizon, 0, kMaxHorizon);
  for (int k = 0; k < guess.count; ++k) {
    guess.commands[static_cast<std::size_t>(k)] =
        solution.commands[static_cast<std::size_t>(std::min(k + 1, guess.count - 1))];
  }
  return guess;
}

}  // namespace fairway
