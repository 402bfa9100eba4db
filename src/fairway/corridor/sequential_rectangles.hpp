// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

#include "fairway/corridor/corridor.hpp"
#include "fairway/corridor/corridor_settings.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/path/path.hpp"

namespace fairway {

/// Covers a path by growing a rectangle wherever the last one ends: Algorithm 2 as corrected in
/// docs/paper_notes.md. See build_corridor for what holds when it is Built.
///
/// Seeds are points of the path, `waypoint_spacing` apart, its corners included. The next seed is
/// the last point inside the admissible part of the last rectangle, as in the paper. Where that
/// rectangle does not bring the chain on (its admissible part misses the next point, or overlaps
/// too little), the point after it and then those before it are tried, no seed twice; and when no
/// seed helps, the largest rectangle that holds the last point and the next.
[[nodiscard]] CorridorResult build_sequential(const BitGrid& obstacles,
                                              const Path& path,
                                              double robot_radius,
                                              const CorridorSettings& settings);

/// Grows a free rectangle around a seed [m], or says that there is none.
using GrowRectangle = std::function<std::optional<OrientedRectangle>(const Eigen::Vector2d&)>;

/// The same chain out of rectangles that somebody else grows (the baselines do).
/// @pre every rectangle that `grow` returns is free and holds its seed.
[[nodiscard]] CorridorResult build_sequential(const BitGrid& obstacles,
                                              const Path& path,
                                              double robot_radius,
                                              const CorridorSettings& settings,
                                              const GrowRectangle& grow);

}  // namespace fairway
