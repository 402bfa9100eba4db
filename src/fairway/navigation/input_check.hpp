// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/navigation/dead_reckoning.hpp"
#include "fairway/navigation/navigation_step.hpp"
#include "fairway/safety/safety_settings.hpp"

namespace fairway {

/// Checks the inputs of a cycle, and returns why the robot must not drive on them, or None. Inputs
/// may be not finite or too old, and the pose may jump. If the pose is consistent, `reckoning` is
/// updated with it.
[[nodiscard]] LimitingFactor check_input(const NavigationInput& input,
                                         const SafetySettings& settings,
                                         DeadReckoning& reckoning) noexcept;

/// Returns the status of a robot that stops for this reason.
[[nodiscard]] NavigationStatus status_for(LimitingFactor bad_input) noexcept;

}  // namespace fairway
