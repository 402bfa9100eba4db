// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/navigation/dead_reckoning.hpp"
#include "fairway/navigation/navigation_step.hpp"
#include "fairway/safety/safety_settings.hpp"

namespace fairway {

/// What is wrong with the inputs of a cycle: not finite, too old, or a pose that jumped. None when
/// the robot may drive on them. `reckoning` takes in the pose if it fits.
[[nodiscard]] LimitingFactor check_input(const NavigationInput& input,
                                         const SafetySettings& settings,
                                         DeadReckoning& reckoning) noexcept;

/// The status of a robot that stops because of this.
[[nodiscard]] NavigationStatus status_for(LimitingFactor bad_input) noexcept;

}  // namespace fairway
