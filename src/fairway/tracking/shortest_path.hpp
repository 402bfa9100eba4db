// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <Eigen/Core>

#include "fairway/geometry/oriented_rectangle.hpp"

namespace fairway {

/// Returns the point of `patch` with the shortest path from `a` over it to `b`.
///
/// Where the straight line from a to b crosses the patch, any point of the crossing is shortest.
/// The middle is taken, so that the result changes smoothly. @pre patch.count > 0.
[[nodiscard]] Eigen::Vector2d shortest_touch(const OverlapPatch& patch,
                                             const Eigen::Vector2d& a,
                                             const Eigen::Vector2d& b) noexcept;

/// Shortens the path start -> points[0] -> ... -> points.back() -> end, with each point in its
/// patch.
///
/// Coordinate descent: a sweep moves each point to its shortest touch between its neighbours. The
/// length never grows, and converges to that of the shortest path through the patches in order.
/// @pre points.size() == patches.size(), and each point is in its patch.
void shorten_in_patches(std::span<const OverlapPatch> patches,
                        const Eigen::Vector2d& start,
                        const Eigen::Vector2d& end,
                        std::span<Eigen::Vector2d> points,
                        int sweeps) noexcept;

}  // namespace fairway
