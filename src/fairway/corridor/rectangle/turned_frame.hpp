// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "fairway/corridor/rectangle/box.hpp"
#include "fairway/map/free_space.hpp"

namespace fairway {

/// A frame in which a rectangle is an axis-parallel box: origin in grid coordinates, x-axis along a
/// unit vector. Lengths in cells; "offset" means relative to the origin, not turned.
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

/// Room that searches keep beyond what is_free asks [cells], so that rounding on the way to world
/// coordinates (below 1e-9 cells) cannot turn a region that they found free into a blocked one.
inline constexpr double kSearchSkin = 1e-6;

/// The radius for tests in grid coordinates [cells] that makes a region free for `clearance` [m].
[[nodiscard]] inline double search_radius(const GridFrame& frame, double clearance) noexcept {
  return (clearance + kFreeSpaceSkin) / frame.resolution + kSearchSkin;
}

/// The box as a rectangle in the world, seed at the frame's origin.
[[nodiscard]] inline OrientedRectangle to_world(const GridFrame& grid,
                                                const TurnedFrame& frame,
                                                const Box& box) noexcept {
  return {.seed = grid.to_world(frame.origin),
          .orientation = grid.origin.heading + std::atan2(frame.along.y(), frame.along.x()),
          .min = box.min * grid.resolution,
          .max = box.max * grid.resolution};
}

}  // namespace fairway
