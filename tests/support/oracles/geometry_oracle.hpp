// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "fairway/geometry/oriented_rectangle.hpp"
#include "fairway/map/bit_grid.hpp"

namespace fairway::test {

inline double distance_to_segment(const Eigen::Vector2d& p,
                                  const Eigen::Vector2d& a,
                                  const Eigen::Vector2d& b) {
  const Eigen::Vector2d d = b - a;
  const double squared = d.squaredNorm();
  const double t = squared > 0.0 ? std::clamp((p - a).dot(d) / squared, 0.0, 1.0) : 0.0;
  return (p - a - t * d).norm();
}

/// Distance between two closed rectangles, 0 when they overlap: tests corners against sides, and
/// for overlap containment and crossing.
inline double distance(const OrientedRectangle& a, const OrientedRectangle& b) {
  if (overlap(a, b).count > 0) return 0.0;
  const auto ca = a.corners();
  const auto cb = b.corners();
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      best = std::min(best, distance_to_segment(ca[i], cb[j], cb[(j + 1) % 4]));
      best = std::min(best, distance_to_segment(cb[j], ca[i], ca[(i + 1) % 4]));
    }
  }
  return best;
}

/// A cell as a rectangle in the world.
inline OrientedRectangle cell_rectangle(const GridFrame& frame, CellIndex cell) {
  return {.seed = frame.to_world({cell.x, cell.y}),
          .orientation = frame.origin.heading,
          .min = Eigen::Vector2d::Zero(),
          .max = Eigen::Vector2d::Constant(frame.resolution)};
}

/// Distance from the rectangle to the nearest blocked cell and to the outside of the grid [m]; 0
/// when it touches. Tests every cell.
inline double clearance(const BitGrid& obstacles, const OrientedRectangle& rectangle) {
  const GridFrame& frame = obstacles.frame();
  double best = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d& corner : rectangle.corners()) {
    const Eigen::Vector2d g = frame.to_grid(corner);
    best = std::min({best, g.x(), g.y(), frame.width - g.x(), frame.height - g.y()});
  }
  best = std::max(0.0, best * frame.resolution);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      if (obstacles.blocked({x, y})) {
        best = std::min(best, distance(rectangle, cell_rectangle(frame, {x, y})));
      }
    }
  }
  return best;
}

}  // namespace fairway::test
