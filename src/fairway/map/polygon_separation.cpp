// SPDX-License-Identifier: Apache-2.0
#include "fairway/map/polygon_separation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fairway::internal {

namespace {

using Eigen::Vector2d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

const Vector2d& next_vertex(const ConvexPart& part, int i) noexcept {
  return part.vertex(i + 1 == part.count ? 0 : i + 1);
}

// Finds the axis along which the two overlap least. They are apart along an axis exactly when the
// result is positive for it.
struct Overlap {
  double gap = -kInfinity;
  Vector2d normal = Vector2d::UnitX();
  bool of_polygon = false;  // whether the axis is normal to a side of the polygon

  void look(double gap_here, const Vector2d& direction) noexcept {
    if (gap_here <= gap) return;
    gap = gap_here;
    normal = direction;
  }
};

Overlap least_overlap(const ConvexPart& part, const Vector2d& low) noexcept {
  Overlap least;
  Vector2d least_corner = part.vertex(0);
  Vector2d most_corner = part.vertex(0);
  for (int i = 1; i < part.count; ++i) {
    least_corner = least_corner.cwiseMin(part.vertex(i));
    most_corner = most_corner.cwiseMax(part.vertex(i));
  }
  least.look(least_corner.x() - (low.x() + 1.0), Vector2d::UnitX());
  least.look(low.x() - most_corner.x(), -Vector2d::UnitX());
  least.look(least_corner.y() - (low.y() + 1.0), Vector2d::UnitY());
  least.look(low.y() - most_corner.y(), -Vector2d::UnitY());
  const Vector2d middle = low + Vector2d(0.5, 0.5);
  for (int i = 0; part.count > 1 && i < part.count; ++i) {
    const Vector2d edge = next_vertex(part, i) - part.vertex(i);
    const double length = edge.norm();
    if (length <= 0.0) continue;
    const Vector2d outward = Vector2d(edge.y(), -edge.x()) / length;
    const double reach = 0.5 * (std::abs(outward.x()) + std::abs(outward.y()));
    const double gap = (middle - part.vertex(i)).dot(outward) - reach;
    if (gap > least.gap) least.of_polygon = true;
    least.look(gap, -outward);
  }
  return least;
}

// Keeps the nearest pair of points, one of the polygon and one of the cell.
struct Nearest {
  double square = kInfinity;
  Vector2d of_polygon = Vector2d::Zero();
  Vector2d of_cell = Vector2d::Zero();

  void look(const Vector2d& p, const Vector2d& c) noexcept {
    const double distance = (p - c).squaredNorm();
    if (distance >= square) return;
    square = distance;
    of_polygon = p;
    of_cell = c;
  }
};

}  // namespace

Separation separation(const ConvexPart& part, CellIndex cell) noexcept {
  const Vector2d low(cell.x, cell.y);
  const Vector2d high = low + Vector2d(1.0, 1.0);
  const Overlap overlap = least_overlap(part, low);
  if (overlap.gap <= 0.0 && overlap.of_polygon) {
    // The corner of the cell that is deepest below the side, and its place on the side.
    const Vector2d inward = overlap.normal;
    const Vector2d corner(inward.x() > 0.0 ? high.x() : low.x(),
                          inward.y() > 0.0 ? high.y() : low.y());
    return {.distance = overlap.gap, .point = corner + overlap.gap * inward, .normal = inward};
  }
  if (overlap.gap <= 0.0) {
    Vector2d deepest = part.vertex(0);
    for (int i = 1; i < part.count; ++i) {
      if ((part.vertex(i) - deepest).dot(overlap.normal) < 0.0) deepest = part.vertex(i);
    }
    // Along the cell's face it is no further than the cell.
    const Vector2d beside = deepest.cwiseMax(low).cwiseMin(high);
    const Vector2d point = std::abs(overlap.normal.x()) > 0.5 ? Vector2d(deepest.x(), beside.y())
                                                              : Vector2d(beside.x(), deepest.y());
    return {.distance = overlap.gap, .point = point, .normal = overlap.normal};
  }
  // Apart: a vertex of one is nearest to a side of the other.
  Nearest nearest;
  for (int i = 0; i < part.count; ++i)
    nearest.look(part.vertex(i), part.vertex(i).cwiseMax(low).cwiseMin(high));
  const std::array<Vector2d, 4> corners{low, Vector2d(high.x(), low.y()), high,
                                        Vector2d(low.x(), high.y())};
  for (int i = 0; part.count > 1 && i < part.count; ++i) {
    const Vector2d edge = next_vertex(part, i) - part.vertex(i);
    const double square = edge.squaredNorm();
    if (square <= 0.0) continue;
    for (const Vector2d& corner : corners) {
      const double share = std::clamp((corner - part.vertex(i)).dot(edge) / square, 0.0, 1.0);
      nearest.look(part.vertex(i) + share * edge, corner);
    }
  }
  const double distance = std::sqrt(nearest.square);
  const Vector2d normal =
      distance > 0.0 ? Vector2d((nearest.of_polygon - nearest.of_cell) / distance) : overlap.normal;
  return {.distance = distance, .point = nearest.of_polygon, .normal = normal};
}

Separation separation(const ConvexPart& part, const Vector2d& a, const Vector2d& b) noexcept {
  // The axis along which the two overlap least; see least_overlap.
  Overlap overlap;
  const auto look_along = [&](const Vector2d& axis, bool of_polygon) {
    double polygon_low = kInfinity;
    for (int i = 0; i < part.count; ++i)
      polygon_low = std::min(polygon_low, part.vertex(i).dot(axis));
    const double gap = polygon_low - std::max(a.dot(axis), b.dot(axis));
    if (gap > overlap.gap) overlap.of_polygon = of_polygon;
    overlap.look(gap, axis);
  };
  const Vector2d along = b - a;
  if (along.squaredNorm() > 0.0) {
    const Vector2d side = Vector2d(along.y(), -along.x()).normalized();
    look_along(side, false);
    look_along(-side, false);
  }
  for (int i = 0; part.count > 1 && i < part.count; ++i) {
    const Vector2d edge = next_vertex(part, i) - part.vertex(i);
    if (edge.squaredNorm() > 0.0) look_along(Vector2d(-edge.y(), edge.x()).normalized(), true);
  }
  if (overlap.gap <= 0.0 && overlap.gap > -kInfinity) {
    Vector2d deepest = part.vertex(0);
    for (int i = 1; i < part.count; ++i) {
      if ((part.vertex(i) - deepest).dot(overlap.normal) < 0.0) deepest = part.vertex(i);
    }
    if (overlap.of_polygon) {
      const Vector2d& end = a.dot(overlap.normal) > b.dot(overlap.normal) ? a : b;
      deepest = end + overlap.gap * overlap.normal;
    }
    return {.distance = overlap.gap, .point = deepest, .normal = overlap.normal};
  }
  Nearest nearest;
  const auto nearest_on = [](const Vector2d& from, const Vector2d& to, const Vector2d& point) {
    const double square = (to - from).squaredNorm();
    if (square <= 0.0) return from;
    const double share = std::clamp((point - from).dot(to - from) / square, 0.0, 1.0);
    return Vector2d(from + share * (to - from));
  };
  for (int i = 0; i < part.count; ++i) {
    nearest.look(part.vertex(i), nearest_on(a, b, part.vertex(i)));
    for (const Vector2d& end : {a, b})
      nearest.look(nearest_on(part.vertex(i), next_vertex(part, i), end), end);
  }
  const double distance = std::sqrt(nearest.square);
  const Vector2d normal =
      distance > 0.0 ? Vector2d((nearest.of_polygon - nearest.of_cell) / distance) : overlap.normal;
  return {.distance = distance, .point = nearest.of_polygon, .normal = normal};
}

Columns columns_between(const ConvexPart& part, double low, double high) noexcept {
  Columns found{.left = kInfinity, .right = -kInfinity};
  const auto take = [&](double x) {
    found.left = std::min(found.left, x);
    found.right = std::max(found.right, x);
  };
  for (int i = 0; i < part.count; ++i) {
    const Vector2d& a = part.vertex(i);
    const Vector2d& b = next_vertex(part, i);
    if (a.y() >= low && a.y() <= high) take(a.x());
    for (const double y : {low, high}) {
      if ((a.y() < y) != (b.y() < y)) take(a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()));
    }
  }
  return found;
}

}  // namespace fairway::internal
