// SPDX-License-Identifier: Apache-2.0
#include "fairway/geometry/oriented_rectangle.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/geometry/pose2.hpp"

namespace fairway {

using Eigen::Vector2d;

Vector2d OrientedRectangle::to_local(const Vector2d& point) const noexcept {
  return rotated(point - seed, -orientation);
}

Vector2d OrientedRectangle::to_world(const Vector2d& local) const noexcept {
  return seed + rotated(local, orientation);
}

bool OrientedRectangle::contains(const Vector2d& point, double tolerance) const noexcept {
  const Vector2d p = to_local(point);
  return !is_empty() && p.x() >= min.x() - tolerance && p.x() <= max.x() + tolerance &&
         p.y() >= min.y() - tolerance && p.y() <= max.y() + tolerance;
}

std::array<Vector2d, 4> OrientedRectangle::corners() const noexcept {
  return {to_world(min), to_world({max.x(), min.y()}), to_world(max), to_world({min.x(), max.y()})};
}

OrientedRectangle OrientedRectangle::shrunk(double offset) const noexcept {
  const Vector2d by(offset, offset);
  return {.seed = seed, .orientation = orientation, .min = min + by, .max = max - by};
}

Vector2d OrientedRectangle::nearest(const Vector2d& point) const noexcept {
  return to_world(to_local(point).cwiseMax(min).cwiseMin(max));
}

OrientedRectangle segment_rectangle(const Vector2d& a, const Vector2d& b) noexcept {
  const Vector2d d = b - a;
  return {.seed = a,
          .orientation = d.isZero(0.0) ? 0.0 : std::atan2(d.y(), d.x()),
          .min = Vector2d::Zero(),
          .max = Vector2d(d.norm(), 0.0)};
}

double OverlapPatch::area() const noexcept {
  double twice = 0.0;
  for (int i = 0; i < count; ++i) {
    const Vector2d& p = corners[static_cast<std::size_t>(i)];
    const Vector2d& q = corners[static_cast<std::size_t>((i + 1) % count)];
    // Coordinates relative to the first corner avoid cancellation far from the origin.
    const Vector2d a = p - corners[0];
    const Vector2d b = q - corners[0];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return std::max(0.0, 0.5 * twice);
}

Vector2d OverlapPatch::centroid() const noexcept {
  Vector2d weighted = Vector2d::Zero();
  Vector2d mean = Vector2d::Zero();
  double twice = 0.0;
  for (int i = 0; i < count; ++i) {
    const Vector2d a = corners[static_cast<std::size_t>(i)] - corners[0];
    const Vector2d b = corners[static_cast<std::size_t>((i + 1) % count)] - corners[0];
    const double cross = a.x() * b.y() - a.y() * b.x();
    weighted += cross * (a + b) / 3.0;
    mean += a / count;
    twice += cross;
  }
  constexpr double kNoArea = 1e-12;  // [m^2]; below this the quotient is dominated by rounding
  return corners[0] + (twice > kNoArea ? Vector2d(weighted / twice) : mean);
}

OverlapPatch overlap(const OrientedRectangle& a, const OrientedRectangle& b) noexcept {
  OverlapPatch patch;
  if (a.is_empty() || b.is_empty()) return patch;
  // Sutherland-Hodgman: each side of b in turn clips the corners of a, in b's frame. A rectangle
  // has 4 corners and each cut adds at most one.
  std::array<Vector2d, 8> polygon;
  int n = 0;
  for (const Vector2d& corner : a.corners())
    polygon[static_cast<std::size_t>(n++)] = b.to_local(corner);
  for (int side = 0; side < 4 && n > 0; ++side) {
    const int axis = side / 2;
    const bool lower = side % 2 == 0;
    const auto inside_by = [&](const Vector2d& p) {
      return lower ? p[axis] - b.min[axis] : b.max[axis] - p[axis];
    };
    std::array<Vector2d, 8> cut;
    int m = 0;
    for (int i = 0; i < n; ++i) {
      const Vector2d& p = polygon[static_cast<std::size_t>(i)];
      const Vector2d& q = polygon[static_cast<std::size_t>((i + 1) % n)];
      const double dp = inside_by(p);
      const double dq = inside_by(q);
      if (dp >= 0.0 && m < 8) cut[static_cast<std::size_t>(m++)] = p;
      if ((dp >= 0.0) != (dq >= 0.0) && m < 8) {
        cut[static_cast<std::size_t>(m++)] = p + (q - p) * (dp / (dp - dq));
      }
    }
    polygon = cut;
    n = m;
  }
  for (int i = 0; i < n; ++i) {
    patch.corners[static_cast<std::size_t>(i)] = b.to_world(polygon[static_cast<std::size_t>(i)]);
  }
  patch.count = n;
  return patch;
}

}  // namespace fairway
