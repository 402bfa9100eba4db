// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>

#include "fairway/map/bit_grid.hpp"
#include "fairway/map/distance_field.hpp"
#include "fairway/path/path.hpp"

namespace fairway {

/// Defines the cost of a metre for a disc robot, cell by cell, and the cells in which it fits.
///
/// Let d be the distance from a cell's centre to the nearest obstacle and r = radius + margin [m].
/// A metre in that cell costs 1 + comfort_weight * max(0, 1 - (d - r) / comfort_distance), at most
/// 1 + comfort_weight. A line costs the integral over the cells it crosses. A cell is *allowed* if
/// a disc of radius r is free at its centre (is_free holds there).
///
/// Zones of the map add their cost of a metre (ZoneMap::cost_at), exactly for lines. One-way zones
/// forbid lines against their direction.
class TravelCost {
 public:
  /// Keeps references to both maps, which must outlive this object.
  /// @pre required = radius + margin >= 0 [m]; both maps have the same frame.
  TravelCost(const BitGrid& obstacles,
             const DistanceField& distances,
             double required,
             const PathSettings& settings);

  [[nodiscard]] const GridFrame& frame() const noexcept { return obstacles_.frame(); }
  [[nodiscard]] const BitGrid& obstacles() const noexcept { return obstacles_; }
  [[nodiscard]] const DistanceField& distances() const noexcept { return distances_; }
  [[nodiscard]] double required() const noexcept { return required_; }

  /// Least distance to obstacles at the centre of an allowed cell [m].
  [[nodiscard]] float least_distance() const noexcept { return allowed_; }
  [[nodiscard]] bool is_allowed(CellIndex cell) const noexcept {
    return distances_.at(cell) >= static_cast<double>(allowed_);
  }

  /// Cost of a metre at distance `d` [m] from the nearest obstacle.
  [[nodiscard]] float at_distance(float d) const noexcept {
    const float cost = at_zero_ - rise_ * d;
    return std::min(std::max(cost, 1.0F), greatest_at_distance_);
  }
  /// The greatest cost of a metre.
  [[nodiscard]] float greatest_cost() const noexcept { return greatest_cost_; }
  /// Cost of a metre at the centre of a cell, with `distance` [m] to the nearest obstacle.
  [[nodiscard]] float at_cell(CellIndex cell, float distance) const noexcept {
    const float cost = at_distance(distance);
    return zone_costs_ == nullptr ? cost : cost + zone_cost(cell);
  }

  /// Whether zones make places or directions differ in cost, so that a coarse search would choose
  /// wrong.
  [[nodiscard]] bool needs_fine_search() const noexcept { return zone_costs_ != nullptr; }
  /// Whether moves between allowed neighbours need `step_fits`, because of zones.
  [[nodiscard]] bool steps_need_checks() const noexcept { return steps_need_checks_; }
  /// Whether zones allow to move from the centre of a cell to that of a neighbour.
  [[nodiscard]] bool step_fits(CellIndex from, CellIndex to) const noexcept;

  /// The numbers on which the cost of a cell depends, beside its distance.
  struct Scale {
    float allowed = 0.0F;
    float at_zero = 0.0F;
    float rise = 0.0F;
    float greatest = 0.0F;
    [[nodiscard]] bool operator==(const Scale&) const noexcept = default;
  };
  [[nodiscard]] Scale scale() const noexcept {
    return {.allowed = allowed_, .at_zero = at_zero_, .rise = rise_, .greatest = greatest_cost_};
  }

  /// Increase of the cost per metre closer to an obstacle [1/m].
  [[nodiscard]] float rise() const noexcept { return rise_; }

  /// Returns whether moves between allowed diagonal neighbours need `diagonal_is_free`. Moves
  /// between allowed neighbours that share a side are always free.
  [[nodiscard]] bool diagonals_need_checks() const noexcept { return corner_ >= 0; }

  /// Returns whether the robot can move diagonally between the centres of two allowed cells. The
  /// cells are `cell` and the one at (dx, dy).
  [[nodiscard]] bool diagonal_is_free(CellIndex cell, int dx, int dy) const noexcept {
    if (corner_ < 0) return true;
    const int near = corner_;
    const int far = corner_ + 1;
    return !obstacles_.blocked({.x = cell.x + dx * far, .y = cell.y - dy * near}) &&
           !obstacles_.blocked({.x = cell.x - dx * near, .y = cell.y + dy * far});
  }

  /// Whether a straight motion between two points in grid coordinates goes against a one-way zone.
  [[nodiscard]] bool goes_against_zone(const Eigen::Vector2d& from,
                                       const Eigen::Vector2d& to) const noexcept;

  /// The cost of a straight line.
  struct Line {
    double cost = std::numeric_limits<double>::infinity();  ///< [cells]
    /// So far from all obstacles that the robot fits along it without the exact test.
    bool surely_free = false;
  };

  /// Computes the cost of the line from one point to another in grid coordinates. The cost is
  /// infinite if it exceeds `limit` or an end lies outside the map. Whether the robot fits is not
  /// tested.
  [[nodiscard]] Line line(const Eigen::Vector2d& a,
                          const Eigen::Vector2d& b,
                          double limit = std::numeric_limits<double>::infinity()) const noexcept;

  /// As `line`, but the cost is also infinite where a cell shows that the robot does not fit.
  [[nodiscard]] Line fitting_line(
      const Eigen::Vector2d& a,
      const Eigen::Vector2d& b,
      double limit = std::numeric_limits<double>::infinity()) const noexcept;

  /// Tests exactly whether the robot fits along a line from one point to another in grid
  /// coordinates.
  [[nodiscard]] bool fits(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const noexcept;

 private:
  // The cost is infinite, too, if a cell on the line is closer to an obstacle than `floor` [m].
  [[nodiscard]] Line line_above(float floor,
                                const Eigen::Vector2d& a,
                                const Eigen::Vector2d& b,
                                double limit) const noexcept;
  [[nodiscard]] Line line_by_distance(float floor,
                                      const Eigen::Vector2d& a,
                                      const Eigen::Vector2d& b,
                                      double limit) const noexcept;
  [[nodiscard]] float zone_cost(CellIndex cell) const noexcept;

  const BitGrid& obstacles_;
  const DistanceField& distances_;
  double required_;
  float allowed_;
  float surely_free_distance_;  // least distance at the centre of a cell that is free all over [m]
  float surely_blocked_distance_;  // of a centre, below which no point of its cell is free [m]
  float easy_distance_;            // beyond it a metre costs 1 and is surely free [m]
  double cells_per_metre_;
  float at_zero_;  // cost that the linear increase extrapolates to at distance 0
  float rise_;
  float greatest_at_distance_;
  float greatest_cost_;
  int corner_;
  const ZoneMap* zone_costs_ = nullptr;  // of the map, where they have costs or directions
  bool steps_need_checks_ = false;
};

}  // namespace fairway
