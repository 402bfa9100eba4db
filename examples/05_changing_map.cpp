// SPDX-License-Identifier: Apache-2.0
// A door closes while the robot drives to it, and later another one opens. A thread makes the
// plans.
#include <cstdio>

#include "fairway/fairway.hpp"

using fairway::NavigationStatus;

// Makes the wall's cells from `low` to `high` [m] obstacles, or free.
void set_door(fairway::OccupancyGrid& map, double low, double high, fairway::CellState state) {
  for (double y = low; y < high; y += map.frame().resolution)
    map.set(map.frame().cell_at({6.0, y}), state);
}

int main() {
  fairway::Settings settings;
  settings.planning.background = true;
  settings.navigation.patience = 30.0;  // [s] without progress
  fairway::OccupancyGrid map({.width = 240, .height = 160, .resolution = 0.05, .origin = {}});
  set_door(map, 0.0, 8.0, fairway::CellState::Occupied);
  set_door(map, 2.0, 3.2, fairway::CellState::Free);

  fairway::MapNavigator navigator(settings, map);
  navigator.set_goal({.position = {10.5, 2.5}});
  fairway::Pose2 robot{.position = {1.5, 2.5}, .heading = 0.0};
  NavigationStatus last = NavigationStatus::NoPlan;
  const double period = settings.navigation.control_period;
  for (int cycle = 0; cycle < 900; ++cycle) {
    if (cycle == 20) set_door(map, 2.0, 3.2, fairway::CellState::Occupied);
    if (cycle == 80) set_door(map, 5.0, 6.2, fairway::CellState::Free);
    if (cycle == 20 || cycle == 80) navigator.update_map(map, {119, 0}, {121, 159});

    const auto step = navigator.update({.time = cycle * period, .pose = robot});
    robot = fairway::step(robot, step.command, period, fairway::Integration::Midpoint);
    navigator.wait_for_plan();  // only because this loop is faster than real time
    if (step.status == last) continue;
    last = step.status;
    std::printf("%5.1f s  (%.2f, %.2f)  %s: %s\n", cycle * period, robot.position.x(),
                robot.position.y(), to_text(step.status), to_text(step.limit));
    switch (step.status) {
      case NavigationStatus::GoalReached:
        return 0;
      case NavigationStatus::GaveUp:    // set another goal, or call for help
      case NavigationStatus::BadInput:  // an invalid pose or goal: a bug in this program
        return 1;
      case NavigationStatus::Planning:    // wait
      case NavigationStatus::NoPlan:      // both doors are closed: the navigator plans again by
                                          // itself
      case NavigationStatus::Blocked:     // wait, or remove the obstacle
      case NavigationStatus::Stale:       // check localisation and sensors
      case NavigationStatus::Infeasible:  // the robot brakes; report it
      case NavigationStatus::Stopping:
      case NavigationStatus::Recovering:
      case NavigationStatus::Degraded:
      case NavigationStatus::Holding:
      case NavigationStatus::Ok:
        break;
    }
  }
  return 1;
}
