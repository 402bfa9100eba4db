// SPDX-License-Identifier: Apache-2.0
// The functions of a MapNavigator beside goals and changing maps: scans, shared maps, plans on
// request, other frames.
#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/mpc/interior_point/real_time_solver.hpp"
#include "fairway/navigation/facade/map_navigator.hpp"
#include "fairway/planning/planner.hpp"
#include "fairway/simulation/sensors/lidar.hpp"
#include "fairway/simulation/sensors/noise.hpp"
#include "support/worlds/two_rooms.hpp"

namespace fairway {
namespace {

using test::Drive;
using test::kGoal;
using test::TwoRooms;

TEST(MapNavigatorInterface, ASharedMapPlannerAndSolverGiveTheSameDrive) {
  const TwoRooms rooms;
  const PreparedMap map{BitGrid(rooms.map)};
  Planner planner;
  RealTimeSolver solver{MpcSettings{}};
  MapNavigator shared({}, map, planner, solver);
  MapNavigator own({}, rooms.map);
  shared.set_goal(kGoal);
  own.set_goal(kGoal);
  Drive a{shared};
  Drive b{own};
  for (int cycle = 0; cycle < 60; ++cycle) {
    a.cycle();
    b.cycle();
    ASSERT_EQ(a.step.command.linear, b.step.command.linear) << cycle;
    ASSERT_EQ(a.step.command.angular, b.step.command.angular) << cycle;
  }
}

TEST(MapNavigatorInterface, AChangeOfTheSharedMapLeadsToAnotherPlan) {
  TwoRooms rooms;
  PreparedMap map{BitGrid(rooms.map)};
  Planner planner;
  RealTimeSolver solver{MpcSettings{}};
  MapNavigator navigator({}, map, planner, solver);
  navigator.set_goal(kGoal);
  Drive drive{navigator};
  drive.run(1.0);
  rooms.set_wall(2.0, 3.2, CellState::Occupied);
  rooms.set_wall(6.0, 7.2, CellState::Free);
  map = PreparedMap{BitGrid(rooms.map)};
  navigator.map_changed();
  double highest = 0.0;
  for (int cycle = 0; cycle < 400 && drive.step.status != NavigationStatus::GoalReached; ++cycle) {
    drive.cycle();
    highest = std::max(highest, drive.robot.position.y());
  }
  EXPECT_EQ(drive.step.status, NavigationStatus::GoalReached);
  EXPECT_GT(highest, 6.0) << "through the other door";
}

TEST(MapNavigatorInterface, APlanOnRequestDoesNotDrive) {
  const TwoRooms rooms;
  MapNavigator navigator({}, rooms.map);
  navigator.set_goal(kGoal);
  EXPECT_FALSE(navigator.plan_is_current());
  EXPECT_TRUE(navigator.plan_now({.time = 0.0, .pose = {.position = {1.5, 2.5}}}));
  EXPECT_TRUE(navigator.plan_is_current());
  EXPECT_TRUE(navigator.plan().usable());
  EXPECT_EQ(navigator.share(0, 0.0, {.position = {1.5, 2.5}}).speed, 0.0);
  EXPECT_FALSE(navigator.plan_now({.time = 0.1, .pose = {.position = {1.5, 2.5}}}))
      << "none is needed again";
}

TEST(MapNavigatorInterface, NoPlanIsMadeWhileNothingChanges) {
  const TwoRooms rooms;
  MapNavigator navigator({}, rooms.map);
  navigator.set_goal(kGoal);
  Drive drive{navigator};
  drive.cycle();
  EXPECT_TRUE(navigator.planned());
  for (int cycle = 0; cycle < 60; ++cycle) {
    drive.cycle();
    EXPECT_FALSE(navigator.planned()) << cycle;
  }
}

TEST(MapNavigatorInterface, WithoutAPathAttemptsAreARetryPeriodApart) {
  TwoRooms rooms;
  rooms.set_wall(2.0, 3.2, CellState::Occupied);
  Settings settings;
  settings.planning.retry_period = 0.75;
  MapNavigator navigator(settings, rooms.map);
  navigator.set_goal(kGoal);
  Drive drive{navigator};
  std::vector<double> attempts;
  for (int cycle = 0; cycle < 60; ++cycle) {
    drive.cycle();
    if (navigator.planned()) attempts.push_back(drive.time);
  }
  ASSERT_GE(attempts.size(), 6U);
  for (std::size_t i = 1; i < attempts.size(); ++i)
    EXPECT_GT(attempts[i] - attempts[i - 1], 0.75 - 1e-9) << i;
}

TEST(MapNavigatorInterface, AnEmptyPathCancels) {
  const TwoRooms rooms;
  MapNavigator navigator({}, rooms.map);
  navigator.set_goal(kGoal);
  Drive drive{navigator};
  drive.run(1.0);
  navigator.follow({});
  drive.run(1.0);
  EXPECT_EQ(drive.last.linear, 0.0);
  EXPECT_EQ(drive.step.status, NavigationStatus::NoPlan);
}

TEST(MapNavigatorInterface, AMapInAnotherFrameReplacesTheOldOne) {
  const TwoRooms rooms;
  MapNavigator navigator({}, rooms.map);
  navigator.set_goal(kGoal);
  Drive drive{navigator};
  drive.run(1.0);
  // The same floor without its wall, in coarser cells that begin elsewhere.
  navigator.set_map(OccupancyGrid({.width = 160,
                                   .height = 100,
                                   .resolution = 0.1,
                                   .origin = {.position = {-2.0, -1.0}, .heading = 0.0}}));
  ASSERT_NE(navigator.obstacles(), nullptr);
  EXPECT_EQ(navigator.obstacles()->frame().resolution, 0.1);
  EXPECT_TRUE(drive.reaches_goal(30.0));
}

TEST(MapNavigatorInterface, AClockTimesThePlanOfTheCycleThatMadeIt) {
  const TwoRooms rooms;
  MapNavigator navigator({}, rooms.map);
  double now = 0.0;
  navigator.lend_clock([&] { return now += 1.0; });
  navigator.set_goal(kGoal);
  Drive drive{navigator};
  drive.cycle();
  EXPECT_GT(navigator.planning_seconds(), 0.0);
  drive.cycle();
  EXPECT_EQ(navigator.planning_seconds(), 0.0) << "this cycle made none";
}

// A drive with a lidar, on a map that lacks a post in the way.
class WithScans : public testing::Test {
 protected:
  WithScans() : navigator_({}, rooms_.map), world_(rooms_.map) {
    for (int x = 70; x < 78; ++x) {
      for (int y = 46; y < 54; ++y)
        world_.set({x, y}, true);
    }
    navigator_.set_goal(kGoal);
  }

  void scan() {
    scan_surroundings(lidar_, world_, {}, drive_.robot, noise_, ranges_);
    navigator_.observe({.time = drive_.time,
                        .first_pose = drive_.robot,
                        .last_pose = drive_.robot,
                        .first_angle = -0.5 * lidar_.field_of_view,
                        .angle_step = lidar_.field_of_view / (lidar_.beams - 1),
                        .max_range = lidar_.max_range,
                        .ranges = ranges_},
                       drive_.robot.position);
  }

  TwoRooms rooms_;
  MapNavigator navigator_;
  Drive drive_{navigator_};
  BitGrid world_;
  LidarModel lidar_;
  Noise noise_{1};
  std::vector<float> ranges_;
};

TEST_F(WithScans, AnObstacleThatTheMapDoesNotHaveIsAvoided) {
  double least = 10.0;  // distance of the robot's centre from the post's [m]
  for (int cycle = 0; cycle < 300 && drive_.step.status != NavigationStatus::GoalReached; ++cycle) {
    scan();
    drive_.cycle();
    least = std::min(least, (drive_.robot.position - Eigen::Vector2d(3.7, 2.5)).norm());
  }
  EXPECT_EQ(drive_.step.status, NavigationStatus::GoalReached);
  EXPECT_GT(least, 0.2 + 0.25) << "half of the post's side and the robot's radius";
}

TEST_F(WithScans, TheRobotStopsWhenScansCease) {
  for (int cycle = 0; cycle < 12; ++cycle) {
    scan();
    drive_.cycle();
  }
  EXPECT_GT(drive_.last.linear, 0.5);
  drive_.run(1.2);
  EXPECT_EQ(drive_.step.status, NavigationStatus::Stale);
  EXPECT_EQ(drive_.step.limit, LimitingFactor::StaleMap);
  EXPECT_EQ(drive_.last.linear, 0.0);
}

TEST_F(WithScans, ObstaclesOfMapAndScansAreThoseThatItKnows) {
  ASSERT_NE(navigator_.obstacles(), nullptr);
  const CellIndex face{.x = 70, .y = 50};
  EXPECT_FALSE(navigator_.obstacles()->blocked(face));
  for (int cycle = 0; cycle < 5; ++cycle) {
    scan();
    drive_.cycle();
  }
  bool seen = false;
  for (int x = 68; x < 73; ++x)
    seen = seen || navigator_.obstacles()->blocked({x, 50});
  EXPECT_TRUE(seen) << "the scanned face of the post";
  EXPECT_TRUE(navigator_.obstacles()->blocked(rooms_.map.frame().cell_at({6.01, 5.0}))) << "a wall";
}

}  // namespace
}  // namespace fairway
