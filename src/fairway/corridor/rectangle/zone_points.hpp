// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/corridor/rectangle/obstacle_points.hpp"
#include "fairway/corridor/rectangle/turned_frame.hpp"

namespace fairway {

/// Adds points that a free rectangle must not contain because of the zones of a map. These are
/// points of the zones' boundaries within `reach` of `origin`, moved towards it by the clearance.
/// @param radius  As for find_blocked_cells [cells].
void look_at_zones(const BitGrid& obstacles,
                   const Eigen::Vector2d& origin,
                   double radius,
                   double reach,
                   ObstaclePoints& points) noexcept;

/// Adds such points that lie in `box`, which zones forbid.
void learn_zones(const BitGrid& obstacles,
                 const TurnedFrame& frame,
                 const Box& box,
                 double radius,
                 ObstaclePoints& points) noexcept;

/// The direction of the nearest boundary, relative to the grid [rad]; none beyond `reach` [cells].
[[nodiscard]] std::optional<double> direction_of_nearest_zone(const BitGrid& obstacles,
                                                              const Eigen::Vector2d& origin,
                                                              double reach) noexcept;

}  // namespace fairway
