// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "fairway/navigation/dead_reckoning.hpp"
#include "fairway/navigation/navigation_step.hpp"
#include "fairway/safety/safety_settings.hpp"

namespace fairway {

/// What is wrong with the inputs of a cycle: not finite, too old, or a pose that jumped. None when
/// the robot may drive on them. `reckoning` takes in the pose if it fits.
[[nodiscard]] LimitingFactor check_input(const NavigationInput& input,
                                         const SafetySettings& settings,
                                         DeadReckoning& reckoning) noexcept;

/// Notices times that are not in seconds: two cycles in a row that come a hundred control periods
/// after the one before. A single pause is none.
class CycleClock {
 public:
  [[nodiscard]] bool plausible(double time, double period) noexcept;

 private:
  double last_ = std::numeric_limits<double>::infinity();
  int slow_ = 0;  // such intervals in a row
};

/// The status of a robot that stops because of this.
[[nodiscard]] NavigationStatus status_for(LimitingFactor bad_input) noexcept;

}  // namespace fairway
