// SPDX-License-Identifier: Apache-2.0
// Three robots whose paths cross publish what they intend, and each drives around the others.
#include <array>
#include <cstdio>
#include <vector>

#include "fairway/fairway.hpp"

struct Robot {
  fairway::MapNavigator navigator;
  fairway::Pose2 pose;
  fairway::SharedMotion message{};
  bool arrived = false;
};

int main() {
  const fairway::OccupancyGrid map({.width = 200, .height = 200, .resolution = 0.05, .origin = {}});
  const fairway::Settings settings;
  const double period = settings.navigation.control_period;  // [s]
  const std::array<Eigen::Vector2d, 3> starts = {{{1, 5}, {8, 1.5}, {8, 8.5}}};
  const std::array<Eigen::Vector2d, 3> goals = {{{9, 5}, {2, 8.5}, {2, 1.5}}};
  std::vector<Robot> robots;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector2d along = goals[i] - starts[i];
    robots.push_back(
        {.navigator = fairway::MapNavigator(settings, map),
         .pose = {.position = starts[i], .heading = std::atan2(along.y(), along.x())}});
    robots[i].navigator.set_goal({.position = goals[i]});
    robots[i].message =
        robots[i].navigator.share(static_cast<std::uint32_t>(i), 0.0, robots[i].pose);
  }

  std::vector<fairway::FleetMember> others;
  for (double time = 0; time < 60; time += period) {
    bool all_arrived = true;
    for (std::size_t i = 0; i < 3; ++i) {
      others.clear();
      for (std::size_t j = 0; j < 3; ++j) {
        if (j != i) others.push_back({.motion = &robots[j].message});
      }
      Robot& robot = robots[i];
      const auto number = static_cast<std::uint32_t>(i);
      const auto step = robot.navigator.update(
          {.time = time, .pose = robot.pose, .fleet = others, .robot = number});
      robot.message = robot.navigator.share(number, time, robot.pose);
      robot.arrived = step.status == fairway::NavigationStatus::GoalReached;
      robot.pose = fairway::step(robot.pose, step.command, period, fairway::Integration::Midpoint);
      all_arrived = all_arrived && robot.arrived;
    }
    if (all_arrived) {
      std::printf("all arrived after %.1f s\n", time);
      return 0;
    }
  }
  return 1;
}
