// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "fairway/mpc/body/body_problem.hpp"
#include "fairway/mpc/step_index.hpp"

// The hard limits of the inputs at every step, and a sequence strictly inside all of them.

namespace fairway {

/// Limits of the inputs by step. Where the previous input is outside of a limit, the limit is
/// relaxed to what a return within the change bound needs.
template <typename Motion>
struct InputBounds {
  using Input = typename Motion::Input;
  std::array<Input, kMaxHorizon> low;
  std::array<Input, kMaxHorizon> high;
  std::array<std::array<double, kMaxInputLimits>, kMaxHorizon> limits;  ///< bounds of input_limits
  std::array<Input, kMaxHorizon> inside;  ///< strictly inside every bound, changes included
  bool relaxed = false;                   ///< whether the limits of the problem cannot all hold
};

/// Returns an input strictly inside the range and the limits, near to rest.
/// @pre The range is not empty, and the input nearest to rest is strictly inside the limits.
template <typename Motion>
[[nodiscard]] typename Motion::Input calm_input(const BodyProblem<Motion>& problem) noexcept {
  const typename Motion::Input rest =
      problem.input_min.cwiseMax(problem.input_max.cwiseMin(Motion::Input::Zero()));
  const typename Motion::Input to_middle = 0.5 * (problem.input_min + problem.input_max) - rest;
  double share = 0.5;
  for (int i = 0; i < problem.num_input_limits; ++i) {
    const auto& limit = problem.input_limits[step_index(i)];
    const double slope = std::abs(limit.normal.dot(to_middle));
    if (slope > 0.0)
      share = std::min(share, 0.5 * (limit.bound - std::abs(limit.normal.dot(rest))) / slope);
  }
  return rest + share * to_middle;
}

/// Computes the bounds of all steps. The sequence inside goes straight from the previous input to
/// `calm_input`, which stays inside every convex set that holds both.
template <typename Motion>
void find_input_bounds(const BodyProblem<Motion>& problem, InputBounds<Motion>& bounds) noexcept {
  constexpr double kShare = 0.9;       // of the change bound
  constexpr double kMargin = 1e-3;     // of a range, beyond an input that relaxes it
  constexpr double kRounding = 1e-12;  // of a range
  const typename Motion::Input calm = calm_input(problem);
  const typename Motion::Input range = problem.input_max - problem.input_min;
  typename Motion::Input input = problem.previous_input;
  bounds.relaxed = false;
  for (std::size_t k = 0; k < step_index(problem.horizon); ++k) {
    double share = 1.0;
    for (int j = 0; j < Motion::kInputs; ++j) {
      const double distance = std::abs(calm[j] - input[j]);
      const double most = kShare * problem.max_change[j];
      if (distance > most) share = std::min(share, most / distance);
    }
    input += share * (calm - input);
    bounds.inside[k] = input;
    for (int j = 0; j < Motion::kInputs; ++j) {
      const double rounding = kRounding * range[j];
      const bool below = !(input[j] > problem.input_min[j] + rounding);
      const bool above = !(input[j] < problem.input_max[j] - rounding);
      bounds.relaxed = bounds.relaxed || below || above;
      bounds.low[k][j] = below ? input[j] - kMargin * range[j] : problem.input_min[j];
      bounds.high[k][j] = above ? input[j] + kMargin * range[j] : problem.input_max[j];
    }
    for (int i = 0; i < problem.num_input_limits; ++i) {
      const auto& limit = problem.input_limits[step_index(i)];
      const double value = std::abs(limit.normal.dot(input));
      const bool above = !(value < limit.bound * (1.0 - kRounding));
      bounds.relaxed = bounds.relaxed || above;
      bounds.limits[k][step_index(i)] = above ? value + kMargin * limit.bound : limit.bound;
    }
  }
}

}  // namespace fairway
