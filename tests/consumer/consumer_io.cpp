// SPDX-License-Identifier: Apache-2.0
// Reads a map and settings from files, and drives a simulated base.
// Usage: consumer_io MAP.yaml SETTINGS.yaml
#include <cstdio>

#include "fairway/fairway.hpp"
#include "fairway/io/maps/map_file.hpp"
#include "fairway/io/yaml/settings_file.hpp"
#include "fairway/simulation/unicycle_robot.hpp"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const auto map = fairway::io::read_map(argv[1]);
  const auto settings = fairway::io::read_settings(argv[2]);
  if (!map || !settings) {
    std::fprintf(stderr, "%s\n", (map ? settings.error() : map.error()).message.c_str());
    return 2;
  }
  fairway::MapNavigator navigator(*settings, *map);
  navigator.set_goal({.position = {22.2, 14.6}});
  fairway::UnicycleRobot robot;
  robot.pose.position = {2.0, 4.4};
  const double period = settings->navigation.control_period;
  for (double time = 0; time < 120; time += period) {
    const auto step = navigator.update({.time = time, .pose = robot.pose});
    if (step.status == fairway::NavigationStatus::GoalReached) return 0;
    robot.advance(step.command, period);
  }
  return 1;
}
