// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/safety/safety_settings.hpp"
#include "fairway/safety/stop_check.hpp"

namespace fairway {

/// Returns the static part of the check of a stop, for a robot at `pose`. It holds the body, the
/// margin and the disc in which the robot must be able to turn, but no moving obstacle.
///
/// The body keeps `stop_margin`, and the disc about a rectangular body may lose
/// `turn_clearance_tolerance`. A robot that is already nearer to an obstacle must be able to leave,
/// so it only must not come nearer. A disc keeps no more than half of the plan's margin, because a
/// narrow passage has no more.
/// @param plan_margin  Clearance beyond the robot's radius that the plan keeps [m].
/// @param radius       Of the disc that the plan keeps free [m].
[[nodiscard]] CollisionEnvironment static_environment(const BitGrid& obstacles,
                                                      const Footprint& body,
                                                      const Pose2& pose,
                                                      double plan_margin,
                                                      double radius,
                                                      const SafetySettings& settings) noexcept;

}  // namespace fairway
