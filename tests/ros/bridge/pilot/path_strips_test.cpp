// SPDX-License-Identifier: Apache-2.0
#include "bridge/path_strips.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace fairway::bridge {
namespace {

using Eigen::Vector2d;

// Whether a point is in a strip, whose corners are given counter-clockwise.
bool contains(const Zone& strip, const Vector2d& point) {
  for (std::size_t i = 0; i < strip.polygon.size(); ++i) {
    const Vector2d& from = strip.polygon[i];
    const Vector2d side = strip.polygon[(i + 1) % strip.polygon.size()] - from;
    if (side.x() * (point - from).y() - side.y() * (point - from).x() < -1e-9) return false;
  }
  return true;
}

bool in_strips(const Zones& strips, const Vector2d& point) {
  for (const Zone& strip : strips) {
    if (contains(strip, point)) return true;
  }
  return false;
}

TEST(PathStrips, ContainWhatIsWithinTheBound) {
  Path path;
  for (int i = 0; i <= 60; ++i)
    path.waypoints.emplace_back(0.1 * i, std::sin(0.1 * i));
  path.waypoints.emplace_back(6.0, 3.0);  // a sharp corner
  const Zones strips = strips_along(path, 0.2);
  EXPECT_TRUE(validate(strips));
  EXPECT_LT(strips.size(), 40U) << "nearly straight parts share a strip";
  for (const Vector2d& point : path.waypoints) {
    for (int i = 0; i < 16; ++i) {
      const double angle = 0.3927 * i;
      const Vector2d away(std::cos(angle), std::sin(angle));
      EXPECT_TRUE(in_strips(strips, point + 0.17 * away)) << point.transpose();
    }
  }
  EXPECT_FALSE(in_strips(strips, {3.0, 1.2}));
  EXPECT_FALSE(in_strips(strips, {6.4, 2.0}));
}

TEST(PathStrips, OfAStraightPathAreOne) {
  Path path;
  for (int i = 0; i <= 100; ++i)
    path.waypoints.emplace_back(0.1 * i, 0.2 * i);
  EXPECT_EQ(strips_along(path, 0.2).size(), 1U);
  path.waypoints.push_back(path.waypoints.front());  // and back
  EXPECT_EQ(strips_along(path, 0.2).size(), 2U);
  EXPECT_TRUE(strips_along({.waypoints = {{1, 1}}}, 0.2).empty());
  EXPECT_TRUE(validate(strips_along({.waypoints = {{1, 1}, {1, 1}}}, 0.2)));
}

}  // namespace
}  // namespace fairway::bridge
