// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/physics/mujoco_physics.hpp"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "fairway/geometry/angle.hpp"
#include "fairway/simulation/world.hpp"

namespace fairway {
namespace {

Scenario open_floor() {
  Scenario scenario;
  scenario.map =
      OccupancyGrid({.width = 400, .height = 400, .resolution = 0.05, .origin = {{-10, -10}, 0}});
  scenario.settings.robot = {.radius = 0.31, .length = 0.458, .width = 0.416};
  scenario.settings.robot.linear_max = 2.0;
  scenario.settings.robot.angular_max = 4.0;
  scenario.robots = {{.name = "robot", .start = {}, .goal = {}}};
  return scenario;
}

World with_mujoco(const Scenario& scenario) {
  return World(scenario, make_mujoco_physics(scenario));
}

TEST(MujocoPhysics, DoesNotMoveWithoutACommand) {
  const Scenario scenario = open_floor();
  World world = with_mujoco(scenario);
  for (int i = 0; i < 50; ++i)
    world.advance({{0.0, 0.0}}, 0.1);
  EXPECT_LT(world.robots()[0].pose.position.norm(), 0.01);
  EXPECT_FALSE(world.encounters()[0].collided);
}

// Commands of ten seconds, and the largest deviation from the unicycle that they may cause.
struct Drive {
  const char* name;
  Twist2 (*command)(double t);
  double most_off;     // [m]
  double most_turned;  // [rad]
};

class MujocoDrift : public testing::TestWithParam<Drive> {};

// This prints the figures of docs/physics.md.
TEST_P(MujocoDrift, StaysNearTheUnicycleForTenSeconds) {
  const Drive& drive = GetParam();
  Scenario scenario = open_floor();
  scenario.robots[0].start.position = {-8.0, 0.0};
  World wheels = with_mujoco(scenario);
  World ideal(scenario);
  for (int i = 0; i < 100; ++i) {
    const Twist2 command = drive.command(0.1 * i);
    wheels.advance({command}, 0.1);
    ideal.advance({command}, 0.1);
  }
  const Pose2& driven = wheels.robots()[0].pose;
  const Pose2& wanted = ideal.robots()[0].pose;
  const double off = (driven.position - wanted.position).norm();
  const double turned = std::abs(shortest_turn(driven.heading, wanted.heading));
  std::printf("[  drift   ] %s: %.3f m, %.2f degrees\n", drive.name, off,
              turned * 180.0 / std::numbers::pi);
  EXPECT_LT(off, drive.most_off);
  EXPECT_LT(turned, drive.most_turned);
  EXPECT_FALSE(wheels.encounters()[0].collided);
}

Twist2 straight(double /*t*/) { return {.linear = 1.5, .angular = 0.0}; }
Twist2 circle(double /*t*/) { return {.linear = 1.0, .angular = 1.0}; }
Twist2 slalom(double t) {
  return {.linear = 0.8 + 0.4 * std::sin(0.7 * t), .angular = 0.9 * std::sin(1.3 * t)};
}
Twist2 stop_and_turn(double t) {
  const bool even = static_cast<int>(t) % 2 == 0;
  return {.linear = even ? 1.5 : 0.0, .angular = even ? 0.0 : 1.5};
}
std::string number_of(const testing::TestParamInfo<Drive>& drive) {
  return std::to_string(drive.index);
}

INSTANTIATE_TEST_SUITE_P(Drives,
                         MujocoDrift,
                         testing::Values(Drive{"straight, 1.5 m/s", straight, 0.1, 0.02},
                                         Drive{"circle, 1 m/s, 1 rad/s", circle, 0.3, 0.3},
                                         Drive{"slalom, 0.4 to 1.2 m/s", slalom, 0.3, 0.15},
                                         Drive{"full braking and turning every second",
                                               stop_and_turn, 0.5, 0.3}),
                         number_of);

TEST(MujocoPhysics, ARobotThatRamsAWallStopsAtItsFace) {
  Scenario scenario = open_floor();
  for (int y = 180; y < 220; ++y)
    scenario.map.set({240, y}, CellState::Occupied);  // from x = 2.0
  // The engine continues to push: World would stop commanding the robot after the contact.
  MujocoPhysics physics(scenario);
  std::vector<UnicycleRobot> robots(1);
  std::vector<std::uint8_t> touched(1, 0);
  const Twist2 ahead{.linear = 1.0, .angular = 0.0};
  for (int i = 0; i < 1000; ++i)
    physics.advance({&ahead, 1}, {}, 0.005, robots, touched);
  EXPECT_EQ(touched[0], 1);
  EXPECT_NEAR(robots[0].pose.position.x() + 0.229, 2.0, 0.02);
}

TEST(MujocoPhysics, TheWorldDetectsAContact) {
  Scenario scenario = open_floor();
  MovingBody person;
  person.radius = 0.3;
  person.key_frames = {{0.0, {4.0, 0.0}}, {4.0, {0.0, 0.0}}};
  scenario.bodies = {person};
  World world = with_mujoco(scenario);
  for (int i = 0; i < 40 && !world.encounters()[0].collided; ++i)
    world.advance({{0.0, 0.0}}, 0.1);
  EXPECT_TRUE(world.encounters()[0].collided);
  EXPECT_NEAR(world.encounters()[0].collision_time, (4.0 - 0.3 - 0.229) / 1.0, 0.1);
}

TEST(MujocoPhysics, SameCommandsGiveTheSameBits) {
  const auto run = [] {
    const Scenario scenario = open_floor();
    World world = with_mujoco(scenario);
    for (int i = 0; i < 30; ++i)
      world.advance({{1.0, 0.5}}, 0.1);
    return world.robots()[0].pose;
  };
  const Pose2 first = run();
  const Pose2 second = run();
  EXPECT_EQ(first.position, second.position);
  EXPECT_EQ(first.heading, second.heading);
}

// Two discs, one in front of the other: the chassis extends 0.45 m ahead and 0.15 m to the sides.
TEST(MujocoPhysics, ABodyOfDiscsTouchesWithTheNearestDisc) {
  Scenario scenario = open_floor();
  scenario.settings.robot = {.radius = 0.45};
  ASSERT_TRUE(scenario.settings.robot.discs.add({0.0, 0.0}, 0.15));
  ASSERT_TRUE(scenario.settings.robot.discs.add({0.3, 0.0}, 0.15));
  for (int x = 0; x < 400; ++x)
    scenario.map.set({.x = x, .y = 205}, CellState::Occupied);  // from y = 0.25 m on
  for (int y = 190; y < 205; ++y)
    scenario.map.set({.x = 240, .y = y}, CellState::Occupied);  // from x = 2 m on
  World world = with_mujoco(scenario);
  double reached = 0.0;
  for (int i = 0; i < 60 && !world.encounters()[0].collided; ++i) {
    reached = world.robots()[0].pose.position.x();
    world.advance({{0.5, 0.0}}, 0.1);
  }
  EXPECT_TRUE(world.encounters()[0].collided);
  EXPECT_NEAR(reached, 2.0 - 0.45, 0.08);  // beside the wall it was free
}

}  // namespace
}  // namespace fairway
