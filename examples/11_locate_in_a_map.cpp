// SPDX-License-Identifier: Apache-2.0
// Wheels err by 3 % and by half a degree per metre; scans keep the pose in the map.
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <vector>

#include "fairway/fairway.hpp"

// A hall of 12 m x 8 m with walls and four pillars.
fairway::OccupancyGrid make_hall() {
  fairway::OccupancyGrid map({.width = 240, .height = 160, .resolution = 0.05, .origin = {}});
  for (int y = 0; y < 160; ++y) {
    for (int x = 0; x < 240; ++x) {
      const bool wall = x < 2 || x > 237 || y < 2 || y > 157;
      const bool pillar = x / 12 % 6 == 4 && y / 12 % 5 == 2;
      if (wall || pillar) map.set({x, y}, fairway::CellState::Occupied);
    }
  }
  return map;
}

// A lidar of 360 beams all round, at the robot's centre.
void measure(const fairway::OccupancyGrid& world,
             const fairway::Pose2& sensor,
             std::vector<float>& ranges) {
  for (std::size_t beam = 0; beam < ranges.size(); ++beam) {
    const double angle = -std::numbers::pi + static_cast<double>(beam) * std::numbers::pi / 180.0;
    const Eigen::Vector2d along = fairway::direction(sensor.heading + angle);
    double range = 0.0;
    while (range < 15.0 && world.at(world.frame().cell_at(sensor.position + range * along)) ==
                               fairway::CellState::Free) {
      range += 0.01;
    }
    ranges[beam] = static_cast<float>(range);
  }
}

int main() {
  fairway::Settings settings;
  const double period = settings.navigation.control_period;  // [s]
  const fairway::OccupancyGrid map = make_hall();
  fairway::Pose2 truth{.position = {1.5, 1.5}, .heading = 0.0};
  fairway::Pose2 odometry;  // of the wheels, in a frame of its own
  fairway::MapLocalization localization(map);
  localization.set_pose(odometry, truth);
  fairway::MapNavigator navigator(settings, map);
  navigator.set_goal({.position = {10.5, 6.5}});

  std::vector<float> ranges(360);
  for (double time = 0; time < 60; time += period) {
    measure(map, truth, ranges);
    localization.observe({.time = time,
                          .first_pose = odometry,
                          .last_pose = odometry,
                          .first_angle = -std::numbers::pi,
                          .angle_step = std::numbers::pi / 180.0,
                          .min_range = 0.1,
                          .max_range = 15.0,
                          .ranges = ranges});
    const fairway::MapPose found = localization.locate(odometry);
    const auto step = navigator.update({.time = time, .pose = found.pose});
    if (step.status == fairway::NavigationStatus::GoalReached) {
      const double off = (found.pose.position - truth.position).norm();
      const double sigma = std::sqrt(found.covariance.topLeftCorner<2, 2>().trace());
      std::printf("reached (%.2f, %.2f) in %.1f s; the pose is off by %.3f m, sigma %.3f m\n",
                  truth.position.x(), truth.position.y(), time, off, sigma);
      return off < 0.05 ? 0 : 1;
    }
    const fairway::Twist2 driven{.linear = 1.03 * step.command.linear,
                                 .angular = step.command.angular + 0.01 * step.command.linear};
    truth = fairway::step(truth, step.command, period, fairway::Integration::Midpoint);
    odometry = fairway::step(odometry, driven, period, fairway::Integration::Midpoint);
  }
  return 1;
}
