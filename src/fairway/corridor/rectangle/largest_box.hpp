// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/corridor/rectangle/box.hpp"
#include "fairway/corridor/rectangle/obstacle_points.hpp"

namespace fairway {

/// The largest box that holds a core and has no obstacle point in its interior, in one orientation.
///
/// Exact up to float rounding. In each of the four quadrants around the origin only those points
/// matter that have no other one nearer in both coordinates: sorted, a staircase. The two upper
/// staircases give all levels at which a top side can stop, with the room to its left and right;
/// the lower ones the same for the bottom side; and every pair of a top and a bottom is tried.
///
/// @param along  Unit vector along the box's x-axis, seen from the points' frame. @pre neither of
///               its coordinates is negative; every box has such a frame.
/// @param core  What the box must hold. @pre it holds the points' origin, and its sides are at most
///              `longest_side`.
/// @param longest_side  Where a side would be longer, the box lies as centrally about the core as
///                      it may [cells].
/// @return none when a point lies inside the core, or no such box is larger than `least_area`.
[[nodiscard]] std::optional<Box> largest_box(const ObstaclePoints& points,
                                             const Eigen::Vector2d& along,
                                             const Box& core,
                                             double longest_side,
                                             double least_area) noexcept;

}  // namespace fairway
