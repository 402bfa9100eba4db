// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/mpc/control_problem.hpp"
#include "fairway/navigation/facade/map_navigator.hpp"

namespace fairway::test {

/// A goal in the second room.
inline const Goal kGoal{.position = {10.5, 2.5}};

/// Two rooms, a wall at x = 6 m between them, and two doors in it.
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

/// A robot that executes its commands exactly, with the queries that tests need.
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

  // Runs until the goal is reached, at most for this time [s].
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

}  // namespace fairway::test
