// SPDX-License-Identifier: Apache-2.0
// A map goes in, velocity commands come out.
#include <cstdio>

#include "fairway/fairway.hpp"

int main() {
  fairway::OccupancyGrid map({.width = 200, .height = 120, .resolution = 0.05, .origin = {}});
  for (int y = 0; y < 80; ++y)
    map.set({100, y}, fairway::CellState::Occupied);

  const fairway::Settings settings;
  const double period = settings.navigation.control_period;  // [s]
  fairway::MapNavigator navigator(settings, map);
  navigator.set_goal({.position = {9, 1}});
  fairway::Pose2 robot{.position = {1, 1}, .heading = 0};

  for (double time = 0; time < 60; time += period) {
    const auto step = navigator.update({.time = time, .pose = robot});
    if (step.status == fairway::NavigationStatus::GoalReached) {
      std::printf("reached (%.2f, %.2f) in %.1f s\n", robot.position.x(), robot.position.y(), time);
      return 0;
    }
    // Your robot base goes here.
    robot = fairway::step(robot, step.command, period, fairway::Integration::Midpoint);
  }
  return 1;
}
