// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/navigation/settings.hpp"
#include "fairway/navigation/stopping.hpp"

namespace fairway {

/// The static part of what a stop is checked against, for a robot at `pose`: its body, the margin,
/// and the disc in which it must be able to turn; nothing that moves.
///
/// The body keeps `stop_margin`, and the disc about a rectangular body may lose `turning_play`. A
/// robot that stands nearer to something than that must be able to leave: then what counts is to
/// come no nearer. A disc keeps no more than half of the plan's margin, which is all that there can
/// be where the way is tight.
/// @param plan_margin  Room beyond the robot's radius that the way keeps [m].
[[nodiscard]] StopSurroundings static_surroundings(const BitGrid& obstacles,
                                                   const Footprint& body,
                                                   const Pose2& pose,
                                                   double plan_margin,
                                                   const Settings& settings) noexcept;

}  // namespace fairway
