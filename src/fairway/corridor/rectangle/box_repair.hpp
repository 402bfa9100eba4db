// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "fairway/corridor/rectangle/obstacle_points.hpp"
#include "fairway/corridor/rectangle/turned_frame.hpp"

namespace fairway {

/// Some points of an obstacle, as offsets.
struct PointsInside {
  std::array<Eigen::Vector2d, 3> offsets{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(),
                                         Eigen::Vector2d::Zero()};
  std::size_t count = 0;

  void add(const Eigen::Vector2d& offset) noexcept { offsets[count++] = offset; }
  [[nodiscard]] const Eigen::Vector2d* begin() const noexcept { return offsets.data(); }
  [[nodiscard]] const Eigen::Vector2d* end() const noexcept { return offsets.data() + count; }
};

/// What to do with a box that turned out to hit obstacles: learn from them, or give way to them.
struct BoxRepair {
  const GridFrame& grid;
  const TurnedFrame& frame;
  const Box& core;  ///< what every box must hold
  double radius;    ///< of the disc that obstacles are grown by [cells]

  /// Points of the cell's configuration-space obstacle that lie in `box` if they meet: the one
  /// furthest from the box's sides, as far as that is easily found, and of a round corner others
  /// beside it.
  [[nodiscard]] PointsInside points_inside(CellIndex cell, const Box& box) const noexcept;

  /// Adds points of the outside of the map that lie in `box`.
  void add_outside_points(const Box& box, ObstaclePoints& points) const noexcept;

  /// Moves one side of `box` inwards, the one that costs least area, so that it clears the cell by
  /// a hair. Exact up to an eighth of a cell. @return false when no side can, as the core is in the
  /// way; the box is then unchanged.
  [[nodiscard]] bool pull_from(CellIndex cell, Box& box) const noexcept;

  /// The same for the outside of the map.
  [[nodiscard]] bool pull_into_map(Box& box) const noexcept;

 private:
  [[nodiscard]] Eigen::Vector2d point_of_side(const std::array<Eigen::Vector2d, 4>& corners,
                                              const Box& box) const noexcept;
};

}  // namespace fairway
