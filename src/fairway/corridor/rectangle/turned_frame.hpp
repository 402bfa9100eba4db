// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "fairway/corridor/rectangle/box.hpp"
#include "fairway/map/free_space.hpp"

namespace fairway {

/// A frame in which a rectangle is an axis-parallel box. Its origin is in grid coordinates and its
/// x-axis is a unit vector. Lengths are in cells; an "offset" is relative to the origin, but not
/// turned.
struct TurnedFrame {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  Eigen::Vector2d along = Eigen::Vector2d::UnitX();

  [[nodiscard]] Eigen::Vector2d turned(const Eigen::Vector2d& offset) const noexcept {
    return {along.x() * offset.x() + along.y() * offset.y(),
            along.x() * offset.y() - along.y() * offset.x()};
  }

  [[nodiscard]] Eigen::Vector2d offset(const Eigen::Vector2d& turned) const noexcept {
    return {along.x() * turned.x() - along.y() * turned.y(),
            along.y() * turned.x() + along.x() * turned.y()};
  }

  [[nodiscard]] TurnedBox region(const Box& box) const noexcept {
    return {.origin = origin, .along = along, .min = box.min, .max = box.max};
  }
};

/// Clearance that searches add to that of is_free [cells]. Rounding in the transform to world
/// coordinates (below 1e-9 cells) then cannot turn a region found free into a blocked one.
inline constexpr double kSearchSkin = 1e-6;

/// Returns the radius for tests in grid coordinates [cells] that makes a region free for
/// `clearance` [m].
[[nodiscard]] inline double search_radius(const GridFrame& frame, double clearance) noexcept {
  return (clearance + kFreeSpaceSkin) / frame.resolution + kSearchSkin;
}

/// Converts the box to a rectangle in the world, with its seed at the frame's origin.
[[nodiscard]] inline OrientedRectangle to_world(const GridFrame& grid,
                                                const TurnedFrame& frame,
                                                const Box& box) noexcept {
  return {.seed = grid.to_world(frame.origin),
          .orientation = grid.origin.heading + std::atan2(frame.along.y(), frame.along.x()),
          .min = box.min * grid.resolution,
          .max = box.max * grid.resolution};
}

}  // namespace fairway
