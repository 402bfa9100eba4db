// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/geometry/oriented_rectangle.hpp"
#include "fairway/map/bit_grid.hpp"

namespace fairway {

/// Room kept between a free region and every obstacle beyond what is asked [m]: far above the float
/// error of any coordinate here (about 1e-11 m) and of a number printed with seven digits, far
/// below anything a robot can notice.
inline constexpr double kFreeSpaceSkin = 1e-6;

/// Some blocked cell that is at most `clearance` + kFreeSpaceSkin away from `rectangle` [m], or
/// none.
///
/// THE test that everything in Fairway rests on. Cells are closed squares, the rectangle is closed,
/// distances are Euclidean (so the grown rectangle has round corners), and nothing is sampled: the
/// answer is exact up to the skin, which errs towards "blocked". Everything outside the grid is
/// blocked; then the cell returned lies outside the grid. With clearance 0 it tests a footprint or
/// a workspace rectangle; with the robot's radius it tests a rectangle for a disc robot's centre;
/// on a segment it tests a straight motion, on a point a disc.
///
/// Cost: one word operation per 64 cells of every row that the region touches.
/// An empty rectangle, a negative clearance or a number that is not finite counts as blocked.
[[nodiscard]] std::optional<CellIndex> find_blocked_cell(const BitGrid& obstacles,
                                                         const OrientedRectangle& rectangle,
                                                         double clearance) noexcept;

/// Whether every blocked cell is further than `clearance` from `rectangle`; see find_blocked_cell.
[[nodiscard]] inline bool is_free(const BitGrid& obstacles,
                                  const OrientedRectangle& rectangle,
                                  double clearance) noexcept {
  return !find_blocked_cell(obstacles, rectangle, clearance);
}

/// Whether a disc of radius `clearance` can move straight from `a` to `b`.
[[nodiscard]] inline bool is_free(const BitGrid& obstacles,
                                  const Eigen::Vector2d& a,
                                  const Eigen::Vector2d& b,
                                  double clearance) noexcept {
  return is_free(obstacles, segment_rectangle(a, b), clearance);
}

/// Distance from `point` to the nearest blocked cell or the outside of the grid, exact, but at most
/// `limit` [m]. 0 on a blocked cell, outside the grid, or for a point that is not finite.
[[nodiscard]] double distance_to_blocked(const BitGrid& obstacles,
                                         const Eigen::Vector2d& point,
                                         double limit) noexcept;

}  // namespace fairway
