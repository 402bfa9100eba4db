// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/path/path.hpp"

namespace fairway {

/// Returns the first `length` metres of a path, or all of a shorter path. @pre length >= 0.
[[nodiscard]] inline Path beginning_of(const Path& path, double length) {
  Path part;
  for (const Eigen::Vector2d& point : path.waypoints) {
    if (!part.waypoints.empty()) {
      const Eigen::Vector2d last = part.waypoints.back();
      const double piece = (point - last).norm();
      if (piece > length) {
        part.waypoints.emplace_back(last + length / piece * (point - last));
        break;
      }
      length -= piece;
    }
    part.waypoints.push_back(point);
  }
  return part;
}

}  // namespace fairway
