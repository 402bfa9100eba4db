// SPDX-License-Identifier: Apache-2.0
#include "fairway/monitor/guarded_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fairway {

bool is_polygon(const Polygon& polygon) noexcept {
  constexpr double kFurthest = 100.0;  // corner from the robot [m]
  const auto bad = [](const Eigen::Vector2d& corner) {
    return !(corner.cwiseAbs().maxCoeff() <= kFurthest && corner.allFinite());
  };
  return polygon.size() >= 3 && std::none_of(polygon.begin(), polygon.end(), bad) &&
         std::adjacent_find(polygon.begin(), polygon.end()) == polygon.end() &&
         polygon.front() != polygon.back();
}

double signed_distance(const Polygon& polygon, const Eigen::Vector2d& point) noexcept {
  double least = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d from = polygon[i] - point;
    const Eigen::Vector2d to = polygon[(i + 1) % polygon.size()] - point;
    const Eigen::Vector2d edge = to - from;
    const double share = std::clamp(-from.dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (from + share * edge).norm());
    if ((from.y() > 0.0) != (to.y() > 0.0) && from.x() - from.y() * edge.x() / edge.y() > 0.0)
      inside = !inside;
  }
  return inside ? -least : least;
}

}  // namespace fairway
