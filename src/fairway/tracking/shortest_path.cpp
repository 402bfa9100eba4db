// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/shortest_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/base/contract.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) noexcept {
  return a.x() * b.y() - a.y() * b.x();
}

// Returns the part of the segment a -> b inside the convex patch, as parameters. It is empty if
// first > second.
struct Crossing {
  double first = 0.0;
  double second = 1.0;
};

Crossing cross_patch(const OverlapPatch& patch, const Vector2d& a, const Vector2d& b) noexcept {
  Crossing t;
  const Vector2d d = b - a;
  for (int i = 0; i < patch.count; ++i) {
    const Vector2d& p = patch.corners[static_cast<std::size_t>(i)];
    const Vector2d edge = patch.corners[static_cast<std::size_t>((i + 1) % patch.count)] - p;
    const double inside = cross(edge, a - p);  // >= 0 on the inner side of a counter-clockwise edge
    const double rate = cross(edge, d);
    if (rate > 0.0) {
      t.first = std::max(t.first, -inside / rate);
    } else if (rate < 0.0) {
      t.second = std::min(t.second, -inside / rate);
    } else if (inside < 0.0) {
      return {.first = 1.0, .second = 0.0};
    }
  }
  return t;
}

// Returns the point of the segment p -> q with the shortest path from a over it to b. If a and b
// are on the same side, mirroring b makes that path a straight line.
Vector2d shortest_touch_on_edge(const Vector2d& p,
                                const Vector2d& q,
                                const Vector2d& a,
                                const Vector2d& b) noexcept {
  const Vector2d edge = q - p;
  const double length = edge.norm();
  if (length <= 0.0) return p;
  const Vector2d along = edge / length;
  const double ha = std::abs(cross(along, a - p));
  const double hb = std::abs(cross(along, b - p));
  const double sa = along.dot(a - p);
  const double sb = along.dot(b - p);
  const double s = ha + hb > 0.0 ? sa + (sb - sa) * ha / (ha + hb) : 0.5 * (sa + sb);
  return p + along * std::clamp(s, 0.0, length);
}

}  // namespace

Vector2d shortest_touch(const OverlapPatch& patch, const Vector2d& a, const Vector2d& b) noexcept {
  FAIRWAY_EXPECTS(patch.count > 0);
  const Crossing t = cross_patch(patch, a, b);
  if (t.first <= t.second) return a + 0.5 * (t.first + t.second) * (b - a);
  double best = std::numeric_limits<double>::infinity();
  Vector2d touch = patch.corners[0];
  for (int i = 0; i < patch.count; ++i) {
    const Vector2d candidate = shortest_touch_on_edge(
        patch.corners[static_cast<std::size_t>(i)],
        patch.corners[static_cast<std::size_t>((i + 1) % patch.count)], a, b);
    const double sum = (candidate - a).norm() + (b - candidate).norm();
    if (sum < best) {
      best = sum;
      touch = candidate;
    }
  }
  return touch;
}

void shorten_in_patches(std::span<const OverlapPatch> patches,
                        const Vector2d& start,
                        const Vector2d& end,
                        std::span<Vector2d> points,
                        int sweeps) noexcept {
  FAIRWAY_EXPECTS(points.size() == patches.size());
  const std::size_t n = points.size();
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t i = 0; i < n; ++i) {
      const Vector2d& before = i == 0 ? start : points[i - 1];
      const Vector2d& after = i + 1 == n ? end : points[i + 1];
      points[i] = shortest_touch(patches[i], before, after);
    }
  }
}

}  // namespace fairway
