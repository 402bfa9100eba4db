// SPDX-License-Identifier: Apache-2.0
// CPU time of a command of the controller plugin, costmap conversion included, and arrival times,
// on doubles of ROS 2 and Nav2: nav2_cycle_times [REPEATS]. The robot is a unicycle, and paths for
// rectangles are planned in the cycle (planning.background false).
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include <people_msgs/msg/people.hpp>

#include "ros/nav2/plugin/plugin_rig.hpp"

namespace fairway::nav2 {
namespace {

using Parameters = std::map<std::string, rclcpp::ParameterValue>;

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Times {
  std::vector<double> commands;  // [s]
  double arrival = 0.0;          // [s]; 0: not within a minute
};

// One drive through a hall with posts; people cross it where `people` is set.
void drive(const Parameters& parameters, bool people, Times& times) {
  Parameters all = parameters;
  if (people) {
    all["FollowPath.obstacles_topic"] = rclcpp::ParameterValue(std::string("people"));
    all["FollowPath.obstacles_type"] = rclcpp::ParameterValue(std::string("people"));
  }
  PluginRig rig(all);
  for (const auto& [x, y] : {std::pair(70, 50), std::pair(120, 66), std::pair(170, 52)}) {
    for (int dx = 0; dx < 8; ++dx) {
      for (int dy = 0; dy < 8; ++dy)
        rig.ros->costmap.cells[static_cast<std::size_t>((y + dy) * 240 + x + dx)] = 254;
    }
  }
  rig.ros->footprint = {{0.4, 0.25, 0}, {-0.4, 0.25, 0}, {-0.4, -0.25, 0}, {0.4, -0.25, 0}};
  rig.configure();
  rig.set_path({{1, 3}, {11, 3}});
  times.arrival = 0.0;
  for (int i = 0; i < 600 && times.arrival == 0.0; ++i) {
    if (people) {
      people_msgs::msg::People message;
      message.header = header_at("odom", rig.now());
      for (int person = 0; person < 3; ++person) {
        const double y = std::fmod(1.0 + person + 0.08 * i, 5.0) + 0.5;
        message.people.push_back({.position = {3.0 + 3.0 * person, y, 0}, .velocity = {0, 0.8, 0}});
      }
      rig.update_clock();
      rig.node->publish("people", message);
    }
    const double before = thread_seconds();
    const double moved = rig.world.time();
    rig.step();
    times.commands.push_back(thread_seconds() - before);
    const bool there = (rig.robot().pose.position - Eigen::Vector2d(11, 3)).norm() < 0.15;
    if (there && std::abs(rig.robot().twist.linear) < 0.02) times.arrival = moved;
  }
}

void report(const char* name, Parameters parameters, bool people, int repeats) {
  parameters["FollowPath.robot.linear_min"] = rclcpp::ParameterValue(-0.3);
  Times times;
  for (int i = 0; i < repeats; ++i)
    drive(parameters, people, times);
  std::sort(times.commands.begin(), times.commands.end());
  const auto at = [&](double share) {
    const auto last = static_cast<double>(times.commands.size() - 1);
    return 1e3 * times.commands[static_cast<std::size_t>(share * last)];
  };
  std::printf("%-30s %8zu %8.3f %8.3f %8.3f %9.1f\n", name, times.commands.size(), at(0.5),
              at(0.99), at(1.0), times.arrival);
}

Parameters with_model(const char* model) {
  Parameters parameters;
  parameters["FollowPath.motion.model"] = rclcpp::ParameterValue(std::string(model));
  parameters["FollowPath.motion.wheelbase"] = rclcpp::ParameterValue(0.6);
  return parameters;
}

int run(int repeats) {
  std::printf("%-30s %8s %8s %8s %8s %9s\n", "240 x 120 cells", "commands", "median ms", "p99",
              "max", "arrival s");
  report("disc", {}, false, repeats);
  report("disc, three people", {}, true, repeats);
  report("rectangle, differential", with_model("differential"), false, repeats);
  report("rectangle, ackermann", with_model("ackermann"), false, repeats);
  return 0;
}

}  // namespace
}  // namespace fairway::nav2

int main(int argc, char** argv) {
  const int repeats = argc > 1 ? std::atoi(argv[1]) : 3;
  if (repeats < 1 || repeats > 1000) {
    std::fprintf(stderr, "nav2_cycle_times: expected 1 to 1000 repeats, found %s\n", argv[1]);
    return 2;
  }
  return fairway::nav2::run(repeats);
}
