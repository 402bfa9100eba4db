// SPDX-License-Identifier: Apache-2.0
#include "nav2_fairway_controller/costmap_footprint.hpp"

#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/navigation/settings.hpp"

namespace fairway::nav2 {
namespace {

struct Point {
  double x = 0.0;
  double y = 0.0;
};
using Points = std::vector<Point>;

TEST(CostmapFootprint, OfARadiusIsADisc) {
  Points circle;
  for (int i = 0; i < 16; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 16;
    circle.push_back({.x = 0.4 * std::cos(angle), .y = 0.4 * std::sin(angle)});
  }
  RobotSettings robot{.length = 1.0, .width = 1.0};
  EXPECT_TRUE(set_body(circle, robot));
  EXPECT_NEAR(robot.radius, 0.4, 1e-9);
  EXPECT_EQ(robot.length, 0.0);
}

TEST(CostmapFootprint, IsCoveredByARectangleAroundTheOrigin) {
  RobotSettings robot;
  EXPECT_TRUE(set_body(Points{{0.5, 0.22}, {-0.46, 0.22}, {-0.46, -0.25}, {0.5, -0.25}}, robot));
  EXPECT_EQ(robot.length, 1.0);
  EXPECT_EQ(robot.width, 0.5);
  EXPECT_NEAR(robot.radius, std::hypot(0.5, 0.25), 1e-12);
}

TEST(CostmapFootprint, WithItsOriginAtTheRearAxleIsCoveredByDiscs) {
  RobotSettings robot;
  ASSERT_TRUE(set_body(Points{{1.1, 0.4}, {-0.2, 0.4}, {-0.2, -0.4}, {1.1, -0.4}}, robot));
  ASSERT_GT(robot.discs.count, 0);
  EXPECT_EQ(robot.length, 0.0);
  const auto covered = [&](double x, double y) {
    for (int i = 0; i < robot.discs.count; ++i) {
      const Footprint::Disc& disc = robot.discs.discs[static_cast<std::size_t>(i)];
      if ((disc.center - Eigen::Vector2d(x, y)).norm() <= disc.radius + 1e-9) return true;
    }
    return false;
  };
  for (int i = 0; i <= 20; ++i) {
    for (int j = 0; j <= 20; ++j) {
      const double x = -0.2 + 1.3 * i / 20;
      const double y = -0.4 + 0.8 * j / 20;
      EXPECT_TRUE(covered(x, y)) << x << ", " << y;
      EXPECT_LE(std::hypot(x, y), robot.radius);
    }
  }
  EXPECT_FALSE(covered(-0.35, 0.0)) << "a rectangle around the origin would reach to -1.1 m";
  EXPECT_FALSE(covered(1.25, 0.0));
  Settings settings;
  settings.robot = robot;
  EXPECT_TRUE(validate(settings)) << "it can be driven";
}

TEST(CostmapFootprint, WithoutABodyChangesNothing) {
  RobotSettings robot{.radius = 0.3};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(set_body(Points{}, robot));
  EXPECT_FALSE(set_body(Points{{0, 0}, {0, 0}, {0, 0}}, robot));
  EXPECT_FALSE(set_body(Points{{0.1, 0}, {nan, 0.1}, {0.1, 0.1}}, robot));
  EXPECT_FALSE(set_body(Points{{50, 0}, {0, 50}, {-50, 0}}, robot));
  EXPECT_EQ(robot.radius, 0.3);
}

}  // namespace
}  // namespace fairway::nav2
