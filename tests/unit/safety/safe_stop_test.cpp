// SPDX-License-Identifier: Apache-2.0
#include "fairway/safety/safe_stop.hpp"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/map/free_space.hpp"
#include "fairway/simulation/unicycle_robot.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

constexpr double kPeriod = 0.1;  // [s]

using Eigen::Vector2d;

// A robot at standstill at (3, 0).
SharedMotion standing_robot(std::uint32_t number) {
  SharedMotion told{.robot = number,
                    .position = {3, 0},
                    .radius = 0.25,
                    .speed_max = 1.0,
                    .acceleration = 2.0,
                    .turn_max = 1.5};
  told.stop.add(told.position);
  return told;
}

class AmongRobots : public testing::Test {
 protected:
  // Whether a robot at `at` may send commands of `linear` [m/s] for a second.
  bool may(const Pose2& at, double linear, double unseen, std::uint32_t own, std::uint32_t other) {
    const SharedMotion told = standing_robot(other);
    const FleetMember member{.motion = &told, .unseen = unseen};
    const StopSituation now{.pose = at,
                            .current = {.linear = linear, .angular = 0.0},
                            .around = {.obstacles = &open_,
                                       .body = Footprint::disc(0.25),
                                       .moving = {},
                                       .fleet = {&member, 1},
                                       .robot = own},
                            .hold = 2.0};
    std::array<Twist2, 10> commands;
    commands.fill({.linear = linear, .angular = 0.0});
    SafeStop stop(RobotSettings{}, kPeriod);
    stop.reset(now.current);
    return stop.take(now, commands);
  }

  BitGrid open_{{.width = 100, .height = 100, .resolution = 0.1, .origin = {{-5, -5}, 0}}, false};
};

// If both robots passed each other, both would rely on outdated motions.
TEST_F(AmongRobots, OnlyOneOfTwoCloseRobotsMovesWithLateMessages) {
  const Pose2 beside{.position = {3.0, 0.51}, .heading = 0.0};
  EXPECT_TRUE(may(beside, 0.2, 0.0, 2, 1)) << "nothing is unseen";
  EXPECT_TRUE(may(beside, 0.2, 0.1, 1, 2)) << "the one with the smaller number";
  EXPECT_FALSE(may(beside, 0.2, 0.1, 2, 1)) << "the one with the larger number";
  const Pose2 away{.position = {3.0, 0.51}, .heading = 1.57};
  EXPECT_TRUE(may(away, 0.2, 0.1, 2, 1)) << "both may drive apart";
  EXPECT_TRUE(may(beside, 0.0, 0.1, 2, 1)) << "or stop";
}

// A robot at standstill, and an obstacle that comes from the left and passes beside it.
class BesideAPasser : public testing::Test {
 protected:
  [[nodiscard]] StopSituation at_distance(double lateral, double margin) {
    passer_.position.y() = lateral;
    return {.pose = {.position = {0, 0}, .heading = 0.0},
            .current = {},
            .around = {.obstacles = &open_,
                       .body = Footprint::disc(0.25),
                       .moving = {&passer_, 1},
                       .moving_margin = margin},
            .hold = 4.0};
  }

  BitGrid open_{{.width = 100, .height = 100, .resolution = 0.1, .origin = {{-5, -5}, 0}}, false};
  MovingObstacle passer_{.position = {-1.5, 0}, .velocity = {1, 0}, .radius = 0.3};
  SafeStop stop_{RobotSettings{}, kPeriod};
};

// An obstacle within the margin of the proof does not touch the robot, which then stays.
TEST_F(BesideAPasser, IsTouchedByAContactOnly) {
  EXPECT_TRUE(std::isinf(stop_.contact_time(at_distance(0.58, 0.06))));
  EXPECT_LT(stop_.contact_time(at_distance(0.52, 0.06)), 2.0);
}

// Where no manoeuvre keeps the margin, one that only delays or avoids the contact is taken.
TEST_F(BesideAPasser, EvadesAContactWithinTheMargin) {
  const StopSituation now = at_distance(0.1, 2.0);
  EXPECT_TRUE(stop_.evade(now, {}, stop_.contact_time(now)));
}

// Found by safety_campaign: where a base brakes harder than it accelerates, the stop was looked at
// as if its next command took longer than a period. An obstacle that moves as predicted then seemed
// to touch the robot, which left its stop and drove into it.
TEST(SafeStop, MeetsNoObstacleThatMovesAsPredictedWhileItIsExecuted) {
  test::Random random(8);
  const BitGrid open({.width = 200, .height = 200, .resolution = 0.5, .origin = {{-50, -50}, 0}},
                     false);
  for (int trial = 0; trial < 200; ++trial) {
    RobotSettings robot;
    robot.linear_max = 3.0;
    robot.linear_acceleration_max = random.uniform(0.3, 3.0);
    robot.linear_braking_max = random.uniform(0.3, 3.0);
    const Twist2 sent{.linear = random.uniform(0.5, 2.0), .angular = 0.0};
    MovingObstacle ahead{
        .position = {0.6, 0.0}, .velocity = {random.uniform(0.0, 0.8), 0.0}, .radius = 0.3};
    StopSituation now{.pose = {},
                      .current = sent,
                      .around = {.obstacles = &open,
                                 .body = Footprint::disc(0.25),
                                 .moving = {&ahead, 1},
                                 .moving_margin = 0.01},
                      .hold = 2.0};
    SafeStop stop(robot, kPeriod, 1.5 * kPeriod);
    stop.reset(sent);
    const Twist2 command =
        limited_change(sent, {.linear = robot.linear_max, .angular = 0.0}, robot, kPeriod);
    while (!stop.take(now, {&command, 1}))
      ahead.position.x() += 0.01;
    UnicycleRobot base{.pose = {}, .twist = sent, .limits = limits_of(robot)};
    for (Twist2 next = command; next.linear > 0.0; next = stop.next()) {
      base.advance(next, kPeriod);
      ahead.position += kPeriod * ahead.velocity;
      now.pose = base.pose;
      now.current = next;
      stop.begin_cycle(kPeriod, kPeriod);
      ASSERT_TRUE(std::isinf(stop.contact_time(now))) << trial << ", at " << next.linear;
    }
  }
}

// Found by safe_stop_soak: an evasion was accepted without a test for static obstacles beyond its
// contact. The evasion touched a moving obstacle, which may move otherwise than predicted; a static
// one does not.
TEST(SafeStop, NeverEvadesIntoAStaticObstacle) {
  test::Random random(5);
  int evaded = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const BitGrid obstacles(test::random_world(random, 120));
    const GridFrame& frame = obstacles.frame();
    const Pose2 pose{.position = frame.to_world(
                         {random.uniform(0, frame.width), random.uniform(0, frame.height)}),
                     .heading = random.uniform(-3, 3)};
    const double radius = random.uniform(0.1, 0.3);
    if (!is_free(obstacles, pose.position, pose.position, radius + 0.05)) continue;
    const double bearing = random.uniform(-3, 3);
    const std::array moving{
        MovingObstacle{.position = pose.position + (radius + 0.9) * direction(bearing),
                       .velocity = -random.uniform(0.5, 1.5) * direction(bearing),
                       .radius = 0.3}};
    const StopSituation now{.pose = pose,
                            .current = {},
                            .around = {.obstacles = &obstacles,
                                       .body = Footprint::disc(radius),
                                       .static_margin = 0.01,
                                       .moving = moving},
                            .hold = 2.0};
    SafeStop stop(RobotSettings{}, kPeriod);
    stop.reset(now.current);
    if (!stop.evade(now, {}, stop.contact_time(now))) continue;
    ++evaded;
    StopSituation alone = now;
    alone.around.moving = {};
    StopSequence rest = stop.sequence();
    const Twist2 first = stop.next();
    rest.pop_front(1);
    EXPECT_EQ(check_stop(pose, now.current, first, rest, kPeriod, alone.around), StopVerdict::Free)
        << trial;
  }
  EXPECT_GT(evaded, 200);
}

}  // namespace
}  // namespace fairway
