// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "fairway/base/fixed_vector.hpp"
#include "fairway/corridor/rectangle/obstacle_points.hpp"
#include "fairway/corridor/rectangle/turned_frame.hpp"

namespace fairway {

/// Points of an obstacle, as offsets.
using PointsInside = FixedVector<Eigen::Vector2d, 3>;

/// Handles a box that meets obstacles: learns points from them, or shrinks the box.
struct BoxRepair {
  const GridFrame& grid;
  const TurnedFrame& frame;
  const Box& core;  ///< what every box must contain
  double radius;    ///< radius of the disc by which obstacles are grown [cells]

  /// Returns points of the cell's configuration-space obstacle that lie in `box`. The first is the
  /// one furthest from the box's sides, as far as it is easily found; a round corner gives others
  /// beside it.
  [[nodiscard]] PointsInside points_inside(CellIndex cell, const Box& box) const noexcept;

  /// Adds points outside the map that lie in `box`.
  void add_outside_points(const Box& box, ObstaclePoints& points) const noexcept;

  /// Moves the side of `box` inwards that costs the least area, so that the box just clears the
  /// cell. The obstacle's outline is approximated within an eighth of a cell. @return false, and no
  /// change, if the core prevents it.
  [[nodiscard]] bool pull_from(CellIndex cell, Box& box) const noexcept;

  /// Moves sides of `box` inwards until it lies inside the map. @return false if the core prevents
  /// it.
  [[nodiscard]] bool pull_into_map(Box& box) const noexcept;

 private:
  [[nodiscard]] Eigen::Vector2d point_of_side(const std::array<Eigen::Vector2d, 4>& corners,
                                              const Box& box) const noexcept;
};

}  // namespace fairway
