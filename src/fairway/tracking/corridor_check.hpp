// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "fairway/map/bit_grid.hpp"
#include "fairway/tracking/corridor_follower.hpp"

namespace fairway {

/// Returns whether the rectangles that the reference path enters within `length` [m] are free for
/// the robot.
///
/// @param radius     Radius of the robot's disc [m]; a corridor built for a smaller disc is tested
///       for that.
/// @param tolerance  Amount by which the disc may be smaller [m], so that a cell that flickers at a
///       side does not cause a new plan.
[[nodiscard]] bool corridor_is_free(
    const BitGrid& obstacles,
    const CorridorFollower& corridor,
    double radius,
    double tolerance,
    double length = std::numeric_limits<double>::infinity()) noexcept;

}  // namespace fairway
