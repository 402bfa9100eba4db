// SPDX-License-Identifier: Apache-2.0
#include "bridge/path_strips.hpp"

namespace fairway::bridge {

namespace {

using Eigen::Vector2d;

// Returns the index of the last waypoint to which a straight line from `first` stays near all
// waypoints between them.
std::size_t end_of_line(const std::vector<Vector2d>& points, std::size_t first) noexcept {
  constexpr double kNear = 0.02;  // [m]
  std::size_t last = first + 1;
  for (std::size_t end = first + 2; end < points.size(); ++end) {
    const Vector2d line = points[end] - points[first];
    const double length = line_length(line);
    for (std::size_t i = first + 1; i < end; ++i) {
      const Vector2d from_first = points[i] - points[first];
      const double along = from_first.dot(line);
      const double across = line.x() * from_first.y() - line.y() * from_first.x();
      const bool returns = length < kNear && line_length(from_first) > 2.0 * kNear;
      if (returns || along < 0.0 || along > length * length || std::abs(across) > kNear * length)
        return last;
    }
    last = end;
  }
  return last;
}

}  // namespace

Zones strips_along(const Path& path, double bound) {
  constexpr double kShortest = 1e-3;  // [m]
  const std::vector<Vector2d>& points = path.waypoints;
  Zones strips;
  for (std::size_t first = 0; first + 1 < points.size();) {
    const std::size_t last = end_of_line(points, first);
    const Vector2d line = points[last] - points[first];
    const double length = line_length(line);
    const Vector2d ahead = length > kShortest ? Vector2d(line / length) : Vector2d(1.0, 0.0);
    const Vector2d left(-ahead.y(), ahead.x());
    const Vector2d low = points[first] - bound * ahead;
    const Vector2d high = points[last] + bound * ahead;
    strips.push_back({.kind = ZoneKind::Strip,
                      .polygon = {low - bound * left, high - bound * left, high + bound * left,
                                  low + bound * left},
                      .reference = ZoneReference::Centre,
                      .name = "path"});
    first = last;
  }
  return strips;
}

}  // namespace fairway::bridge
