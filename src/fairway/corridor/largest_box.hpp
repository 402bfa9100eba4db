// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/corridor/box.hpp"
#include "fairway/corridor/obstacle_points.hpp"

namespace fairway {

/// The largest box that holds `core` and has no obstacle point in its interior, in the frame turned
/// so that its x-axis points along `along` (a unit vector); none when a point lies inside the core.
///
/// No side gets longer than `longest_side`; the box then lies as centrally about the core as it
/// may. Exact up to float rounding: the staircases of nearest points in the four quadrants around
/// the core give all heights that a top or bottom side can stop at, and every pair is tried.
///
/// @pre the core holds the points' origin, and its sides are at most `longest_side`.
[[nodiscard]] std::optional<Box> largest_box(const ObstaclePoints& points,
                                             const Eigen::Vector2d& along,
                                             const Box& core,
                                             double longest_side) noexcept;

}  // namespace fairway
