// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "fairway/navigation/dead_reckoning.hpp"
#include "fairway/navigation/navigation_step.hpp"
#include "fairway/safety/safety_settings.hpp"

namespace fairway {

/// Checks the inputs of a cycle: returns why the robot must not drive on them (not finite, too old,
/// or a pose jump), or None. If the pose is consistent, `reckoning` is updated with it.
[[nodiscard]] LimitingFactor check_input(const NavigationInput& input,
                                         const SafetySettings& settings,
                                         DeadReckoning& reckoning) noexcept;

/// Detects times that are not in seconds: two consecutive cycles that each come more than a hundred
/// control periods after the one before. A single pause is accepted.
class CycleClock {
 public:
  /// Returns false if `time` [s] is implausible for cycles of `period` [s].
  [[nodiscard]] bool plausible(double time, double period) noexcept;

 private:
  double last_ = std::numeric_limits<double>::infinity();
  int slow_ = 0;  // number of consecutive long intervals
};

/// Returns the status of a robot that stops for this reason.
[[nodiscard]] NavigationStatus status_for(LimitingFactor bad_input) noexcept;

}  // namespace fairway
