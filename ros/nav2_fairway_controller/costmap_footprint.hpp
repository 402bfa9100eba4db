// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "fairway/geometry/body_shape.hpp"
#include "fairway/geometry/robot_settings.hpp"

namespace fairway::nav2 {

/// Bounds of a footprint in the robot's frame [m].
struct FootprintBounds {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
};

/// The discs that cover the bounds, in rows and columns, with the least excess.
struct DiscGrid {
  int columns = 1;  ///< along x
  int rows = 1;     ///< along y
  double radius = 0.0;
  double excess = std::numeric_limits<double>::infinity();  ///< beyond the bounds [m]
};

[[nodiscard]] inline DiscGrid best_discs(const FootprintBounds& bounds) noexcept {
  const Eigen::Vector2d size = bounds.high - bounds.low;
  DiscGrid best;
  for (int columns = 1; columns <= Footprint::kMaxDiscs; ++columns) {
    for (int rows = 1; rows * columns <= Footprint::kMaxDiscs; ++rows) {
      const double x = 0.5 * size.x() / columns;
      const double y = 0.5 * size.y() / rows;
      const double radius = std::hypot(x, y);
      const double excess = radius - std::min(x, y);
      if (excess < best.excess) {
        best = {.columns = columns, .rows = rows, .radius = radius, .excess = excess};
      }
    }
  }
  return best;
}

/// Makes the body a grid of discs. Returns whether the discs are in range; if not, nothing changes.
[[nodiscard]] inline bool set_discs(const FootprintBounds& bounds,
                                    const DiscGrid& grid,
                                    RobotSettings& robot) noexcept {
  const Eigen::Vector2d size = bounds.high - bounds.low;
  BodyDiscs discs;
  double reach = 0.0;
  for (int i = 0; i < grid.columns; ++i) {
    for (int j = 0; j < grid.rows; ++j) {
      const Eigen::Vector2d center(bounds.low.x() + size.x() * (i + 0.5) / grid.columns,
                                   bounds.low.y() + size.y() * (j + 0.5) / grid.rows);
      if (!discs.add(center, grid.radius)) return false;
      reach = std::max(reach, center.norm() + grid.radius);
    }
  }
  robot.discs = discs;
  robot.radius = reach;
  robot.length = robot.width = 0.0;
  return true;
}

/// The corners of the convex hull of points, counter-clockwise (Andrew's monotone chain).
[[nodiscard]] inline std::vector<Eigen::Vector2d> hull_of(std::vector<Eigen::Vector2d> points) {
  std::sort(points.begin(), points.end(), [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  std::vector<Eigen::Vector2d> hull;
  const auto chain = [&](auto begin, auto end) {
    const std::size_t first = hull.size();
    for (auto p = begin; p != end; ++p) {
      while (hull.size() >= first + 2) {
        const Eigen::Vector2d a = hull.back() - hull[hull.size() - 2];
        const Eigen::Vector2d b = *p - hull.back();
        constexpr double kStraight = 1e-12;
        if (a.x() * b.y() - a.y() * b.x() > kStraight) break;
        hull.pop_back();
      }
      hull.push_back(*p);
    }
    if (!hull.empty()) hull.pop_back();
  };
  chain(points.begin(), points.end());
  chain(points.rbegin(), points.rend());
  return hull;
}

/// Sets the body from the footprint of a costmap: points with x and y in the robot's frame [m]. The
/// body covers the footprint. It is
///   a disc      for 8 or more corners at nearly equal distances from the origin, as costmaps make
///               for `robot_radius`;
///   a rectangle around the origin, if that exceeds the footprint's bounds by little;
///   discs       otherwise, for instance for a robot whose origin is at its rear axle.
/// @return Whether the footprint has a body; if not, nothing changes.
template <typename Points>
[[nodiscard]] bool set_body(const Points& footprint, RobotSettings& robot) {
  constexpr std::size_t kRound = 8;
  constexpr double kEqual = 0.98;
  constexpr double kLittle = 0.05;  // [m]
  constexpr double kLeast = 0.01;   // [m], the least radius
  constexpr double kMost = 10.0;    // [m], the greatest radius
  double nearest = kMost;
  double furthest = 0.0;
  FootprintBounds bounds;
  for (const auto& corner : footprint) {
    const Eigen::Vector2d point(corner.x, corner.y);
    const double distance = point.norm();
    if (!std::isfinite(distance)) return false;
    nearest = std::min(nearest, distance);
    furthest = std::max(furthest, distance);
    bounds.low = bounds.low.cwiseMin(point);
    bounds.high = bounds.high.cwiseMax(point);
  }
  if (footprint.size() < 3) return false;
  const bool round = footprint.size() >= kRound && nearest >= kEqual * furthest;
  const Eigen::Vector2d half = bounds.low.cwiseAbs().cwiseMax(bounds.high.cwiseAbs());
  const double radius = round ? furthest : half.norm();
  if (radius < kLeast || radius > kMost) return false;
  const double excess = std::max((half + bounds.low).maxCoeff(), (half - bounds.high).maxCoeff());
  const DiscGrid grid = best_discs(bounds);
  if (!round && excess > kLittle && grid.excess < excess && set_discs(bounds, grid, robot)) {
    return true;
  }
  robot.radius = radius;
  robot.discs = {};
  robot.length = round ? 0.0 : 2.0 * half.x();
  robot.width = round ? 0.0 : 2.0 * half.y();
  return true;
}

/// The body that a costmap's footprint is: the convex hull of its points with x and y in the
/// robot's frame [m], or the rectangle around a hull of more corners than a body can have. None if
/// they are no body: fewer than 3, on a line, not finite or too far away.
template <typename Points>
[[nodiscard]] std::optional<BodyShape> body_of(const Points& footprint) {
  std::vector<Eigen::Vector2d> points;
  for (const auto& corner : footprint) {
    points.emplace_back(corner.x, corner.y);
    if (!points.back().allFinite()) return std::nullopt;
  }
  std::vector<Eigen::Vector2d> corners = hull_of(std::move(points));
  if (corners.size() > ConvexPart::kMaxVertices) {
    Eigen::Vector2d low = corners.front();
    Eigen::Vector2d high = low;
    for (const Eigen::Vector2d& corner : corners) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
    corners = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  }
  const Expected<BodyShape> body = BodyShape::polygon(corners);
  return body ? std::optional(*body) : std::nullopt;
}

}  // namespace fairway::nav2
