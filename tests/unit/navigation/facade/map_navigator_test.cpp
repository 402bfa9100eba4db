// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/facade/map_navigator.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/mpc/control_problem.hpp"

namespace fairway {
namespace {

const Goal kGoal{.position = {10.5, 2.5}};

// Two rooms, a wall at x = 6 m between them, and two doors in it.
class TwoRooms {
 public:
  TwoRooms() {
    set_wall(0.0, 8.0, CellState::Occupied);
    set_wall(2.0, 3.2, CellState::Free);
  }

  OccupancyGrid map{{.width = 240, .height = 160, .resolution = 0.05, .origin = {}}};

  void set_wall(double low, double high, CellState state) {
    for (double y = low; y < high - 1e-9; y += 0.05)
      map.set(map.frame().cell_at({6.01, y + 0.01}), state);
  }
};

// A robot that does what it is told, and everything that a test asks about its drive.
struct Drive {
  MapNavigator& navigator;
  Pose2 robot{.position = {1.5, 2.5}, .heading = 0.0};
  double time = 0.0;
  Twist2 last{};
  NavigationStep step{};
  std::vector<NavigationStatus> statuses{};

  void cycle() {
    const Settings& settings = navigator.settings();
    const double period = settings.navigation.control_period;
    step = navigator.update({.time = time, .pose = robot});
    ASSERT_TRUE(is_finite(step.command));
    EXPECT_LE(std::abs(step.command.linear - last.linear),
              settings.robot.linear_acceleration_max * period + 1e-9);
    EXPECT_LE(std::abs(step.command.angular - last.angular),
              settings.robot.angular_acceleration_max * period + 1e-9);
    // The base ramps from command to command.
    robot = fairway::step(robot,
                          {.linear = 0.5 * (last.linear + step.command.linear),
                           .angular = 0.5 * (last.angular + step.command.angular)},
                          period, Integration::Midpoint);
    last = step.command;
    time += period;
    statuses.push_back(step.status);
  }

  // Until the goal is reached, for at most so long [s].
  bool reaches_goal(double limit) {
    for (const double end = time + limit; time < end;) {
      cycle();
      if (step.status == NavigationStatus::GoalReached) return true;
    }
    return false;
  }

  void run(double duration) {
    for (const double end = time + duration; time < end - 1e-9;)
      cycle();
  }

  [[nodiscard]] bool has_seen(NavigationStatus status) const {
    return std::find(statuses.begin(), statuses.end(), status) != statuses.end();
  }
};

TEST(MapNavigator, DrivesToAGoal) {
  const TwoRooms rooms;
  MapNavigator navigator({}, rooms.map);
  navigator.set_goal(kGoal);
  Drive drive{navigator};
  EXPECT_TRUE(drive.reaches_goal(30.0));
  EXPECT_LT((drive.robot.position - kGoal.position).norm(), 0.12);
}

TEST(MapNavigator, StopsLongBeforeADoorThatClosesAndGoesOnWhenItOpens) {
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
  EXPECT_LT(drive.robot.position.x(), 4.2) << "it did not drive up to the wall";
  rooms.set_wall(2.0, 3.2, CellState::Free);
  navigator.update_map(rooms.map, {119, 0}, {121, 159});
  EXPECT_TRUE(drive.reaches_goal(30.0)) << "'no plan' is not final";
}

TEST(MapNavigator, TakesAnotherDoorWhenItsOwnCloses) {
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

TEST(MapNavigator, TakesAShorterWayThatOpens) {
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

TEST(MapNavigator, AWindowThatChangedIsAsGoodAsAnotherMap) {
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

TEST(MapNavigator, RefusesAWindowOfAnotherMap) {
  const TwoRooms rooms;
  MapNavigator navigator({}, rooms.map);
  const OccupancyGrid other({.width = 10, .height = 10, .resolution = 0.05, .origin = {}});
  EXPECT_THROW(navigator.update_map(other, {0, 0}, {1, 1}), std::invalid_argument);
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

TEST(MapNavigator, ANewGoalReplacesThePlanThatIsBeingMade) {
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

TEST(MapNavigator, AnswersGoalsThatCannotBe) {
  const TwoRooms rooms;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  MapNavigator navigator({}, rooms.map);
  Drive drive{navigator};
  for (const Goal& bad :
       {Goal{.position = {nan, 0.0}}, Goal{.position = {1.0, 2.0}, .heading = nan},
        Goal{.position = {1.0, 2.0}, .heading = 90.0}}) {
    navigator.set_goal(bad);
    drive.cycle();
    EXPECT_EQ(drive.step.status, NavigationStatus::BadInput);
    EXPECT_EQ(drive.step.limit, LimitingFactor::InvalidGoal);
  }
  navigator.follow({.waypoints = {{1.5, 2.5}, {nan, 3.0}, {4.0, 2.5}}});
  drive.cycle();
  EXPECT_EQ(drive.step.limit, LimitingFactor::InvalidGoal);
  navigator.set_goal(kGoal);
  EXPECT_TRUE(drive.reaches_goal(30.0)) << "a good goal after bad ones";
}

TEST(MapNavigator, AnswersMeasurementsThatCannotBe) {
  const TwoRooms rooms;
  MapNavigator navigator({}, rooms.map);
  navigator.set_goal(kGoal);
  const Pose2 pose{.position = {1.5, 2.5}, .heading = 0.0};
  const std::vector<MovingObstacle> negative{{.position = {4, 2.5}, .radius = -0.3}};
  NavigationStep step = navigator.update({.time = 0.0, .pose = pose, .obstacles = negative});
  EXPECT_EQ(step.limit, LimitingFactor::InvalidTracks);
  EXPECT_EQ(step.status, NavigationStatus::BadInput);
  step = navigator.update({.time = 0.1, .pose = {.position = {1.5, 2.5}, .heading = 90.0}});
  EXPECT_EQ(step.limit, LimitingFactor::InvalidPose);
  step = navigator.update({.time = 0.2, .pose = pose, .pose_time = -1.0});
  EXPECT_EQ(step.limit, LimitingFactor::StalePose);
  EXPECT_EQ(step.status, NavigationStatus::Stale);
}

TEST(MapNavigator, NoticesTimesInMilliseconds) {
  const TwoRooms rooms;
  MapNavigator navigator({}, rooms.map);
  navigator.set_goal(kGoal);
  NavigationStep step;
  for (int cycle = 0; cycle < 5; ++cycle) {
    step = navigator.update({.time = 100.0 * cycle, .pose = {.position = {1.5, 2.5}}});
  }
  EXPECT_EQ(step.status, NavigationStatus::BadInput);
  EXPECT_EQ(step.limit, LimitingFactor::InvalidTime);
  EXPECT_EQ(step.command.linear, 0.0);
}

TEST(MapNavigator, StaysStoppedWithoutAMap) {
  MapNavigator navigator{Settings{}};
  navigator.set_goal(kGoal);
  const NavigationStep step = navigator.update({.time = 0.0, .pose = {.position = {1.5, 2.5}}});
  EXPECT_EQ(step.limit, LimitingFactor::StaleMap);
  EXPECT_EQ(step.command.linear, 0.0);
}

TEST(MapNavigator, GivesUpWithoutProgress) {
  const TwoRooms rooms;
  Settings settings;
  settings.navigation.patience = 3.0;
  MapNavigator navigator(settings, rooms.map);
  navigator.set_goal({.position = {6.02, 6.0}});  // in the wall
  Drive drive{navigator};
  drive.run(2.9);
  EXPECT_EQ(drive.step.status, NavigationStatus::NoPlan);
  drive.run(0.3);
  EXPECT_EQ(drive.step.status, NavigationStatus::GaveUp);
  navigator.set_goal(kGoal);
  EXPECT_TRUE(drive.reaches_goal(30.0)) << "a new goal is a new start";
}

// Through the further of two doors, because the path says so.
TEST(MapNavigator, FollowsAPathThatSomebodyElseMade) {
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

TEST(MapNavigator, CancelBrakesToAStandstill) {
  const TwoRooms rooms;
  MapNavigator navigator({}, rooms.map);
  navigator.set_goal(kGoal);
  Drive drive{navigator};
  drive.run(2.0);
  navigator.cancel();
  drive.run(1.0);
  EXPECT_EQ(drive.last.linear, 0.0);
  EXPECT_EQ(drive.step.status, NavigationStatus::NoPlan);
}

TEST(MapNavigator, DrivesOnWithOtherSettings) {
  const TwoRooms rooms;
  MapNavigator navigator({}, rooms.map);
  navigator.set_goal(kGoal);
  Drive drive{navigator};
  drive.run(1.5);
  Settings slow;
  slow.robot.linear_max = 0.3;
  navigator.set_settings(slow);
  drive.run(1.5);
  EXPECT_NEAR(drive.last.linear, 0.3, 0.02);
  Settings bad;
  bad.robot.radius = -1.0;
  EXPECT_THROW(navigator.set_settings(bad), std::invalid_argument);
  EXPECT_TRUE(drive.reaches_goal(60.0)) << "and nothing changed";
}

// The limits hold per control period, whatever the step length of the horizon is.
TEST(MapNavigator, TheControlPeriodIsNotTheStepLength) {
  const TwoRooms rooms;
  for (const double period : {0.02, 0.05, 0.1, 0.2}) {
    Settings settings;
    settings.navigation.control_period = period;
    MapNavigator navigator(settings, rooms.map);
    navigator.set_goal(kGoal);
    Drive drive{navigator};
    EXPECT_TRUE(drive.reaches_goal(30.0)) << period;
    EXPECT_LT(drive.time, 14.0) << period;
  }
}

}  // namespace
}  // namespace fairway
