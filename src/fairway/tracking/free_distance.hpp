// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/geometry/robot_settings.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/tracking/corridor_follower.hpp"

namespace fairway {

/// Returns the length along the reference path for which a disc of `radius` [m] is free, at most
/// `limit` [m].
///
/// The test advances in steps of 0.1 m, so the result may be too short by that much, and is never
/// too long. If the disc is not free at the start, it is reduced to what fits there, because the
/// robot already is there.
[[nodiscard]] double free_length(const BitGrid& obstacles,
                                 const ReferencePath& path,
                                 double radius,
                                 double limit) noexcept;

/// Returns the distance along the reference path within which the robot must be able to stop [m]:
/// the length that is free for it. The result is infinite if the whole path is free, or free beyond
/// what matters at the robot's greatest speed.
/// @param horizon  Time that the controller plans ahead [s].
[[nodiscard]] double distance_to_stop_in(const BitGrid& obstacles,
                                         const ReferencePath& path,
                                         const RobotSettings& robot,
                                         double horizon) noexcept;

}  // namespace fairway
