// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "fairway/geometry/oriented_rectangle.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/zones/zone_map.hpp"

namespace fairway {

/// Extra clearance [m] that every test adds to the one requested. It is far above the rounding
/// error of coordinates (about 1e-11 m) and of numbers printed with seven digits, and far below
/// what matters to a robot.
inline constexpr double kFreeSpaceSkin = 1e-6;

/// Returns a blocked cell at most `clearance` + kFreeSpaceSkin [m] away from `rectangle`, or none.
///
/// Where the zones forbid the rectangle, with the same clearance and skin, the result is a cell
/// outside the grid. `subject` says what the rectangle represents, which matters to zones only.
///
/// All other tests for free space in Fairway rely on this one. Cells are closed squares, the
/// rectangle is closed, and distances are Euclidean (the grown rectangle has round corners).
/// Nothing is sampled: the answer is exact up to the skin, which errs towards "blocked". Everything
/// outside the grid is blocked; the cell returned then lies outside the grid.
///
/// With clearance 0 the function tests a footprint or a workspace rectangle. With the robot's
/// radius it tests a rectangle for the centre of a disc robot; a segment then represents a straight
/// motion, and a point for a disc. An empty rectangle, a negative clearance or a non-finite number
/// counts as blocked.
///
/// The cost is one word operation per 64 cells of every band that the region touches. Bands that
/// contain obstacles near the region cost as much for each of their rows.
[[nodiscard]] std::optional<CellIndex> find_blocked_cell(
    const BitGrid& obstacles,
    const OrientedRectangle& rectangle,
    double clearance,
    ZoneSubject subject = ZoneSubject::Disc) noexcept;

/// Returns whether every blocked cell is further than `clearance` [m] from `rectangle`; see
/// find_blocked_cell.
[[nodiscard]] inline bool is_free(const BitGrid& obstacles,
                                  const OrientedRectangle& rectangle,
                                  double clearance,
                                  ZoneSubject subject = ZoneSubject::Disc) noexcept {
  return !find_blocked_cell(obstacles, rectangle, clearance, subject);
}

/// Returns whether a disc of radius `clearance` [m] can move straight from `a` to `b`.
[[nodiscard]] inline bool is_free(const BitGrid& obstacles,
                                  const Eigen::Vector2d& a,
                                  const Eigen::Vector2d& b,
                                  double clearance,
                                  ZoneSubject subject = ZoneSubject::Disc) noexcept {
  return is_free(obstacles, segment_rectangle(a, b), clearance, subject);
}

/// Returns the exact distance from `point` to the nearest obstacle, at most `limit` [m]. Obstacles
/// are the blocked cells and the outside of the grid. The distance is 0 on an obstacle, and for a
/// non-finite point. Zones count with ZoneMap::clearance_at; with `subject` Body only those for the
/// contour.
[[nodiscard]] double distance_to_blocked(const BitGrid& obstacles,
                                         const Eigen::Vector2d& point,
                                         double limit,
                                         ZoneSubject subject = ZoneSubject::Disc) noexcept;

/// A rectangle in grid coordinates, with lengths in cells. It holds the points origin + x u + y v
/// with min <= (x, y) <= max, where u is the unit vector `along` and v is u rotated by +90 degrees.
///
/// Searches that test thousands of rectangles use this form: it needs no sine or cosine per test.
struct TurnedBox {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  Eigen::Vector2d along = Eigen::Vector2d::UnitX();
  Eigen::Vector2d min = Eigen::Vector2d::Zero();
  Eigen::Vector2d max = Eigen::Vector2d::Zero();
};

/// Result of find_blocked_cells.
struct BlockedCells {
  std::size_t count = 0;     ///< number of cells written
  bool outside_map = false;  ///< the region extends beyond the grid (cells may be written as well)
  bool in_zone = false;      ///< zones forbid the region (cells may be written as well)
};

/// Finds blocked cells at most `radius` [cells] from `box`. In every row that has any, it finds the
/// one nearest to `towards` in columns.
///
/// Writes the cells into `found` until it is full. Rows are visited in bands (BitGrid::kBandRows),
/// from the band of `towards` outwards. No skin is added. The part of the region outside the grid
/// is reported, but not searched.
///
/// The test is as exact as find_blocked_cell. Unless `found` is empty, no cell is written if and
/// only if there is none. Zones count as for a Disc. @pre the box is not empty and finite; radius
/// >= 0.
[[nodiscard]] BlockedCells find_blocked_cells(const BitGrid& obstacles,
                                              const TurnedBox& box,
                                              double radius,
                                              const Eigen::Vector2d& towards,
                                              std::span<CellIndex> found) noexcept;

/// Returns whether no blocked cell is at most `radius` [cells] from `box`. The region must also lie
/// in the grid, and no zone may forbid it for a Disc. No skin is added. @pre as find_blocked_cells.
[[nodiscard]] bool is_free(const BitGrid& obstacles, const TurnedBox& box, double radius) noexcept;

}  // namespace fairway
