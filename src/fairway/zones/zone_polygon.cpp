// SPDX-License-Identifier: Apache-2.0
#include "fairway/zones/zone_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fairway {

namespace {

using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) noexcept {
  return a.x() * b.y() - a.y() * b.x();
}

// A box, and a segment in its frame.
bool segment_meets_box(const Vector2d& a,
                       const Vector2d& b,
                       const Vector2d& low,
                       const Vector2d& high) noexcept {
  double first = 0.0;
  double last = 1.0;
  const Vector2d along = b - a;
  for (int axis = 0; axis < 2; ++axis) {
    if (along[axis] == 0.0) {
      if (a[axis] < low[axis] || a[axis] > high[axis]) return false;
      continue;
    }
    const double s = (low[axis] - a[axis]) / along[axis];
    const double t = (high[axis] - a[axis]) / along[axis];
    first = std::max(first, std::min(s, t));
    last = std::min(last, std::max(s, t));
  }
  return first <= last;
}

double distance_to_box(const Vector2d& p, const Vector2d& low, const Vector2d& high) noexcept {
  return (p - p.cwiseMax(low).cwiseMin(high)).norm();
}

// Whether two closed segments have a common point.
bool segments_meet(const Segment& p, const Segment& q) noexcept {
  const Vector2d d = p.b - p.a;
  const Vector2d e = q.b - q.a;
  const double qa = cross(d, q.a - p.a);
  const double qb = cross(d, q.b - p.a);
  const double pa = cross(e, p.a - q.a);
  const double pb = cross(e, p.b - q.a);
  if (((qa > 0.0 && qb < 0.0) || (qa < 0.0 && qb > 0.0)) &&
      ((pa > 0.0 && pb < 0.0) || (pa < 0.0 && pb > 0.0))) {
    return true;
  }
  return distance(p, q.a) == 0.0 || distance(p, q.b) == 0.0 || distance(q, p.a) == 0.0 ||
         distance(q, p.b) == 0.0;
}

}  // namespace

Extent extent_of(const OrientedRectangle& rectangle) noexcept {
  Extent extent;
  for (const Vector2d& corner : rectangle.corners())
    extent.include(corner);
  return extent;
}

Extent extent_of(const Segment& segment) noexcept {
  Extent extent;
  extent.include(segment.a);
  extent.include(segment.b);
  return extent;
}

double distance(const Segment& segment, const Vector2d& point) noexcept {
  const Vector2d along = segment.b - segment.a;
  const double squared = along.squaredNorm();
  const double share =
      squared > 0.0 ? std::clamp((point - segment.a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (segment.a + share * along - point).norm();
}

double distance(const Segment& segment, const OrientedRectangle& rectangle) noexcept {
  const Vector2d a = rectangle.to_local(segment.a);
  const Vector2d b = rectangle.to_local(segment.b);
  const Vector2d& low = rectangle.min;
  const Vector2d& high = rectangle.max;
  if (segment_meets_box(a, b, low, high)) return 0.0;
  double least = std::min(distance_to_box(a, low, high), distance_to_box(b, low, high));
  const Segment local{.a = a, .b = b};
  for (const Vector2d& corner :
       {low, high, Vector2d(low.x(), high.y()), Vector2d(high.x(), low.y())})
    least = std::min(least, distance(local, corner));
  return least;
}

ZonePolygon::ZonePolygon(std::vector<Vector2d> corners) : corners_(std::move(corners)) {
  for (const Vector2d& corner : corners_)
    extent_.include(corner);
}

bool ZonePolygon::contains(const Vector2d& point) const noexcept {
  bool inside = false;
  const std::size_t n = corners_.size();
  for (std::size_t i = 0, j = n - 1; i < n; j = i++) {
    const Vector2d& a = corners_[i];
    const Vector2d& b = corners_[j];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const double x = a.x() + (b.x() - a.x()) * ((point.y() - a.y()) / (b.y() - a.y()));
    if (point.x() < x) inside = !inside;
  }
  return inside;
}

double ZonePolygon::signed_distance(const Vector2d& point) const noexcept {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < size(); ++i)
    least = std::min(least, distance(edge(i), point));
  return contains(point) ? -least : least;
}

bool ZonePolygon::is_near(const OrientedRectangle& rectangle, double clearance) const noexcept {
  if (!extent_.near(extent_of(rectangle), clearance)) return false;
  for (std::size_t i = 0; i < size(); ++i) {
    if (distance(edge(i), rectangle) <= clearance) return true;
  }
  return contains(rectangle.center());
}

double ZonePolygon::area() const noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < size(); ++i) {
    const Segment s = edge(i);
    sum += cross(s.a - corners_[0], s.b - corners_[0]);
  }
  return 0.5 * std::abs(sum);
}

bool ZonePolygon::is_simple() const noexcept {
  for (std::size_t i = 0; i < size(); ++i) {
    const Segment first = edge(i);
    const Extent around = extent_of(first);
    if ((first.b - first.a).norm() == 0.0) return false;
    // Neighbours share a corner; they must not fold back.
    const Segment next = edge((i + 1) % size());
    if (cross(first.b - first.a, next.b - next.a) == 0.0 &&
        (first.b - first.a).dot(next.b - next.a) < 0.0) {
      return false;
    }
    for (std::size_t j = i + 2; j < size(); ++j) {
      if (i == 0 && j + 1 == size()) continue;
      const Segment second = edge(j);
      if (around.near(extent_of(second), 0.0) && segments_meet(first, second)) return false;
    }
  }
  return true;
}

std::optional<double> crossing(const Segment& line, const Segment& other) noexcept {
  const Vector2d along = line.b - line.a;
  const Vector2d e = other.b - other.a;
  const double det = cross(along, e);
  if (det == 0.0) return std::nullopt;
  const Vector2d offset = other.a - line.a;
  const double share = cross(offset, e) / det;
  const double place = cross(offset, along) / det;
  if (!(share > 0.0 && share < 1.0 && place >= 0.0 && place <= 1.0)) return std::nullopt;
  return share;
}

void add_crossings(const Segment& line, const Segment& other, std::vector<double>& shares) {
  const Vector2d along = line.b - line.a;
  const Vector2d e = other.b - other.a;
  const double length = along.norm();
  if (length == 0.0) return;
  const auto add = [&](double share) {
    if (share > 0.0 && share < 1.0) shares.push_back(share);
  };
  constexpr double kParallel = 1e-12;
  const double det = cross(along, e);
  // Where `other` begins and ends beside the line: nearly parallel ones change sides there.
  add((other.a - line.a).dot(along) / (length * length));
  add((other.b - line.a).dot(along) / (length * length));
  if (std::abs(det) <= kParallel * length * e.norm()) return;
  const Vector2d offset = other.a - line.a;
  const double place = cross(offset, along) / det;
  if (place >= -kParallel && place <= 1.0 + kParallel) add(cross(offset, e) / det);
}

}  // namespace fairway
