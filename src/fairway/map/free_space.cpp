// SPDX-License-Identifier: Apache-2.0
#include "fairway/map/free_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fairway {

namespace {

using Eigen::Vector2d;

// A rectangle with round corners, in grid coordinates: all points within `radius` of it. As a
// convex set it meets a row of cells in an interval of x, so a row needs no more than two numbers.
struct RoundedRectangle {
  static constexpr double kRounding =
      1e-9;  // [cells]; the lowest height may round to just below an arc

  std::array<Vector2d, 4> corners;  // counter-clockwise
  double radius;

  // The largest x in the set at height y, if side = 1; minus the smallest, if side = -1. The
  // outline consists of arcs about the corners and of sides moved outward, so the best of these is
  // exact.
  // @pre some point of the set has this y.
  [[nodiscard]] double reach(double y, double side) const noexcept {
    double best = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector2d& a = corners[i];
      const double dy = y - a.y();
      if (std::abs(dy) <= radius + kRounding) {
        best = std::max(best, side * a.x() + std::sqrt(std::max(0.0, radius * radius - dy * dy)));
      }
      const Vector2d edge = corners[(i + 1) % 4] - a;
      if (edge.y() * side <= 0.0)
        continue;  // its outward normal (edge.y, -edge.x) points the other way
      const double length = edge.norm();
      const Vector2d moved = a + Vector2d(edge.y(), -edge.x()) * (radius / length);
      const double t = (y - moved.y()) / edge.y();
      if (t >= 0.0 && t <= 1.0) best = std::max(best, side * (moved.x() + t * edge.x()));
    }
    return best;
  }
};

}  // namespace

std::optional<CellIndex> find_blocked_cell(const BitGrid& obstacles,
                                           const OrientedRectangle& rectangle,
                                           double clearance) noexcept {
  // Written so that every non-finite number lands here too.
  if (rectangle.is_empty() || !(clearance >= 0.0)) return CellIndex{.x = -1, .y = -1};
  const GridFrame& frame = obstacles.frame();
  RoundedRectangle region{.corners = {}, .radius = (clearance + kFreeSpaceSkin) / frame.resolution};
  const std::array<Vector2d, 4> corners = rectangle.corners();
  Vector2d low = Vector2d::Constant(std::numeric_limits<double>::infinity());
  Vector2d high = -low;
  Vector2d leftmost;
  Vector2d rightmost;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector2d c = frame.to_grid(corners[i]);
    region.corners[i] = c;
    if (c.x() < low.x()) leftmost = c;
    if (c.x() > high.x()) rightmost = c;
    low = low.cwiseMin(c);
    high = high.cwiseMax(c);
  }
  low -= Vector2d::Constant(region.radius);
  high += Vector2d::Constant(region.radius);
  if (!(low.x() > 0.0 && low.y() > 0.0)) return CellIndex{.x = -1, .y = -1};
  if (!(high.x() < frame.width && high.y() < frame.height)) {
    return CellIndex{.x = frame.width, .y = frame.height};
  }
  const int last_row = static_cast<int>(high.y());
  for (int row = static_cast<int>(low.y()); row <= last_row; ++row) {
    // The outline's reach to either side is a concave function of y: over the row's closed strip it
    // is greatest at the height nearest to that of the outermost corner.
    const double bottom = std::max(static_cast<double>(row), low.y());
    const double top = std::min(static_cast<double>(row) + 1.0, high.y());
    const double right = region.reach(std::clamp(rightmost.y(), bottom, top), 1.0);
    const double left = -region.reach(std::clamp(leftmost.y(), bottom, top), -1.0);
    const int first = std::max(0, static_cast<int>(std::floor(left)));
    const int last = std::min(frame.width - 1, static_cast<int>(std::floor(right)));
    const int column = obstacles.first_blocked(row, first, last);
    if (column >= 0) return CellIndex{.x = column, .y = row};
  }
  return std::nullopt;
}

double distance_to_blocked(const BitGrid& obstacles,
                           const Eigen::Vector2d& point,
                           double limit) noexcept {
  const GridFrame& frame = obstacles.frame();
  const Vector2d g = frame.to_grid(point);
  const Vector2d size(frame.width, frame.height);
  // Written so that a point that is not finite lands here too.
  if (!((g.array() > 0.0).all() && (g.array() < size.array()).all())) return 0.0;
  double best = std::min({limit / frame.resolution, g.minCoeff(), (size - g).minCoeff()});
  const auto outside = [](double v, int cell) { return std::max({cell - v, v - cell - 1, 0.0}); };
  const auto nearest_in_row = [&](int y) {
    const double dy = outside(g.y(), y);
    if (dy >= best) return;
    const double reach = std::sqrt(best * best - dy * dy);
    const int last = std::min(frame.width - 1, static_cast<int>(g.x() + reach));
    int x = std::max(0, static_cast<int>(g.x() - reach) - 1);
    while ((x = obstacles.first_blocked(y, x, last)) >= 0) {
      best = std::min(best, std::hypot(outside(g.x(), x), dy));
      ++x;
    }
  };
  const int row = static_cast<int>(g.y());
  for (int away = 0; away - 1 < best; ++away) {
    if (row - away >= 0) nearest_in_row(row - away);
    if (away > 0 && row + away < frame.height) nearest_in_row(row + away);
  }
  return best * frame.resolution;
}

}  // namespace fairway
