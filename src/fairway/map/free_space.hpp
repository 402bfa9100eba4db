// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>

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
/// Cost: one word operation per 64 cells of every band of rows that the region touches, and of
/// every row of the bands in which something is near.
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

/// A rectangle in grid coordinates: the points origin + x u + y v with min <= (x, y) <= max, where
/// u is the unit vector `along` and v is u turned by +90 degrees. Lengths in cells.
///
/// The form for searches that test thousands of rectangles: no angle, so no sine or cosine per
/// test.
struct TurnedBox {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  Eigen::Vector2d along = Eigen::Vector2d::UnitX();
  Eigen::Vector2d min = Eigen::Vector2d::Zero();
  Eigen::Vector2d max = Eigen::Vector2d::Zero();
};

/// What lies in the way of a box: see find_blocked_cells.
struct BlockedCells {
  std::size_t count = 0;     ///< how many cells were written
  bool outside_map = false;  ///< the region reaches out of the grid (cells may be written as well)
};

/// Blocked cells at most `radius` [cells] from `box`: in every row that has any, the one nearest to
/// `towards` (in columns), written into `found` until it is full; rows in bands
/// (BitGrid::kBandRows), from the one of `towards` outwards. No skin is added. The part outside the
/// grid is not looked at, only reported.
///
/// The same exact test as find_blocked_cell, for callers that want to learn more from one pass:
/// none is written if and only if there is none (and `found` has room). @pre box not empty, finite;
/// radius >= 0.
[[nodiscard]] BlockedCells find_blocked_cells(const BitGrid& obstacles,
                                              const TurnedBox& box,
                                              double radius,
                                              const Eigen::Vector2d& towards,
                                              std::span<CellIndex> found) noexcept;

/// Whether no blocked cell is at most `radius` [cells] from `box` and the region lies in the grid;
/// no skin is added. @pre as above.
[[nodiscard]] bool is_free(const BitGrid& obstacles, const TurnedBox& box, double radius) noexcept;

}  // namespace fairway
