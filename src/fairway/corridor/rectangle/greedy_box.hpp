// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/corridor/rectangle/box.hpp"
#include "fairway/corridor/rectangle/obstacle_points.hpp"

namespace fairway {

/// Lengths of Algorithm 1's growth [cells].
struct GreedySteps {
  double start = 0.0;  ///< every side starts this far from the origin
  double step = 1.0;   ///< how far a side advances at once; > 0
  double limit = 1.0;  ///< furthest a side may get from the origin
};

/// What Algorithm 1's growth comes to when the obstacles are just these points.
///
/// Four sides advance in turn (up, left, down, right), a step at a time; one whose strip would hold
/// a point, or that would pass the limit, goes on by single cells and then stops. Not one step
/// after the other: for all points at once it is worked out at which turn they would be met, and
/// all sides advance to the first of these turns.
///
/// The sides keep 1e-4 of a step to the points, so that rounding does not let one in. Should the
/// rectangle be free on the map, then it is the one that growing on the whole map gives: all that
/// it has passed is free, and all that stopped a side is an obstacle.
///
/// @param along  Unit vector along the box's x-axis.
/// @return none when a point lies in the box that it starts from.
[[nodiscard]] std::optional<Box> greedy_box(const ObstaclePoints& points,
                                            const Eigen::Vector2d& along,
                                            const GreedySteps& steps) noexcept;

}  // namespace fairway
