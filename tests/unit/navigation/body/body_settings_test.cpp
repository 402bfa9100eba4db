// SPDX-License-Identifier: Apache-2.0
// A BodyNavigator whose settings change while it drives.
#include <atomic>
#include <cmath>
#include <latch>
#include <thread>

#include <gtest/gtest.h>

#include "fairway/navigation/body/body_navigator.hpp"

namespace fairway {
namespace {

// An empty hall of 12 m x 8 m.
OccupancyGrid empty_hall() {
  return OccupancyGrid({.width = 240, .height = 160, .resolution = 0.05, .origin = {}});
}

RobotModel small_platform() {
  RobotModel robot{.body = BodyShape::rectangle(0.8, 0.5, 0.4), .base = {}};
  robot.base.linear_max = 0.8;
  return robot;
}

// Three legs whose end is 2 m from their begin: a drive to the end alone would not use them.
PosePath long_way_round() {
  PosePath path;
  path.poses = {{.position = {2.0, 2.0}, .heading = {}},
                {.position = {6.0, 2.0}, .heading = {}},
                {.position = {6.0, 5.0}, .heading = {}},
                {.position = {2.0, 5.0}, .heading = {}}};
  path.max_deviation = 0.4;
  return path;
}

// The robot moves exactly as it is sent.
struct ExactRun {
  Pose2 pose{.position = {2.0, 2.0}, .heading = 0.0};
  double time = 0.0;
  double furthest = 0.0;

  NavigationStep cycle(BodyNavigator& navigator) {
    const NavigationStep step = navigator.update({.time = time, .pose = pose});
    const double period = navigator.settings().navigation.control_period;
    pose = moved(pose, {.linear = step.command.linear, .angular = step.command.angular}, period);
    time += period;
    furthest = std::max(furthest, pose.position.x());
    return step;
  }

  NavigationStatus drive(BodyNavigator& navigator, int cycles) {
    NavigationStatus last = NavigationStatus::NoPlan;
    for (int i = 0; i < cycles && last != NavigationStatus::GoalReached; ++i)
      last = cycle(navigator).status;
    return last;
  }
};

TEST(BodySettings, KeepThePathAndTheMotionWhenTheyChange) {
  Settings settings;
  settings.planning.background = false;
  BodyNavigator navigator(settings, small_platform(), empty_hall());
  navigator.follow(long_way_round());
  ExactRun run;
  run.drive(navigator, 30);
  ASSERT_TRUE(navigator.place_on_path());
  const double before = run.cycle(navigator).command.linear;
  ASSERT_GT(before, 0.5);
  settings.navigation.goal_tolerance = 0.08;
  navigator.set_settings(settings);
  EXPECT_EQ(navigator.settings().navigation.goal_tolerance, 0.08);
  EXPECT_GT(run.cycle(navigator).command.linear, before - 0.11) << "no stop";
  EXPECT_TRUE(navigator.place_on_path());
  EXPECT_EQ(run.drive(navigator, 400), NavigationStatus::GoalReached);
  EXPECT_GT(run.furthest, 5.5) << "it followed the path";
}

TEST(BodySettings, TheControlPeriodMayChangeWhileTheRobotDrives) {
  Settings settings;
  settings.planning.background = false;
  BodyNavigator navigator(settings, small_platform(), empty_hall());
  navigator.follow(long_way_round());
  ExactRun run;
  run.drive(navigator, 30);
  settings.navigation.control_period = 0.05;
  navigator.set_settings(settings);
  EXPECT_EQ(run.drive(navigator, 800), NavigationStatus::GoalReached);
  EXPECT_GT(run.furthest, 5.5);
}

TEST(BodySettings, RefusesInvalidOnesAndKeepsTheOld) {
  Settings settings;
  BodyNavigator navigator(settings, small_platform(), empty_hall());
  settings.navigation.control_period = -1.0;
  EXPECT_THROW(navigator.set_settings(settings), std::invalid_argument);
  EXPECT_EQ(navigator.settings().navigation.control_period, 0.1);
}

// The job asks for the time, and waits there until the test lets it go. A navigator that waits for
// it here would never return.
TEST(BodySettings, DoNotWaitForAPlanThatIsBeingMade) {
  Settings settings;
  settings.planning.background = true;
  std::latch blocked(1);
  std::latch may_go(1);
  std::atomic<bool> first = true;
  BodyNavigator navigator(settings, small_platform(), empty_hall());
  navigator.lend_clock([&] {
    if (first.exchange(false)) {
      blocked.count_down();
      may_go.wait();
    }
    return 0.0;
  });
  navigator.follow(long_way_round());
  ExactRun run;
  EXPECT_EQ(run.cycle(navigator).status, NavigationStatus::Planning);
  blocked.wait();
  settings.planning.background = false;  // later plans are made in the cycle
  navigator.set_settings(settings);
  EXPECT_EQ(run.cycle(navigator).status, NavigationStatus::Planning);
  may_go.count_down();
  navigator.wait_for_plan();
  EXPECT_EQ(run.drive(navigator, 400), NavigationStatus::GoalReached);
  EXPECT_GT(run.furthest, 5.5);
}

// A check behind the navigator brakes for three cycles; the drive goes on from there.
TEST(BodySettings, ACommandThatWasReducedIsNoEndOfTheDrive) {
  Settings settings;
  settings.planning.background = false;
  BodyNavigator navigator(settings, small_platform(), empty_hall());
  navigator.follow(long_way_round());
  ExactRun run;
  run.drive(navigator, 30);
  for (int i = 0; i < 3; ++i) {
    const NavigationStep step = navigator.update({.time = run.time, .pose = run.pose});
    EXPECT_GT(step.command.linear, 0.05) << "cycle " << i;
    const PlanarTwist reduced{.linear = 0.5 * step.command.linear,
                              .angular = 0.5 * step.command.angular};
    navigator.replace_last(reduced);
    run.pose = moved(run.pose, reduced, 0.1);
    run.time += 0.1;
  }
  const NavigationStep next = run.cycle(navigator);
  EXPECT_LT(next.command.linear, 0.5) << "it goes on from what was sent";
  EXPECT_EQ(run.drive(navigator, 400), NavigationStatus::GoalReached);
  EXPECT_GT(run.furthest, 5.5);
}

}  // namespace
}  // namespace fairway
