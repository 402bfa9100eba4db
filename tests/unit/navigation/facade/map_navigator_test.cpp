// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/facade/map_navigator.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "support/worlds/two_rooms.hpp"

namespace fairway {
namespace {

using test::Drive;
using test::kGoal;
using test::TwoRooms;

TEST(MapNavigator, DrivesToAGoal) {
  const TwoRooms rooms;
  MapNavigator navigator({}, rooms.map);
  navigator.set_goal(kGoal);
  Drive drive{navigator};
  EXPECT_TRUE(drive.reaches_goal(30.0));
  EXPECT_LT((drive.robot.position - kGoal.position).norm(), 0.12);
}

TEST(MapNavigator, StopsEarlyForAClosedDoorAndContinuesWhenItOpens) {
  TwoRooms rooms;
  MapNavigator navigator({}, rooms.map);
  navigator.set_goal(kGoal);
  Drive drive{navigator};
  drive.run(2.0);
  EXPECT_GT(drive.last.linear, 0.8);
  rooms.set_wall(2.0, 3.2, CellState::Occupied);
  navigator.update_map(rooms.map, {119, 0}, {121, 159});
  drive.run(3.0);
  EXPECT_EQ(drive.step.status, NavigationStatus::NoPlan);
  EXPECT_EQ(drive.step.limit, LimitingFactor::NoPath);
  EXPECT_EQ(drive.last.linear, 0.0);
  EXPECT_LT(drive.robot.position.x(), 4.2) << "it stopped before the wall";
  rooms.set_wall(2.0, 3.2, CellState::Free);
  navigator.update_map(rooms.map, {119, 0}, {121, 159});
  EXPECT_TRUE(drive.reaches_goal(30.0)) << "'no plan' is not final";
}

TEST(MapNavigator, UsesAnotherDoorWhenItsOwnCloses) {
  TwoRooms rooms;
  rooms.set_wall(5.0, 6.2, CellState::Free);
  MapNavigator navigator({}, rooms.map);
  navigator.set_goal(kGoal);
  Drive drive{navigator};
  drive.run(2.0);
  rooms.set_wall(2.0, 3.2, CellState::Occupied);
  navigator.update_map(rooms.map, {119, 0}, {121, 159});
  EXPECT_TRUE(drive.reaches_goal(40.0));
  EXPECT_FALSE(drive.has_seen(NavigationStatus::NoPlan));
}

TEST(MapNavigator, UsesAShorterPathThatOpens) {
  TwoRooms rooms;
  rooms.set_wall(2.0, 3.2, CellState::Occupied);
  rooms.set_wall(6.5, 7.7, CellState::Free);
  MapNavigator navigator({}, rooms.map);
  navigator.set_goal(kGoal);
  Drive drive{navigator};
  drive.run(1.0);
  const double detour = navigator.plan().path.length();
  rooms.set_wall(2.0, 3.2, CellState::Free);
  navigator.update_map(rooms.map, {119, 0}, {121, 159});
  drive.run(0.7);
  EXPECT_LT(navigator.plan().path.length(), detour - 1.0);
  EXPECT_TRUE(drive.reaches_goal(30.0));
}

TEST(MapNavigator, AChangedWindowIsEquivalentToANewMap) {
  TwoRooms rooms;
  MapNavigator by_window({}, rooms.map);
  MapNavigator by_map({}, rooms.map);
  by_window.set_goal(kGoal);
  by_map.set_goal(kGoal);
  Drive a{by_window};
  Drive b{by_map};
  for (int cycle = 0; cycle < 150; ++cycle) {
    if (cycle == 20 || cycle == 60) {
      rooms.set_wall(2.0, 3.2, cycle == 20 ? CellState::Occupied : CellState::Free);
      by_window.update_map(rooms.map, {120, 40}, {120, 63});
      by_map.set_map(rooms.map);
    }
    a.cycle();
    b.cycle();
    ASSERT_EQ(a.step.command.linear, b.step.command.linear) << cycle;
    ASSERT_EQ(a.step.command.angular, b.step.command.angular) << cycle;
    ASSERT_EQ(a.step.status, b.step.status) << cycle;
  }
}

TEST(MapNavigator, PlansInAThread) {
  TwoRooms rooms;
  Settings settings;
  settings.planning.background = true;
  MapNavigator navigator(settings, rooms.map);
  navigator.set_goal(kGoal);
  Drive drive{navigator};
  drive.cycle();
  EXPECT_EQ(drive.step.status, NavigationStatus::Planning);
  EXPECT_EQ(drive.step.command.linear, 0.0);
  navigator.wait_for_plan();
  drive.cycle();
  EXPECT_TRUE(navigator.follows_new_plan());
  drive.run(1.5);
  rooms.set_wall(2.0, 3.2, CellState::Occupied);
  rooms.set_wall(5.0, 6.2, CellState::Free);
  navigator.update_map(rooms.map, {119, 0}, {121, 159});
  for (int cycle = 0; cycle < 400 && drive.step.status != NavigationStatus::GoalReached; ++cycle) {
    drive.cycle();
    navigator.wait_for_plan();
  }
  EXPECT_EQ(drive.step.status, NavigationStatus::GoalReached);
}

TEST(MapNavigator, ExplainsInTheThreadWhyThereIsNoPath) {
  TwoRooms rooms;
  rooms.set_wall(0.0, 8.0, CellState::Occupied);
  rooms.set_wall(2.0, 2.4, CellState::Free);
  Settings settings;
  settings.planning.background = true;
  MapNavigator navigator(settings, rooms.map);
  navigator.set_goal(kGoal);
  Drive drive{navigator};
  drive.cycle();
  navigator.wait_for_plan();
  drive.cycle();
  EXPECT_EQ(drive.step.status, NavigationStatus::NoPlan);
  EXPECT_NE(navigator.explanation().find("0.400 m"), std::string::npos) << navigator.explanation();
  // Another goal has another reason.
  navigator.set_goal({.position = {20.0, 20.0}});
  EXPECT_EQ(navigator.explanation(), "");
  for (int cycle = 0; cycle < 2; ++cycle) {
    drive.cycle();
    navigator.wait_for_plan();
  }
  drive.cycle();
  EXPECT_NE(navigator.explanation(), "");
  EXPECT_EQ(navigator.explanation().find("0.400 m"), std::string::npos) << navigator.explanation();
  navigator.set_goal(kGoal);
  rooms.set_wall(2.0, 3.2, CellState::Free);
  navigator.update_map(rooms.map, {119, 0}, {121, 159});
  for (int cycle = 0; cycle < 20 && !navigator.plan().usable(); ++cycle) {
    drive.cycle();
    navigator.wait_for_plan();
  }
  EXPECT_EQ(navigator.explanation(), "");
}

TEST(MapNavigator, ANewGoalReplacesTheUnfinishedPlan) {
  const TwoRooms rooms;
  Settings settings;
  settings.planning.background = true;
  MapNavigator navigator(settings, rooms.map);
  navigator.set_goal(kGoal);
  Drive drive{navigator};
  drive.cycle();
  navigator.set_goal({.position = {2.5, 6.5}});
  for (int cycle = 0; cycle < 200 && drive.step.status != NavigationStatus::GoalReached; ++cycle) {
    drive.cycle();
    navigator.wait_for_plan();
  }
  EXPECT_LT((drive.robot.position - Eigen::Vector2d(2.5, 6.5)).norm(), 0.12);
}

// The robot uses the further of two doors, because the path leads there.
TEST(MapNavigator, FollowsAPathFromAnotherPlanner) {
  TwoRooms rooms;
  rooms.set_wall(6.0, 7.2, CellState::Free);
  MapNavigator navigator({}, rooms.map);
  navigator.follow({.waypoints = {{1.5, 2.5}, {5.0, 6.6}, {7.0, 6.6}, {10.5, 2.6}}}, 0.5);
  Drive drive{navigator};
  double highest = 0.0;
  for (int cycle = 0; cycle < 400 && drive.step.status != NavigationStatus::GoalReached; ++cycle) {
    drive.cycle();
    highest = std::max(highest, drive.robot.position.y());
  }
  EXPECT_EQ(drive.step.status, NavigationStatus::GoalReached);
  EXPECT_GT(highest, 6.0);
  EXPECT_NEAR(drive.robot.heading, 0.5, 0.11);
}

TEST(MapNavigator, APathThatLeavesTheMapIsNotReachedAtItsEdge) {
  const TwoRooms rooms;
  MapNavigator navigator({}, rooms.map);
  navigator.follow({.waypoints = {{1.5, 2.5}, {1.5, 4.0}, {1.5, 7.0}, {1.5, 12.0}}});
  Drive drive{navigator};
  EXPECT_FALSE(drive.reaches_goal(15.0));
  EXPECT_EQ(drive.step.status, NavigationStatus::Blocked);
  EXPECT_GT(drive.robot.position.y(), 6.5);
}

// The limits hold per control period, for any step length of the horizon.

}  // namespace
}  // namespace fairway
