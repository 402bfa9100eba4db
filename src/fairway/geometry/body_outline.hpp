// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <numbers>
#include <span>
#include <vector>

#include "fairway/geometry/body_shape.hpp"
#include "fairway/geometry/pose2.hpp"

namespace fairway {

/// The outline of one part of a body as a polygon, counter-clockwise; round corners get many
/// vertices on them.
[[nodiscard]] inline std::vector<Eigen::Vector2d> outline_of(const ConvexPart& part) {
  constexpr int kCorners = 32;  // of a rounded part
  const auto vertices = std::span(part.vertices).first(static_cast<std::size_t>(part.count));
  if (part.radius == 0.0) return {vertices.begin(), vertices.end()};
  std::vector<Eigen::Vector2d> polygon;
  for (int i = 0; i < kCorners; ++i) {
    const Eigen::Vector2d away = direction(2.0 * std::numbers::pi * i / kCorners);
    const auto farthest = std::max_element(vertices.begin(), vertices.end(),
                                           [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
                                             return away.dot(a) < away.dot(b);
                                           });
    polygon.emplace_back(*farthest + part.radius * away);
  }
  return polygon;
}

/// The same for every part of a body.
[[nodiscard]] inline std::vector<std::vector<Eigen::Vector2d>> outlines_of(const BodyShape& body) {
  std::vector<std::vector<Eigen::Vector2d>> outlines;
  for (const ConvexPart& part : body.parts())
    outlines.push_back(outline_of(part));
  return outlines;
}

}  // namespace fairway
