// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/geometry/robot_settings.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/tracking/corridor_follower.hpp"

namespace fairway {

/// How far along the string a disc of `radius` stays free, at most `limit` [m].
///
/// In steps of 0.1 m, so it may be up to that much less than the truth, never more. A disc that is
/// not free at the start is taken as large as it fits there: the robot stands there, after all.
[[nodiscard]] double free_length(const BitGrid& obstacles,
                                 const ReferencePath& path,
                                 double radius,
                                 double limit) noexcept;

/// How far along the string the robot must be able to stand [m]: the length that is free for it, or
/// infinite when that is all of the string, or further than matters at its greatest speed.
/// @param horizon  How far ahead the controller plans [s].
[[nodiscard]] double distance_to_stop_in(const BitGrid& obstacles,
                                         const ReferencePath& path,
                                         const RobotSettings& robot,
                                         double horizon) noexcept;

}  // namespace fairway
