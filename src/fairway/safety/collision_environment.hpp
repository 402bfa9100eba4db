// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/safety/safety_settings.hpp"
#include "fairway/safety/stop_check.hpp"

namespace fairway {

/// The static part of what a stop is checked against, for a robot at `pose`: its body, the margin,
/// and the disc in which it must be able to turn; nothing that moves.
///
/// The body keeps `stop_margin`, and the disc about a rectangular body may lose
/// `turn_clearance_tolerance`. A robot that stands nearer to something than that must be able to
/// leave: then what counts is to come no nearer. A disc keeps no more than half of the plan's
/// margin, which is all that there can be where the way is tight.
/// @param plan_margin  Clearance beyond the robot's radius that the plan keeps [m].
/// @param radius       Of the disc that the plan keeps free [m].
[[nodiscard]] CollisionEnvironment static_environment(const BitGrid& obstacles,
                                                      const Footprint& body,
                                                      const Pose2& pose,
                                                      double plan_margin,
                                                      double radius,
                                                      const SafetySettings& settings) noexcept;

}  // namespace fairway
