// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/corridor/rectangle/box.hpp"
#include "fairway/corridor/rectangle/obstacle_points.hpp"

namespace fairway {

/// Lengths of the growth in Algorithm 1 [cells].
struct GreedySteps {
  double start = 0.0;  ///< initial distance of every side from the origin
  double step = 1.0;   ///< step by which a side advances; > 0
  double limit = 1.0;  ///< greatest distance of a side from the origin
};

/// Computes the result of Algorithm 1's growth if the obstacles were only these points.
///
/// Four sides advance in turn (up, left, down, right), one step at a time. A side whose strip would
/// contain a point, or that would pass the limit, continues by single cells and then stops. The
/// function does not perform the steps one by one: it computes for all points at once the turn at
/// which each would be met, and advances all sides to the first of these turns.
///
/// The sides keep 1e-4 of a step from the points, so that rounding does not let one in. If the
/// rectangle is free on the map, it is the one that growing on the whole map gives: everything it
/// passed is free, and everything that stopped a side is an obstacle.
///
/// @param along  Unit vector along the box's x-axis.
/// @return none if a point lies in the initial box.
[[nodiscard]] std::optional<Box> greedy_box(const ObstaclePoints& points,
                                            const Eigen::Vector2d& along,
                                            const GreedySteps& steps) noexcept;

}  // namespace fairway
