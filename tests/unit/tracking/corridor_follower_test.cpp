// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/corridor_follower.hpp"

#include <gtest/gtest.h>

namespace fairway {
namespace {

using Eigen::Vector2d;

OrientedRectangle box(double x0, double y0, double x1, double y1) {
  return {.seed = {x0, y0}, .orientation = 0.0, .min = {0, 0}, .max = {x1 - x0, y1 - y0}};
}

// An L-shaped corridor: along x, then up along y.
Corridor ell() {
  Corridor corridor;
  corridor.rectangles = {box(0, 0, 10, 2), box(8, 0, 10, 10)};
  return corridor;
}

TEST(CorridorFollower, PassesTheInnerCorner) {
  TrackingSettings settings;
  settings.corner_clearance = 0.0;
  CorridorFollower path(ell(), {9, 9}, settings);
  ASSERT_TRUE(path.update({1, 1}, 0.1));
  EXPECT_EQ(path.current(), 0U);
  EXPECT_TRUE(path.reference_path().ends_at_goal);
  // The shortest path touches the corner (8, 2).
  EXPECT_NEAR(path.reference_path().length(), std::hypot(7, 1) + std::hypot(1, 7), 1e-3);
  ASSERT_TRUE(path.update({9, 1.5}, 0.1));
  EXPECT_EQ(path.current(), 1U) << "the furthest rectangle that contains the robot";
  EXPECT_NEAR(path.reference_path().length(), 7.5, 1e-3);
}

TEST(CorridorFollower, KeepsItsMarginFromTheCorner) {
  TrackingSettings settings;
  settings.corner_clearance = 0.2;
  CorridorFollower path(ell(), {9, 9}, settings);
  ASSERT_TRUE(path.update({1, 1}, 0.1));
  EXPECT_GE(path.reference_path().points[1].x(), 8.2 - 1e-9);
  EXPECT_LE(path.reference_path().points[1].y(), 1.8 + 1e-9);
}

TEST(CorridorFollower, ToleratesSmallDeviationsOnly) {
  CorridorFollower path(ell(), {9, 9}, {});
  EXPECT_TRUE(path.update({1, -0.05}, 0.1));
  EXPECT_FALSE(path.update({1, -0.5}, 0.1));
  EXPECT_EQ(path.current(), 0U);
  EXPECT_FALSE(CorridorFollower().update({0, 0}, 1.0));
}

TEST(CorridorFollower, FindsARobotThatWasPushedBack) {
  CorridorFollower path(ell(), {9, 9}, {});
  ASSERT_TRUE(path.update({9, 8}, 0.1));
  EXPECT_EQ(path.current(), 1U);
  ASSERT_TRUE(path.update({2, 1}, 0.1));
  EXPECT_EQ(path.current(), 0U);
}

}  // namespace
}  // namespace fairway
