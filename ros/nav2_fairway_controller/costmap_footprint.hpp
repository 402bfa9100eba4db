// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "fairway/geometry/robot_settings.hpp"

namespace fairway::nav2 {

/// Sets the body from the footprint of a costmap: points with x and y in the robot's frame [m]. The
/// body covers the footprint: a disc for a polygon of 8 or more corners with nearly equal
/// distances from the origin, as costmaps make for `robot_radius`, else the rectangle around the
/// origin that contains all corners.
/// @return Whether the footprint has a body; if not, nothing changes.
template <typename Points>
[[nodiscard]] bool set_body(const Points& footprint, RobotSettings& robot) {
  constexpr std::size_t kRound = 8;
  constexpr double kEqual = 0.98;
  constexpr double kLeast = 0.01;  // [m], the least radius
  constexpr double kMost = 10.0;   // [m], the greatest radius
  double nearest = kMost;
  double furthest = 0.0;
  double length = 0.0;
  double width = 0.0;
  for (const auto& corner : footprint) {
    const double distance = std::hypot(corner.x, corner.y);
    if (!std::isfinite(distance)) return false;
    nearest = std::min(nearest, distance);
    furthest = std::max(furthest, distance);
    length = std::max(length, 2.0 * std::abs(corner.x));
    width = std::max(width, 2.0 * std::abs(corner.y));
  }
  const bool round = footprint.size() >= kRound && nearest >= kEqual * furthest;
  const double radius = round ? furthest : 0.5 * std::hypot(length, width);
  if (footprint.size() < 3 || radius < kLeast || radius > kMost) return false;
  robot.radius = radius;
  robot.discs = {};
  robot.length = round ? 0.0 : length;
  robot.width = round ? 0.0 : width;
  return true;
}

}  // namespace fairway::nav2
