// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>

#include "fairway/map/bit_grid.hpp"
#include "fairway/map/distance_field.hpp"
#include "fairway/path/path.hpp"

namespace fairway {

/// What a metre costs a disc robot, cell by cell, and where it fits at all.
///
/// With room d [m] between a cell's centre and the nearest obstacle and r = radius + margin, a
/// metre in that cell costs 1 + comfort_weight * max(0, 1 - (d - r) / comfort_distance), at most 1
/// + comfort_weight; a line costs the integral over the cells it crosses. A cell is *allowed* when
/// a disc of radius r is free at its centre (is_free holds there).
class TravelCost {
 public:
  /// Reads both maps for as long as it lives.
  /// @pre required = radius + margin >= 0 [m]; both maps have the same frame.
  TravelCost(const BitGrid& obstacles,
             const DistanceField& distances,
             double required,
             const PathSettings& settings);

  [[nodiscard]] const GridFrame& frame() const noexcept { return obstacles_.frame(); }
  [[nodiscard]] const BitGrid& obstacles() const noexcept { return obstacles_; }
  [[nodiscard]] const DistanceField& distances() const noexcept { return distances_; }
  [[nodiscard]] double required() const noexcept { return required_; }

  /// Least distance of an allowed cell [m].
  [[nodiscard]] float least_distance() const noexcept { return allowed_; }
  [[nodiscard]] bool is_allowed(CellIndex cell) const noexcept {
    return distances_.at(cell) >= static_cast<double>(allowed_);
  }

  /// Cost of a metre at distance `d` from the nearest obstacle.
  [[nodiscard]] float at_distance(float d) const noexcept {
    const float cost = at_zero_ - rise_ * d;
    return std::min(std::max(cost, 1.0F), dearest_);
  }
  [[nodiscard]] float dearest() const noexcept { return dearest_; }  ///< the most a metre can cost
  [[nodiscard]] float rise() const noexcept { return rise_; }        ///< per metre nearer [1/m]

  /// Whether moves between allowed diagonal neighbours need `diagonal_is_free` at all. Moves
  /// between allowed neighbours that share a side are always free.
  [[nodiscard]] bool diagonals_need_checks() const noexcept { return corner_ >= 0; }

  /// Whether the robot fits along the way from the centre of an allowed cell to that of its allowed
  /// diagonal neighbour at (dx, dy).
  [[nodiscard]] bool diagonal_is_free(CellIndex cell, int dx, int dy) const noexcept {
    if (corner_ < 0) return true;
    const int near = corner_;
    const int far = corner_ + 1;
    return !obstacles_.blocked({.x = cell.x + dx * far, .y = cell.y - dy * near}) &&
           !obstacles_.blocked({.x = cell.x - dx * near, .y = cell.y + dy * far});
  }

  /// What a straight line costs.
  struct Line {
    double cost = std::numeric_limits<double>::infinity();  ///< [cells]
    bool roomy = false;  ///< so far from everything that the robot fits without a closer look
  };

  /// The straight line between two points in grid coordinates. Costs infinitely much when it
  /// exceeds `limit` and when an end is off the map. Does not ask whether the robot fits.
  [[nodiscard]] Line line(const Eigen::Vector2d& a,
                          const Eigen::Vector2d& b,
                          double limit = std::numeric_limits<double>::infinity()) const noexcept;

  /// Whether the robot fits along such a line, exactly.
  [[nodiscard]] bool fits(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const noexcept;

 private:
  const BitGrid& obstacles_;
  const DistanceField& distances_;
  double required_;
  float allowed_;
  float roomy_;    // least distance at the centre of a cell that leaves room all over it [m]
  float at_zero_;  // cost where the straight slope of costs meets distance 0
  float rise_;
  float dearest_;
  int corner_;
};

}  // namespace fairway
