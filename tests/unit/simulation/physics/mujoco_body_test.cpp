// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/physics/mujoco_body.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace fairway {
namespace {

constexpr std::array<BaseKind, 4> kKinds{BaseKind::Unicycle, BaseKind::Car, BaseKind::Tricycle,
                                         BaseKind::Omni};

BitGrid floor_with_wall() {
  BitGrid obstacles(GridFrame{.width = 100, .height = 100, .resolution = 0.1, .origin = {}}, false);
  for (int y = 0; y < 100; ++y)
    obstacles.set({.x = 95, .y = y}, true);
  return obstacles;
}

RobotModel robot_of(BaseKind kind) {
  RobotModel robot{.body = BodyShape::rectangle(1.2, 0.6, 0.9), .base = {}};
  robot.base.kind = kind;
  robot.base.linear_min = -1.0;
  if (kind == BaseKind::Omni) robot.body = BodyShape::rectangle(1.2, 0.6, 0.6);
  return robot;
}

const Pose2 kStart{.position = {3.0, 4.0}, .heading = 0.0};

TEST(MujocoBody, EveryBaseDrivesStraightAsFarAsItIsSent) {
  for (const BaseKind kind : kKinds) {
    MujocoBody body(robot_of(kind), floor_with_wall(), kStart);
    body.advance({.linear = 0.8}, 2.4);  // 0.8 s of ramp
    body.advance({}, 1.6);
    EXPECT_NEAR(body.pose().position.x(), 3.0 + 0.8 * 2.4, 0.05) << to_text(kind);
    EXPECT_NEAR(body.pose().position.y(), 4.0, 0.02) << to_text(kind);
    EXPECT_NEAR(body.pose().heading, 0.0, 0.02) << to_text(kind);
    EXPECT_NEAR(body.twist().linear, 0.0, 0.01) << to_text(kind);
    EXPECT_FALSE(body.touched()) << to_text(kind);
  }
}

TEST(MujocoBody, EveryBaseTurnsAsItIsSent) {
  for (const BaseKind kind : kKinds) {
    const RobotModel robot = robot_of(kind);
    MujocoBody body(robot, floor_with_wall(), kStart);
    const double wanted = 0.4;  // [rad/s]
    const double turn =
        is_steered(robot.base) ? std::atan(robot.base.wheelbase * wanted / 0.5) : wanted;
    body.advance({.turn = is_steered(robot.base) ? turn : 0.0}, 1.0);
    body.advance({.linear = 0.5, .turn = turn}, 2.5);
    EXPECT_NEAR(body.twist().angular, wanted, 0.06) << to_text(kind);
    EXPECT_NEAR(body.twist().linear, 0.5, 0.05) << to_text(kind);
  }
}

TEST(MujocoBody, MecanumAndSwerveBasesMoveSideways) {
  RobotModel robot = robot_of(BaseKind::Omni);
  for (const WheelKind wheels : {WheelKind::Mecanum, WheelKind::Swerve}) {
    robot.base.wheels = {.kind = wheels, .speed_max = 2.0, .half_sum = 0.7, .num_modules = 4};
    robot.base.wheels.modules = {Eigen::Vector2d(0.4, 0.2), Eigen::Vector2d(0.4, -0.2),
                                 Eigen::Vector2d(-0.4, 0.2), Eigen::Vector2d(-0.4, -0.2)};
    MujocoBody body(robot, floor_with_wall(), kStart);
    body.advance({.lateral = 0.4}, 2.0);
    EXPECT_NEAR(body.twist().lateral, 0.4, 0.06) << static_cast<int>(wheels);
    EXPECT_NEAR(body.pose().heading, 0.0, 0.05) << static_cast<int>(wheels);
    EXPECT_NEAR(body.pose().position.x(), 3.0, 0.05) << static_cast<int>(wheels);
  }
}

TEST(MujocoBody, TouchesTheWallWithItsFront) {
  MujocoBody body(robot_of(BaseKind::Unicycle), floor_with_wall(),
                  {.position = {8.0, 4.0}, .heading = 0.0});
  body.advance({.linear = 0.5}, 1.2);  // 0.475 m; the wall is 0.6 m ahead of the front
  EXPECT_FALSE(body.touched());
  body.advance({.linear = 0.5}, 0.8);
  EXPECT_TRUE(body.touched());
}

}  // namespace
}  // namespace fairway
