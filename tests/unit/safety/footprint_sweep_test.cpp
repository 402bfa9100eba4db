// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "fairway/map/footprint_clearance.hpp"
#include "fairway/safety/stop_check.hpp"
#include "fairway/simulation/unicycle_robot.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

constexpr double kSweepPeriod = 0.1;  // [s]

RobotSettings sweep_limits() {
  RobotSettings s;
  s.linear_acceleration_max = 1.0;
  s.angular_acceleration_max = 4.0;
  return s;
}

/// A wall from y = 0.25 on, with the origin in the middle.
BitGrid wall_at_quarter_metre() {
  BitGrid obstacles(
      GridFrame{.width = 80, .height = 80, .resolution = 0.05, .origin = {{-2, -2}, 0}}, false);
  for (int x = 0; x < 80; ++x)
    obstacles.set({x, 45}, true);
  return obstacles;
}

Footprint random_footprint(test::Random& random) {
  if (random.chance(0.5)) return Footprint::rectangle(0.46, 0.3, {0.05, 0.0});
  const Footprint::Disc discs[3] = {{.center = {0.15, 0.05}, .radius = 0.12},
                                    {.center = {-0.15, 0.0}, .radius = 0.15},
                                    {.center = {0.0, -0.1}, .radius = 0.1}};
  return Footprint::discs(discs, 3);
}

TEST(FootprintSweep, AProvenStopStaysFreeAndARefusedOneComesClose) {
  test::Random random(1);
  int proven = 0;
  int refused = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const BitGrid obstacles(test::random_world(random, 120));
    const GridFrame& frame = obstacles.frame();
    const Footprint body = random_footprint(random);
    const Pose2 pose{.position = frame.to_world(
                         {random.uniform(0, frame.width), random.uniform(0, frame.height)}),
                     .heading = random.uniform(-3, 3)};
    const Twist2 current{.linear = random.uniform(-0.5, 1), .angular = random.uniform(-3, 3)};
    const Twist2 command{.linear = current.linear + random.uniform(-0.1, 0.1),
                         .angular = current.angular + random.uniform(-0.4, 0.4)};
    const StopSequence stop = brake_from(command, sweep_limits(), kSweepPeriod);
    const CollisionEnvironment around{.obstacles = &obstacles,
                                      .body = body,
                                      .static_margin = random.chance(0.5) ? 0.0 : 0.03,
                                      .margin_where_it_stands = random.chance(0.5),
                                      .moving = {}};
    const bool free = check_stop(pose, current, command, stop, 0.1, around) == StopVerdict::Free;
    (free ? proven : refused) += 1;

    UnicycleRobot plant{.pose = pose, .twist = current, .limits = {1.0, 4.0}};
    std::vector<Twist2> commands{command};
    commands.insert(commands.end(), stop.begin(), stop.end());
    double least = footprint_clearance(obstacles, body, pose, 1.0);
    for (const Twist2& c : commands) {
      for (int i = 0; i < 25; ++i) {
        plant.advance(c, 0.004);
        least = std::min(least, footprint_clearance(obstacles, body, plant.pose, 1.0));
      }
    }
    const double last = footprint_clearance(obstacles, body, plant.pose, 1.0);
    const double margin = around.static_margin;
    if (free) {
      EXPECT_GE(least, (around.margin_where_it_stands ? 0.0 : margin) - 1e-3)
          << "the stop is proven, but it touches";
      EXPECT_GE(last, margin - 1e-3) << "the stop is proven, but it ends too close";
    } else {
      EXPECT_LE(least, margin + 0.012) << "the stop is refused unnecessarily";
    }
  }
  EXPECT_GT(proven, 50);
  EXPECT_GT(refused, 50);
}

TEST(FootprintSweep, ARectanglePassesWhereItsDiscDoesNot) {
  // A gap of 0.5 m; the robot is 0.458 m long and 0.416 m wide, its disc 0.62 m.
  BitGrid obstacles(
      GridFrame{.width = 80, .height = 80, .resolution = 0.05, .origin = {{-2, -2}, 0}}, false);
  for (int x = 35; x < 60; ++x) {
    obstacles.set({x, 34}, true);  // up to y = -0.25
    obstacles.set({x, 45}, true);  // from y = 0.25
  }
  const RobotSettings robot = sweep_limits();
  const Pose2 pose{.position = {-0.8, 0.0}, .heading = 0.0};
  const Twist2 twist{.linear = 1.0, .angular = 0.0};
  const auto verdict = [&](const Footprint& body) {
    return check_stop(pose, twist, twist, brake_from(twist, robot, kSweepPeriod), kSweepPeriod,
                      {.obstacles = &obstacles, .body = body, .moving = {}});
  };
  EXPECT_EQ(verdict(Footprint::rectangle(0.458, 0.416)), StopVerdict::Free);
  EXPECT_EQ(verdict(Footprint::disc(0.31)), StopVerdict::HitsStatic);
}

TEST(FootprintSweep, ARectangleTurnsOnlyWhereItsCornersFit) {
  const BitGrid obstacles = wall_at_quarter_metre();
  const RobotSettings robot = sweep_limits();
  const Twist2 turning{.linear = 0.0, .angular = 1.0};
  const auto verdict = [&](double heading) {
    return check_stop(
        {.position = {0, 0}, .heading = heading}, turning, turning,
        brake_from(turning, robot, kSweepPeriod), kSweepPeriod,
        {.obstacles = &obstacles, .body = Footprint::rectangle(0.458, 0.416), .moving = {}});
  };
  EXPECT_EQ(verdict(0.4), StopVerdict::HitsStatic);
  EXPECT_EQ(verdict(-0.16), StopVerdict::Free);
}

TEST(FootprintSweep, ABodyAtItsMarginMayTurnToLargerClearance) {
  const BitGrid obstacles = wall_at_quarter_metre();
  const RobotSettings robot = sweep_limits();
  const Footprint body = Footprint::rectangle(0.458, 0.416);
  const Pose2 pose{.position = {0, -0.025}, .heading = 0.3};  // its corner is 9 mm from the wall
  const auto verdict = [&](double angular, bool margin_where_it_stands) {
    const Twist2 turning{.linear = 0.0, .angular = angular};
    return check_stop(pose, {}, turning, brake_from(turning, robot, kSweepPeriod), kSweepPeriod,
                      {.obstacles = &obstacles,
                       .body = body,
                       .static_margin = footprint_clearance(obstacles, body, pose, 1.0),
                       .margin_where_it_stands = margin_where_it_stands,
                       .moving = {}});
  };
  EXPECT_EQ(verdict(-0.4, true), StopVerdict::Free);
  EXPECT_EQ(verdict(-0.4, false), StopVerdict::HitsStatic);
  EXPECT_EQ(verdict(0.4, true), StopVerdict::HitsStatic);
}

TEST(FootprintSweep, AMovingDiscMayPassBesideANarrowBody) {
  const BitGrid empty(
      GridFrame{.width = 400, .height = 400, .resolution = 0.05, .origin = {{-10, -10}, 0}}, false);
  const RobotSettings robot = sweep_limits();
  const Footprint narrow = Footprint::rectangle(1.0, 0.2);
  const auto verdict = [&](double y) {
    const MovingObstacle passing{.position = {1.2, y}, .velocity = {-1.5, 0.0}, .radius = 0.2};
    return check_stop({}, {0.5, 0.0}, {0.5, 0.0}, brake_from({0.5, 0.0}, robot, kSweepPeriod),
                      kSweepPeriod, {.obstacles = &empty, .body = narrow, .moving = {&passing, 1}});
  };
  EXPECT_EQ(verdict(0.36), StopVerdict::Free);
  EXPECT_EQ(verdict(0.28), StopVerdict::HitsMoving);
}

}  // namespace
}  // namespace fairway
