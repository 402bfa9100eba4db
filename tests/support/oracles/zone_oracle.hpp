// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <Eigen/Core>

#include "fairway/geometry/oriented_rectangle.hpp"
#include "fairway/zones/zones.hpp"
#include "support/random/random_world.hpp"

namespace fairway::test {

using Corners = std::vector<Eigen::Vector2d>;

/// Whether a point lies in a polygon, by the angle that the polygon turns around it.
inline bool winds_around(const Corners& polygon, const Eigen::Vector2d& point) {
  double turned = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d a = polygon[i] - point;
    const Eigen::Vector2d b = polygon[(i + 1) % polygon.size()] - point;
    turned += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return std::abs(turned) > std::numbers::pi;
}

/// Distance from a point to the outline of a polygon, by its foot on every edge.
inline double distance_to_outline(const Corners& polygon, const Eigen::Vector2d& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    const double length = (b - a).norm();
    const Eigen::Vector2d along = (b - a) / length;
    const double foot = along.dot(point - a);
    if (foot >= 0.0 && foot <= length) {
      least = std::min(least, std::abs(along.x() * (point - a).y() - along.y() * (point - a).x()));
    }
    least = std::min(least, (point - a).norm());
  }
  return least;
}

/// How deep a point is in a polygon; negative outside [m].
inline double depth_in(const Corners& polygon, const Eigen::Vector2d& point) {
  const double distance = distance_to_outline(polygon, point);
  return winds_around(polygon, point) ? distance : -distance;
}

/// A random simple polygon around a centre, seldom convex, in either direction.
inline Corners random_polygon(Random& random, const Eigen::Vector2d& center, double size) {
  Corners corners;
  const int count = random.integer(3, 9);
  const double first = random.uniform(0.0, 6.0);
  for (int i = 0; i < count; ++i) {
    const double angle = first + 2.0 * std::numbers::pi * (i + random.uniform(0.0, 0.8)) / count;
    corners.emplace_back(center + random.uniform(0.3, 1.0) * size *
                                      Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  if (random.chance(0.5)) corners = Corners(corners.rbegin(), corners.rend());
  return corners;
}

/// The rectangle about a straight line, `side` [m] to either side and lengthened by `beyond` [m].
inline Corners strip_about(
    const Eigen::Vector2d& a, const Eigen::Vector2d& b, double left, double right, double beyond) {
  const Eigen::Vector2d along = (b - a).normalized();
  const Eigen::Vector2d across(-along.y(), along.x());
  const Eigen::Vector2d from = a - beyond * along;
  const Eigen::Vector2d to = b + beyond * along;
  return {from - right * across, to - right * across, to + left * across, from + left * across};
}

/// Points of a rectangle at most `spacing` [m] apart, its corners included.
inline Corners points_of(const OrientedRectangle& rectangle, double spacing) {
  Corners points;
  const Eigen::Vector2d size = rectangle.max - rectangle.min;
  const int nx = 1 + static_cast<int>(size.x() / spacing);
  const int ny = 1 + static_cast<int>(size.y() / spacing);
  for (int i = 0; i <= nx; ++i) {
    for (int j = 0; j <= ny; ++j) {
      points.push_back(rectangle.to_world(
          rectangle.min + size.cwiseProduct(Eigen::Vector2d(static_cast<double>(i) / nx,
                                                            static_cast<double>(j) / ny))));
    }
  }
  return points;
}

}  // namespace fairway::test
