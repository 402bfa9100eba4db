// SPDX-License-Identifier: Apache-2.0
// Situations in which a robot neither drives on nor may turn back and forth without end.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "fairway/geometry/angle.hpp"
#include "fairway/map/footprint_clearance.hpp"
#include "fairway/navigation/facade/map_navigator.hpp"
#include "fairway/tracking/problem_setup.hpp"

namespace fairway {
namespace {

// A room of 12 m x 8 m with walls of one cell.
OccupancyGrid room() {
  OccupancyGrid map({.width = 240, .height = 160, .resolution = 0.05, .origin = {}});
  for (int x = 0; x < 240; ++x) {
    for (int y = 0; y < 160; ++y) {
      if (x == 0 || y == 0 || x == 239 || y == 159) map.set({x, y}, CellState::Occupied);
    }
  }
  return map;
}

// A base that executes its commands, and a record of its motion.
struct Base {
  MapNavigator navigator;
  Pose2 robot;
  Twist2 last{};
  double time = 0.0;
  double turned = 0.0;   // [rad]
  double driven = 0.0;   // [m]
  double nearest = 1.0;  // the least clearance of the body [m]
  NavigationStep step{};
  std::vector<MovingObstacle> people{};

  void run(double seconds) {
    const double period = navigator.settings().navigation.control_period;
    const Footprint body = footprint_of(navigator.settings().robot);
    for (const double end = time + seconds; time < end - 1e-9; time += period) {
      step = navigator.update({.time = time, .pose = robot, .obstacles = people});
      const Twist2 mean{.linear = 0.5 * (last.linear + step.command.linear),
                        .angular = 0.5 * (last.angular + step.command.angular)};
      robot = fairway::step(robot, mean, period, Integration::Midpoint);
      turned += std::abs(mean.angular) * period;
      driven += std::abs(mean.linear) * period;
      last = step.command;
      nearest = std::min(nearest, footprint_clearance(*navigator.obstacles(), body, robot, 1.0));
      if (step.status == NavigationStatus::GoalReached) return;
    }
  }
};

Base base_with(const Settings& settings, const Pose2& start, const Goal& goal) {
  Base base{.navigator = MapNavigator(settings, room()), .robot = start};
  base.navigator.set_goal(goal);
  return base;
}

// The disc that covers the body fits neither beside the wall nor may the body turn there.
TEST(OddSituations, ABodyParallelToAWallDrivesOff) {
  for (const double radius : {0.26, 0.52}) {
    for (const double side : {0.03, 0.1, 0.2}) {
      for (const double heading : {0.5, -0.5}) {
        Settings settings;
        settings.robot.length = 0.9;
        settings.robot.width = 0.5;
        settings.robot.radius = radius;
        const Pose2 start{.position = {0.05 + 0.25 + side, 4.0},
                          .heading = heading * std::numbers::pi};
        Base base = base_with(settings, start, {.position = {6.0, 4.0}});
        base.run(60.0);
        EXPECT_EQ(base.step.status, NavigationStatus::GoalReached)
            << "radius " << radius << ", " << side << " m from the wall";
        EXPECT_GT(base.nearest, 0.0) << "radius " << radius << ", " << side << " m from the wall";
      }
    }
  }
}

TEST(OddSituations, InFrontOfATakenGoalItStaysUntilTheObstacleLeaves) {
  for (const double reverse : {0.0, -0.5}) {
    for (const MovingObstacle& person : {MovingObstacle{.position = {8.0, 4.0}, .radius = 0.3},
                                         MovingObstacle{.position = {8.0, 4.0}, .radius = 0.8},
                                         MovingObstacle{.position = {8.0, 4.4}, .radius = 0.3}}) {
      Settings settings;
      settings.robot.linear_min = reverse;
      Base base = base_with(settings, {.position = {1.0, 4.0}}, {.position = {8.0, 4.0}});
      base.people = {person};
      base.run(30.0);
      base.turned = 0.0;
      base.driven = 0.0;
      base.run(30.0);
      EXPECT_LT(base.turned, 1.0) << person.radius;
      EXPECT_LT(base.driven, 0.2) << person.radius;
      EXPECT_EQ(base.step.status, NavigationStatus::Blocked);
      EXPECT_NE(base.step.limit, LimitingFactor::None);
      base.people.clear();
      base.run(30.0);
      EXPECT_EQ(base.step.status, NavigationStatus::GoalReached) << person.radius;
    }
  }
}

// Half a turn at 0.04 rad/s takes 80 s; patience would end the goal after 20 s.
TEST(OddSituations, SlowTurningIsProgress) {
  for (const std::optional<double>& at_goal :
       {std::optional<double>(), std::optional<double>(3.0)}) {
    Settings settings;
    settings.robot.angular_max = 0.04;
    settings.navigation.patience = 20.0;
    Base base =
        base_with(settings, {.position = {6.0, 4.0}}, {.position = {3.0, 4.0}, .heading = at_goal});
    base.run(200.0);
    EXPECT_EQ(base.step.status, NavigationStatus::GoalReached);
    EXPECT_LT(base.turned, 4.5);
  }
}

}  // namespace
}  // namespace fairway
