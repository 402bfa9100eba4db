// SPDX-License-Identifier: Apache-2.0
// Sends one goal like `ros2 topic pub`, on machines without ROS 2.
#include <cstdio>

#include <CLI/CLI.hpp>

#include "bridge/message_conversions.hpp"
#include "fairway_dds/dds_conversions.hpp"
#include "fairway_dds/navigation_node.hpp"

int main(int argc, char** argv) {
  using namespace fairway;
  CLI::App app("Sends a goal to a robot over DDS");
  std::vector<double> goal;
  std::uint32_t domain = 0;
  std::string space;
  std::string frame = "map";
  app.add_option("--goal", goal, "x,y or x,y,heading [m, rad]")
      ->delimiter(',')
      ->expected(2, 3)
      ->required();
  app.add_option("--domain", domain, "ROS_DOMAIN_ID")->check(CLI::Range(0, 232));
  app.add_option("--namespace", space, "Namespace of the robot's topics");
  app.add_option("--frame", frame);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "fairway: %s\n", error.what());
    return 2;
  }
  constexpr double kLongestWait = 10.0;  // [s]
  dds::Participant participant(domain, space);
  dds::Writer<geometry_msgs_msg_dds__PoseStamped_> writer(participant, "goal_pose", {});
  const double begin = dds::wall_time();
  while (!writer.is_read()) {
    if (dds::wall_time() - begin > kLongestWait) {
      std::fprintf(stderr, "fairway: %s has no reader\n",
                   participant.topic_name("goal_pose").c_str());
      return 1;
    }
    dds_sleepfor(20'000'000);
  }
  geometry_msgs_msg_dds__PoseStamped_ message{};
  message.header = dds::header(frame, dds::wall_time());
  bridge::set_pose({.position = {goal[0], goal[1]}, .heading = goal.size() > 2 ? goal[2] : 0.0},
                   message.pose);
  writer.send(message);
  // Ends only after the reader has received the goal.
  dds_wait_for_acks(writer.get(), 2'000'000'000);
  return 0;
}
