// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/unicycle_robot.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace fairway {
namespace {

TEST(UnicycleRobot, AConstantTwistDrivesACircle) {
  UnicycleRobot robot{.pose = {}, .twist = {1.0, 0.5}, .limits = {}};
  for (int i = 0; i < 1000; ++i)
    robot.advance({1.0, 0.5}, 0.002);
  // Radius 2 m, turned by 1 rad.
  EXPECT_NEAR(robot.pose.position.x(), 2.0 * std::sin(1.0), 1e-6);
  EXPECT_NEAR(robot.pose.position.y(), 2.0 * (1.0 - std::cos(1.0)), 1e-6);
  EXPECT_NEAR(robot.pose.heading, 1.0, 1e-9);
}

TEST(UnicycleRobot, AcceleratesNoFasterThanItCan) {
  UnicycleRobot robot{
      .pose = {}, .twist = {}, .limits = {.linear_acceleration = 2.0, .angular_acceleration = 4.0}};
  robot.advance({1.0, -1.0}, 0.1);
  EXPECT_NEAR(robot.twist.linear, 0.2, 1e-12);
  EXPECT_NEAR(robot.twist.angular, -0.4, 1e-12);
  EXPECT_NEAR(robot.pose.position.norm(), 0.5 * 2.0 * 0.01, 1e-12);
}

}  // namespace
}  // namespace fairway
