// SPDX-License-Identifier: Apache-2.0
// Drives with a map and settings from files: 10_read_files MAP.yaml SETTINGS.yaml X,Y X,Y
#include <cstdio>

#include "fairway/fairway.hpp"
#include "fairway/io/maps/map_file.hpp"
#include "fairway/io/yaml/settings_file.hpp"

int main(int argc, char** argv) {
  Eigen::Vector2d start;
  Eigen::Vector2d goal;
  if (argc != 5 || std::sscanf(argv[3], "%lf,%lf", &start.x(), &start.y()) != 2 ||
      std::sscanf(argv[4], "%lf,%lf", &goal.x(), &goal.y()) != 2) {
    std::fprintf(stderr, "usage: %s MAP.yaml SETTINGS.yaml X,Y X,Y\n", argv[0]);
    return 2;
  }
  const auto map = fairway::io::read_map(argv[1]);
  const auto settings = fairway::io::read_settings(argv[2]);
  if (!map || !settings) {
    std::fprintf(stderr, "%s\n", (map ? settings.error() : map.error()).message.c_str());
    return 2;
  }
  fairway::MapNavigator navigator(*settings, *map);
  navigator.set_goal({.position = goal});
  fairway::Pose2 robot{.position = start};
  const double period = settings->navigation.control_period;
  for (double time = 0; time < 120; time += period) {
    const auto step = navigator.update({.time = time, .pose = robot});
    if (step.status == fairway::NavigationStatus::GoalReached) {
      std::printf("reached the goal in %.1f s\n", time);
      return 0;
    }
    if (step.status == fairway::NavigationStatus::NoPlan) {
      std::printf("no plan: %s\n", navigator.plan().reason());
      return 1;
    }
    robot = fairway::step(robot, step.command, period, fairway::Integration::Midpoint);
  }
  return 1;
}
