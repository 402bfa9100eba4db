// SPDX-License-Identifier: Apache-2.0
// A map goes in, velocity commands come out.
#include <cstdio>

#include "fairway/navigation/navigator.hpp"
#include "fairway/planning/planner.hpp"
#include "fairway/simulation/unicycle_robot.hpp"

int main() {
  fairway::OccupancyGrid grid({.width = 200, .height = 120, .resolution = 0.05, .origin = {}});
  for (int y = 0; y < 80; ++y)
    grid.set({100, y}, fairway::CellState::Occupied);

  const fairway::PreparedMap map(grid);
  const fairway::Settings settings;
  fairway::Planner planner;
  fairway::Navigator navigator(settings);
  fairway::UnicycleRobot robot{.pose = {.position = {1, 1}, .heading = 0}};
  navigator.follow(
      planner.plan(map, robot.pose.position, {.position = {9, 1}}, planner_settings(settings)));

  for (double time = 0; time < 60; time += settings.navigation.control_period) {
    const auto step = navigator.update({.time = time,
                                        .pose = robot.pose,
                                        .pose_time = time,
                                        .map = &map.obstacles,
                                        .map_time = time});
    if (step.status == fairway::NavigationStatus::GoalReached) {
      std::printf("reached (%.2f, %.2f) in %.1f s\n", robot.pose.position.x(),
                  robot.pose.position.y(), time);
      return 0;
    }
    robot.advance(step.command, settings.navigation.control_period);  // your robot base goes here
  }
  return 1;
}
