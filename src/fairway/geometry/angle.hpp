// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

namespace fairway {

/// Returns the equivalent angle in (-pi, pi] [rad]; a non-finite angle stays non-finite.
[[nodiscard]] inline double wrap_to_pi(double angle) noexcept {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const double wrapped = std::remainder(angle, kTurn);  // in [-pi, pi]
  return wrapped <= -std::numbers::pi ? wrapped + kTurn : wrapped;
}

/// Returns the smallest turn from heading `from` to heading `to`, in (-pi, pi] [rad].
[[nodiscard]] inline double shortest_turn(double from, double to) noexcept {
  return wrap_to_pi(to - from);
}

}  // namespace fairway
