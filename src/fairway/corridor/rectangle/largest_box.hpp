// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/corridor/rectangle/box.hpp"
#include "fairway/corridor/rectangle/obstacle_points.hpp"

namespace fairway {

/// Finds the largest box that contains a core and has no obstacle point in its interior, in one
/// orientation.
///
/// The result is exact up to float rounding. In each quadrant around the origin only points matter
/// for which no other point is nearer in both coordinates; sorted, they form a staircase. The two
/// upper staircases give all levels at which the top side can stop, with the extent to its left and
/// right. The lower ones give the same for the bottom side. Every pair of a top and a bottom level
/// is tried.
///
/// @param along  Unit vector along the box's x-axis, in the points' frame. @pre both coordinates
///       are >= 0; every box has such a frame.
/// @param core  What the box must contain. @pre it contains the points' origin, and its sides are
///       at most `longest_side`.
/// @param longest_side  Greatest length of a side [cells]. A box limited by it lies as centrally
///       about the core as possible.
/// @return none if a point lies inside the core, or no such box is larger than `least_area`.
[[nodiscard]] std::optional<Box> largest_box(const ObstaclePoints& points,
                                             const Eigen::Vector2d& along,
                                             const Box& core,
                                             double longest_side,
                                             double least_area) noexcept;

}  // namespace fairway
