// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/map/body_clearance.hpp"

namespace fairway {

/// A lower bound of the distance that a body's reference point travels to a point, around the
/// obstacles.
///
/// A disc about the reference that lies inside the body must fit everywhere: the body may not.
/// Computed once per target by Dijkstra's algorithm on cells of several cells of the map, which are
/// free as soon as the disc may fit anywhere in them.
class GoalDistance {
 public:
  GoalDistance(const BodyClearance& clearance, const Eigen::Vector2d& target);

  /// [m]; infinite where no path leads from, and outside the map.
  [[nodiscard]] double at(const Eigen::Vector2d& point) const noexcept;

 private:
  GridFrame frame_;             // of the large cells
  std::vector<float> lengths_;  // upper estimates by eight neighbours [m]
};

}  // namespace fairway
