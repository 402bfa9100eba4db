// SPDX-License-Identifier: Apache-2.0
#include "fairway/safety/stop_check.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/map/free_space.hpp"
#include "fairway/simulation/unicycle_robot.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

constexpr double kCheckPeriod = 0.1;  // [s]

RobotSettings limits() {
  RobotSettings s;
  s.linear_acceleration_max = 1.0;
  s.angular_acceleration_max = 2.0;
  return s;
}

TEST(Stopping, BrakingEndsAtStandstillWithinTheLimits) {
  test::Random random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const Twist2 from{.linear = random.uniform(-1, 1.5), .angular = random.uniform(-1.5, 1.5)};
    const StopSequence stop = brake_from(from, limits(), kCheckPeriod);
    Twist2 before = from;
    for (const Twist2& now : stop) {
      EXPECT_LE(std::abs(now.linear - before.linear), 0.1 + 1e-12);
      EXPECT_LE(std::abs(now.angular - before.angular), 0.2 + 1e-12);
      EXPECT_LE(std::abs(now.linear), std::abs(before.linear));
      EXPECT_LE(std::abs(now.angular), std::abs(before.angular));
      before = now;
    }
    EXPECT_EQ(before.linear, 0.0);
    EXPECT_EQ(before.angular, 0.0);
  }
  EXPECT_EQ(brake_from({}, limits(), kCheckPeriod).size(), 0U);
}

TEST(Stopping, AProvenStopReallyStaysFree) {
  test::Random random(2);
  int proven = 0;
  int refused = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const BitGrid obstacles(test::random_world(random, 120));
    const GridFrame& frame = obstacles.frame();
    const Pose2 pose{.position = frame.to_world(
                         {random.uniform(0, frame.width), random.uniform(0, frame.height)}),
                     .heading = random.uniform(-3, 3)};
    const Twist2 current{.linear = random.uniform(0, 1), .angular = random.uniform(-1, 1)};
    const Twist2 command{.linear = current.linear + random.uniform(-0.1, 0.1),
                         .angular = current.angular + random.uniform(-0.2, 0.2)};
    const double radius = 0.2;
    const StopSequence stop = brake_from(command, limits(), kCheckPeriod);
    const CollisionEnvironment around{
        .obstacles = &obstacles, .body = Footprint::disc(radius), .moving = {}};
    const bool free = check_stop(pose, current, command, stop, 0.1, around) == StopVerdict::Free;
    (free ? proven : refused) += 1;

    // Drive with the simulator's robot model, at a step 50 times finer.
    UnicycleRobot plant{.pose = pose, .twist = current, .limits = {1.0, 2.0}};
    std::vector<Twist2> commands{command};
    commands.insert(commands.end(), stop.begin(), stop.end());
    double least = distance_to_blocked(obstacles, pose.position, 1.0);
    for (const Twist2& c : commands) {
      for (int i = 0; i < 50; ++i) {
        plant.advance(c, 0.002);
        least = std::min(least, distance_to_blocked(obstacles, plant.pose.position, 1.0));
      }
    }
    if (free) {
      EXPECT_GE(least, radius - 1e-4) << "the stop is proven, but it touches";
    } else {
      EXPECT_LE(least, radius + 0.01) << "the stop is refused unnecessarily";
    }
  }
  EXPECT_GT(proven, 30);
  EXPECT_GT(refused, 30);
}

TEST(Stopping, AFastObstacleIsDetectedBetweenSamples) {
  const BitGrid empty(
      GridFrame{.width = 400, .height = 400, .resolution = 0.05, .origin = {{-10, -10}, 0}}, false);
  // At 40 m/s it is on the other side of the robot within one sample.
  const MovingObstacle fast{.position = {0.4, -0.8}, .velocity = {0, 40}, .radius = 0.1};
  const CollisionEnvironment around{.obstacles = &empty,
                                    .body = Footprint::disc(0.3),
                                    .moving = {&fast, 1},
                                    .moving_margin = 0.0};
  const StopSequence stop = brake_from({0.3, 0}, limits(), kCheckPeriod);
  EXPECT_EQ(check_stop({}, {0.3, 0}, {0.3, 0}, stop, 0.1, around), StopVerdict::HitsMoving);
}

TEST(Stopping, LeavingAnObstacleThatIsTooCloseIsAllowed) {
  const BitGrid empty(
      GridFrame{.width = 400, .height = 400, .resolution = 0.05, .origin = {{-10, -10}, 0}}, false);
  const MovingObstacle near{.position = {-0.45, 0}, .velocity = {0, 0}, .radius = 0.2};
  const CollisionEnvironment around{.obstacles = &empty,
                                    .body = Footprint::disc(0.3),
                                    .moving = {&near, 1},
                                    .moving_margin = 0.0};
  EXPECT_EQ(check_stop({}, {}, {0.1, 0}, brake_from({0.1, 0}, limits(), kCheckPeriod), 0.1, around),
            StopVerdict::Free);
  EXPECT_EQ(
      check_stop({}, {}, {-0.1, 0}, brake_from({-0.1, 0}, limits(), kCheckPeriod), 0.1, around),
      StopVerdict::HitsMoving);
}

TEST(Stopping, ABodyThatFitsIsStoppedWhereItCouldNotTurn) {
  // A lane along x, 0.52 m wide: it admits the body's 0.416 m, but not the disc of 0.31 m.
  BitGrid obstacles(GridFrame{.width = 200, .height = 200, .resolution = 0.02, .origin = {}},
                    false);
  for (int x = 0; x < 200; ++x) {
    for (int y = 0; y < 200; ++y) {
      if (y < 87 || y >= 113) obstacles.set({x, y}, true);
    }
  }
  const Twist2 slow{.linear = 0.1, .angular = 0.0};
  const Pose2 pose{.position = {2.0, 2.0}, .heading = 0.0};
  CollisionEnvironment around{
      .obstacles = &obstacles, .body = Footprint::rectangle(0.458, 0.416), .moving = {}};
  const auto verdict = [&] {
    return check_stop(pose, slow, slow, brake_from(slow, limits(), kCheckPeriod), 0.1, around);
  };
  EXPECT_EQ(verdict(), StopVerdict::Free);
  around.turning_radius = 0.25;
  EXPECT_EQ(verdict(), StopVerdict::Free);
  around.turning_radius = 0.29;
  EXPECT_EQ(verdict(), StopVerdict::HitsStatic);
}

}  // namespace
}  // namespace fairway
