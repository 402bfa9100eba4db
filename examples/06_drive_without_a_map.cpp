// SPDX-License-Identifier: Apache-2.0
// Lidar scans go in, velocity commands come out: there is no map.
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <vector>

#include "fairway/fairway.hpp"

// The true world, which the robot does not know: a wall with a gap at its upper end.
bool occupied(const Eigen::Vector2d& point) {
  const bool in_wall = std::abs(point.x() - 4.0) < 0.1 && point.y() < 2.5;
  const bool in_room = point.x() > -1.0 && point.x() < 9.0 && std::abs(point.y()) < 4.0;
  return in_wall || !in_room;
}

// A lidar of 360 beams all round, at the robot's centre.
void measure(const fairway::Pose2& sensor, std::vector<float>& ranges) {
  for (std::size_t beam = 0; beam < ranges.size(); ++beam) {
    const double angle = -std::numbers::pi + static_cast<double>(beam) * std::numbers::pi / 180.0;
    const Eigen::Vector2d along = fairway::direction(sensor.heading + angle);
    double range = 0.0;
    while (range < 15.0 && !occupied(sensor.position + range * along))
      range += 0.01;
    ranges[beam] =
        range < 15.0 ? static_cast<float>(range) : std::numeric_limits<float>::infinity();
  }
}

int main() {
  fairway::Settings settings;
  settings.robot.radius = 0.25;
  const double period = settings.navigation.control_period;  // [s]
  fairway::Pose2 robot;                                      // from odometry on a real robot
  fairway::MaplessNavigator navigator(settings, robot.position);
  navigator.set_goal({.position = {8, 0}});

  std::vector<float> ranges(360);
  for (double time = 0; time < 60; time += period) {
    measure(robot, ranges);
    navigator.observe({.time = time,
                       .first_pose = robot,
                       .last_pose = robot,
                       .first_angle = -std::numbers::pi,
                       .angle_step = std::numbers::pi / 180.0,
                       .min_range = 0.1,
                       .max_range = 15.0,
                       .ranges = ranges},
                      robot.position);
    const auto step = navigator.update({.time = time, .pose = robot});
    if (step.status == fairway::NavigationStatus::GoalReached) {
      std::printf("reached (%.2f, %.2f) in %.1f s\n", robot.position.x(), robot.position.y(), time);
      return 0;
    }
    robot = fairway::step(robot, step.command, period, fairway::Integration::Midpoint);
  }
  return 1;
}
