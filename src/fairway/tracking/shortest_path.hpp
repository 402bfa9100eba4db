// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <Eigen/Core>

#include "fairway/geometry/oriented_rectangle.hpp"

namespace fairway {

/// The point of `patch` with the shortest way from `a` to it and on to `b`.
///
/// Where the straight line from a to b crosses the patch, any point of the crossing is shortest;
/// the one nearest to the middle of it is taken, so that the answer moves smoothly. @pre
/// patch.count > 0.
[[nodiscard]] Eigen::Vector2d shortest_touch(const OverlapPatch& patch,
                                             const Eigen::Vector2d& a,
                                             const Eigen::Vector2d& b) noexcept;

/// Pulls the string start -> points[0] -> ... -> points.back() -> end taut, each point held in its
/// patch.
///
/// Coordinate descent: a sweep moves each point to its shortest touch between its neighbours. The
/// length never grows, and the limit is the shortest string through the patches in order.
/// @pre points.size() == patches.size(), each point in its patch.
void shorten_in_patches(std::span<const OverlapPatch> patches,
                        const Eigen::Vector2d& start,
                        const Eigen::Vector2d& end,
                        std::span<Eigen::Vector2d> points,
                        int sweeps) noexcept;

}  // namespace fairway
