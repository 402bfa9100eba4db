// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/navigation/facade/map_navigator.hpp"
#include "support/worlds/two_rooms.hpp"

namespace fairway {
namespace {

using test::Drive;
using test::kGoal;
using test::TwoRooms;

TEST(MapNavigator, RefusesAWindowOfAnotherMap) {
  const TwoRooms rooms;
  MapNavigator navigator({}, rooms.map);
  const OccupancyGrid other({.width = 10, .height = 10, .resolution = 0.05, .origin = {}});
  EXPECT_THROW(navigator.update_map(other, {0, 0}, {1, 1}), std::invalid_argument);
}

TEST(MapNavigator, ReportsInvalidGoals) {
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
  EXPECT_TRUE(drive.reaches_goal(30.0)) << "a valid goal after invalid ones";
}

TEST(MapNavigator, ReportsInvalidMeasurements) {
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

TEST(MapNavigator, RefusesPlacesThatOverflowAGrid) {
  const TwoRooms rooms;
  MapNavigator navigator({}, rooms.map);
  Drive drive{navigator};
  for (const double far : {1.1e7, 1e12, 1e300, 1e308, -1e308}) {
    navigator.set_goal({.position = {far, 2.5}});
    drive.cycle();
    EXPECT_EQ(drive.step.limit, LimitingFactor::InvalidGoal) << far;
    navigator.set_goal(kGoal);
    NavigationStep step = navigator.update({.time = drive.time, .pose = {.position = {far, 2.5}}});
    EXPECT_EQ(step.limit, LimitingFactor::InvalidPose) << far;
    const std::vector<MovingObstacle> people{{.position = {4.0, far}, .radius = 0.3}};
    step = navigator.update({.time = drive.time, .pose = drive.robot, .obstacles = people});
    EXPECT_EQ(step.limit, LimitingFactor::InvalidTracks) << far;
  }
  navigator.set_goal(kGoal);
  navigator.reset();
  drive.last = {};
  EXPECT_TRUE(drive.reaches_goal(30.0)) << "nothing of that has lasting effects";
}

// The robot stops as without a scan, says why, and drives on with the next good one.
TEST(MapNavigator, RefusesAScanThatCannotBe) {
  const TwoRooms rooms;
  MapNavigator navigator({}, rooms.map);
  navigator.set_goal(kGoal);
  Drive drive{navigator};
  const std::vector<float> ranges(90, 20.0F);
  const auto scan_now = [&](double angle_step) {
    return navigator.observe({.time = drive.time,
                              .first_pose = drive.robot,
                              .last_pose = drive.robot,
                              .first_angle = -3.0,
                              .angle_step = angle_step,
                              .min_range = 0.05,
                              .max_range = 10.0,
                              .ranges = ranges},
                             drive.robot.position);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 20; ++i) {
    EXPECT_TRUE(scan_now(0.06));
    drive.cycle();
  }
  EXPECT_GT(drive.last.linear, 0.3);
  for (int i = 0; i < 30; ++i) {
    EXPECT_FALSE(scan_now(nan));
    drive.cycle();
  }
  EXPECT_EQ(drive.step.status, NavigationStatus::Stale);
  EXPECT_EQ(drive.step.limit, LimitingFactor::InvalidScan);
  EXPECT_EQ(drive.last.linear, 0.0);
  for (int i = 0; i < 20; ++i) {
    EXPECT_TRUE(scan_now(0.06));
    drive.cycle();
  }
  EXPECT_GT(drive.last.linear, 0.3);
}

// A plan that is being made when the settings change is for the older ones, and is not used.
TEST(MapNavigator, TakesNoPlanThatWasMadeWithOlderSettings) {
  const TwoRooms rooms;
  Settings settings;
  settings.planning.background = true;
  MapNavigator navigator(settings, rooms.map);
  navigator.set_goal(kGoal);
  Drive drive{navigator};
  drive.cycle();
  EXPECT_EQ(drive.step.status, NavigationStatus::Planning);
  settings.robot.radius = 0.45;
  navigator.set_settings(settings);
  for (int i = 0; i < 5 && !navigator.plan_is_current(); ++i) {
    navigator.wait_for_plan();
    drive.cycle();
  }
  ASSERT_TRUE(navigator.plan_is_current());
  EXPECT_GE(navigator.plan().corridor.robot_radius, 0.85 * 0.45);
}

TEST(MapNavigator, DetectsTimesInMilliseconds) {
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
  navigator.set_goal({.position = {6.02, 6.0}});  // inside the wall
  Drive drive{navigator};
  drive.run(2.9);
  EXPECT_EQ(drive.step.status, NavigationStatus::NoPlan);
  drive.run(0.3);
  EXPECT_EQ(drive.step.status, NavigationStatus::GaveUp);
  navigator.set_goal(kGoal);
  EXPECT_TRUE(drive.reaches_goal(30.0)) << "a new goal starts a new attempt";
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

TEST(MapNavigator, ContinuesWithOtherSettings) {
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
  EXPECT_TRUE(drive.reaches_goal(60.0)) << "and the settings are unchanged";
}

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
