// SPDX-License-Identifier: Apache-2.0
// Gives any scans, poses, obstacles and times to a navigator on a map, and to a safety monitor.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "byte_source.hpp"
#include "fairway/monitor/safety_monitor.hpp"
#include "fairway/navigation/facade/map_navigator.hpp"

namespace {

using fairway::test::ByteSource;

// Usually something plausible, sometimes any double.
double odd(ByteSource& bytes, double low, double high) {
  return bytes.chance(0.1) ? bytes.number() : bytes.usual(low, high);
}

fairway::Pose2 pose(ByteSource& bytes) {
  return {.position = {odd(bytes, 0.0, 4.0), odd(bytes, 0.0, 3.0)},
          .heading = odd(bytes, -3.2, 3.2)};
}

fairway::Twist2 twist(ByteSource& bytes) {
  return {.linear = odd(bytes, -1.0, 1.0), .angular = odd(bytes, -1.5, 1.5)};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ByteSource bytes(data, size);
  fairway::Settings settings;
  settings.planning.background = false;
  const fairway::OccupancyGrid map({.width = 80, .height = 60, .resolution = 0.05, .origin = {}});
  fairway::MapNavigator navigator(settings, map);
  navigator.set_goal({.position = {3.4, 2.4}, .heading = {}});
  fairway::SafetyMonitor monitor(
      {.footprint = {{{-0.2, -0.2}, {0.2, -0.2}, {0.2, 0.2}, {-0.2, 0.2}}}, .delay = 0.2});
  std::vector<float> ranges;
  std::vector<Eigen::Vector2d> points;
  fairway::Twist2 sent;
  for (int cycle = 0; cycle < 8 && bytes.left(); ++cycle) {
    const double time = odd(bytes, 0.1 * cycle, 0.1 * cycle + 0.01);
    ranges.clear();
    points.clear();
    for (int i = bytes.integer(0, 40); i > 0; --i) {
      ranges.push_back(static_cast<float>(odd(bytes, 0.1, 4.0)));
      points.emplace_back(odd(bytes, 0.0, 4.0), odd(bytes, 0.0, 3.0));
    }
    fairway::LidarScan scan;
    scan.time = time;
    scan.first_pose = pose(bytes);
    scan.last_pose = bytes.chance(0.5) ? scan.first_pose : pose(bytes);
    scan.first_angle = odd(bytes, -3.2, 0.0);
    scan.angle_step = odd(bytes, -0.2, 0.2);
    scan.min_range = odd(bytes, 0.0, 0.2);
    scan.max_range = odd(bytes, 1.0, 10.0);
    scan.ranges = ranges;
    (void)navigator.observe(scan, scan.first_pose.position);
    const fairway::Pose2 robot = pose(bytes);
    const fairway::NavigationStep step = navigator.update({.time = time, .pose = robot});
    if (!is_finite(step.command) ||
        std::abs(step.command.linear) > settings.robot.linear_max + 1e-9)
      std::abort();
    (void)monitor.see(time, points);
    const fairway::MonitorVerdict verdict =
        monitor.check(time, robot, sent, bytes.chance(0.5) ? step.command : twist(bytes));
    if (!is_finite(verdict.command) || !(verdict.fraction >= 0.0 && verdict.fraction <= 1.0))
      std::abort();
    if (verdict.fraction < 1.0) navigator.replace_last(verdict.command);
    sent = verdict.command;
  }
  return 0;
}
