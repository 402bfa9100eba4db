// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

#include "fairway/corridor/corridor.hpp"
#include "fairway/corridor/corridor_builder.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/path/path.hpp"

namespace fairway {

/// Covers a path by growing each rectangle where the last one ends: Algorithm 2 as corrected in
/// docs/paper_notes.md. For the guarantees when the status is Built, see build_corridor.
///
/// Seeds are points of the path, `waypoint_spacing` apart, and its corners. As in the paper, the
/// next seed is the last point inside the admissible part of the last rectangle. If the rectangle
/// grown there misses the next point or overlaps too little, the point after it and then those
/// before it are tried, each seed at most once. If no seed succeeds, the largest rectangle that
/// contains the last point and the next one is used.
[[nodiscard]] CorridorResult build_sequential(const BitGrid& obstacles,
                                              const Path& path,
                                              double robot_radius,
                                              const CorridorSettings& settings);

/// Grows a free rectangle around a seed [m], or returns none.
using GrowRectangle = std::function<std::optional<OrientedRectangle>(const Eigen::Vector2d&)>;

/// Builds the same chain from rectangles that `grow` supplies (the baselines of the benchmarks use
/// this).
/// @pre every rectangle that `grow` returns is free and contains its seed.
[[nodiscard]] CorridorResult build_sequential(const BitGrid& obstacles,
                                              const Path& path,
                                              double robot_radius,
                                              const CorridorSettings& settings,
                                              const GrowRectangle& grow);

}  // namespace fairway
