// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>
#include <numbers>
#include <span>

#include "fairway/geometry/body_shape.hpp"
#include "support/random/random_world.hpp"

namespace fairway::test {

/// A body of every kind, about `size` long.
inline BodyShape random_body(Random& random, double size) {
  const int kind = random.integer(0, 2);
  if (kind == 0) {
    return BodyShape::rectangle(size * random.uniform(0.5, 2.0), size * random.uniform(0.2, 1.0),
                                size * random.uniform(-0.5, 1.5));
  }
  // Points of a circle are convex; one or two of them with a radius are a disc or a capsule.
  ConvexPart part;
  part.count = kind == 1 ? random.integer(3, 7) : random.integer(1, 2);
  part.radius = kind == 1 ? 0.0 : size * random.uniform(0.1, 0.4);
  for (int i = 0; i < part.count; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + random.uniform(0.0, 0.8)) / part.count;
    part.vertices[static_cast<std::size_t>(i)] =
        size * direction(angle) + Eigen::Vector2d(0.3 * size, 0.0);
  }
  const Expected<BodyShape> body = BodyShape::make(std::span<const ConvexPart>(&part, 1));
  return body ? *body : BodyShape::rectangle(size, size, 0.0);
}

/// Distance from a point in the body's frame to the body: of its parts' edges, or 0 inside.
inline double distance_to_part(const ConvexPart& part, const Eigen::Vector2d& point) {
  double least = std::numeric_limits<double>::infinity();
  bool inside = part.count > 2;
  for (int i = 0; i < part.count; ++i) {
    const Eigen::Vector2d& a = part.vertex(i);
    const Eigen::Vector2d edge = part.vertex((i + 1) % part.count) - a;
    const double square = std::max(edge.squaredNorm(), 1e-30);
    const double share = std::clamp((point - a).dot(edge) / square, 0.0, 1.0);
    least = std::min(least, (point - a - share * edge).norm());
    inside = inside && edge.x() * (point - a).y() - edge.y() * (point - a).x() >= 0.0;
  }
  return inside ? 0.0 : std::max(0.0, least - part.radius);
}

}  // namespace fairway::test
