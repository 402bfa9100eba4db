// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "fairway/map/bit_grid.hpp"
#include "fairway/tracking/corridor_follower.hpp"

namespace fairway {

/// Whether the rectangles that the robot enters within `length` [m] of its reference path are free
/// for it.
///
/// @param radius     Of the robot's disc [m]; a corridor built for less is tested for that.
/// @param tolerance  By which the disc may be smaller: a cell that flickers at a side is no reason
///                   for another plan [m].
[[nodiscard]] bool corridor_is_free(
    const BitGrid& obstacles,
    const CorridorFollower& corridor,
    double radius,
    double tolerance,
    double length = std::numeric_limits<double>::infinity()) noexcept;

}  // namespace fairway
