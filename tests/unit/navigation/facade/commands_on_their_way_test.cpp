// SPDX-License-Identifier: Apache-2.0
// A base with a delay executes what was sent before, whatever happens to the navigator meanwhile.
#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "fairway/navigation/facade/map_navigator.hpp"
#include "fairway/navigation/navigator.hpp"
#include "fairway/safety/base_response.hpp"

namespace fairway {
namespace {

constexpr double kDoor = 7.0;         // [m]
constexpr double kLastMoment = 2.55;  // [m]: 0.6 s of delay and braking from 1.5 m/s at 1 m/s2

// A passage of 2 m, which a door may close.
OccupancyGrid passage_with_door(bool closed) {
  OccupancyGrid map({.width = 200, .height = 60, .resolution = 0.05, .origin = {}});
  for (int x = 0; x < 200; ++x) {
    for (int y = 0; y < 60; ++y) {
      if ((closed && x >= 140 && x < 145) || y < 10 || y >= 50)
        map.set({x, y}, CellState::Occupied);
    }
  }
  return map;
}

Settings late_base() {
  Settings settings;
  settings.robot.linear_delay = settings.robot.angular_delay = 0.6;
  settings.robot.linear_max = 1.5;
  settings.robot.linear_acceleration_max = 1.0;
  return settings;
}

// The robot, its slow base, and what was really sent to it.
struct LateDrive {
  explicit LateDrive(const Settings& given)
      : settings(given),
        navigator(given, passage_with_door(false)),
        actuation(actuation_of(given.robot)) {
    navigator.set_goal({.position = {9.0, 1.5}, .heading = {}});
  }

  // What is sent may differ from what the navigator says; then it is told to `differ`.
  NavigationStep cycle(const std::function<Twist2(const Twist2&)>& differ = {}) {
    // The door closes as late as the robot can still stop before it.
    if (!closed && kDoor - pose.position.x() < kLastMoment) {
      closed = true;
      navigator.set_map(passage_with_door(true));
    }
    const NavigationStep step = navigator.update({.time = time, .pose = pose});
    Twist2 sent = step.command;
    if (differ) sent = differ(step.command);
    const double period = settings.navigation.control_period;
    const auto ramp = [&](double from, double to, const AxisActuation& axis) {
      return std::max(period, change_time(from, to, axis));
    };
    const Twist2 reached = history.reached(time);
    history.send(time, sent,
                 {.linear = ramp(reached.linear, sent.linear, actuation.linear),
                  .angular = ramp(reached.angular, sent.angular, actuation.angular)});
    constexpr int kParts = 20;
    const double h = period / kParts;
    for (int i = 0; i < kParts; ++i) {
      const BaseResponse before = response;
      advance(response, history, actuation, time, time + h);
      const double v = 0.5 * (before.slow.linear + response.slow.linear);
      const double w = 0.5 * (before.slow.angular + response.slow.angular);
      pose.position += h * v * direction(pose.heading + 0.5 * h * w);
      pose.heading += h * w;
      time += h;
      touched = touched || pose.position.x() + settings.robot.radius > kDoor;
    }
    return step;
  }

  Settings settings;
  MapNavigator navigator;
  BaseActuation actuation;
  Pose2 pose{.position = {1.0, 1.5}, .heading = 0.0};
  double time = 0.0;
  CommandHistory history;
  BaseResponse response;
  bool closed = false;
  bool touched = false;
};

constexpr int kLateCycles = 100;

TEST(CommandsOnTheirWay, WithoutAnyEventTheRobotStopsAtTheDoor) {
  LateDrive drive(late_base());
  double fastest = 0.0;
  for (int i = 0; i < kLateCycles; ++i) {
    drive.cycle();
    fastest = std::max(fastest, drive.response.slow.linear);
  }
  EXPECT_TRUE(drive.closed);
  EXPECT_GT(fastest, 1.45);
  EXPECT_LT(drive.response.slow.linear, 0.01);
  EXPECT_GT(drive.pose.position.x() + drive.settings.robot.radius, kDoor - 0.3);
  EXPECT_FALSE(drive.touched);
}

// The place where the robot is when it answers to the next command.
Pose2 start_of_plan(const MapNavigator& navigator) { return navigator.navigator().problem().start; }

TEST(CommandsOnTheirWay, SurviveAChangeOfTheSettings) {
  LateDrive drive(late_base());
  LateDrive changed(late_base());
  for (int i = 0; i < 34; ++i) {  // before the door closes
    const NavigationStep step = drive.cycle();
    ASSERT_FALSE(drive.closed);
    changed.navigator.set_settings(late_base());
    changed.cycle([&](const Twist2&) {  // both bases are sent the same
      changed.navigator.replace_last(step.command);
      return step.command;
    });
    const Pose2 expected = start_of_plan(drive.navigator);
    const Pose2 start = start_of_plan(changed.navigator);
    ASSERT_LT((start.position - expected.position).norm(), 1e-6) << "cycle " << i;
  }
  EXPECT_GT(drive.response.slow.linear, 1.4);
}

TEST(CommandsOnTheirWay, AChangeOfTheSettingsInAnyCycleEndsInNoContact) {
  for (int event = 1; event < kLateCycles; ++event) {
    LateDrive drive(late_base());
    for (int i = 0; i < kLateCycles; ++i) {
      if (i >= event && i < event + 4) drive.navigator.set_settings(late_base());
      drive.cycle();
    }
    EXPECT_FALSE(drive.touched) << "changed in cycle " << event;
  }
}

// A monitor brakes harder than the navigator for a few cycles, and lets it go on then.
TEST(CommandsOnTheirWay, AMonitorThatIntervenesInAnyCycleCausesNoContact) {
  for (int event = 1; event < kLateCycles; ++event) {
    LateDrive drive(late_base());
    for (int i = 0; i < kLateCycles; ++i) {
      const bool intervenes = i >= event && i < event + 3;
      drive.cycle([&](const Twist2& command) {
        if (!intervenes) return command;
        const Twist2 reduced{.linear = 0.25 * command.linear, .angular = 0.25 * command.angular};
        drive.navigator.replace_last(reduced);
        return reduced;
      });
    }
    EXPECT_FALSE(drive.touched) << "intervened in cycle " << event;
  }
}

}  // namespace
}  // namespace fairway
