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

TEST(UnicycleRobot, BrakesAsHardAsItsBrakesDo) {
  UnicycleRobot robot{.pose = {},
                      .twist = {.linear = 1.0, .angular = 1.0},
                      .limits = {.linear_acceleration = 2.0, .linear_braking = 0.5}};
  robot.advance({}, 0.1);
  EXPECT_NEAR(robot.twist.linear, 0.95, 1e-12);
  EXPECT_NEAR(robot.twist.angular, 0.6, 1e-12) << "as it accelerates";
  robot.twist = {.linear = 0.05, .angular = 0.0};
  robot.advance({.linear = -1.0, .angular = 0.0}, 0.2);
  EXPECT_NEAR(robot.twist.linear, -0.2, 1e-12) << "half of the time is left for the other way";
}

TEST(UnicycleRobot, AnswersAfterTheDelayOfEachAxis) {
  UnicycleRobot robot{.pose = {},
                      .twist = {},
                      .limits = {.linear_acceleration = 1000.0,
                                 .angular_acceleration = 1000.0,
                                 .linear_delay = 0.3,
                                 .angular_delay = 0.1}};
  double linear_at = 0.0;
  double angular_at = 0.0;
  for (int i = 0; i < 100; ++i) {
    robot.advance({1.0, 1.0}, 0.005);
    if (robot.twist.linear == 0.0) linear_at = 0.005 * (i + 1);
    if (robot.twist.angular == 0.0) angular_at = 0.005 * (i + 1);
  }
  EXPECT_NEAR(linear_at, 0.3, 0.006);
  EXPECT_NEAR(angular_at, 0.1, 0.006);
}

TEST(UnicycleRobot, FollowsWithItsLag) {
  UnicycleRobot robot{
      .pose = {}, .twist = {}, .limits = {.linear_acceleration = 1000.0, .linear_lag = 0.2}};
  for (int i = 0; i < 40; ++i)
    robot.advance({1.0, 0.0}, 0.005);
  EXPECT_NEAR(robot.twist.linear, 1.0 - std::exp(-1.0), 1e-9) << "after one time constant";
}

}  // namespace
}  // namespace fairway
