// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include <CLI/CLI.hpp>

#include "fairway/io/maps/map_file.hpp"
#include "fairway/io/scenario/robot_model_file.hpp"
#include "fairway_dds/orderly_exit.hpp"
#include "fairway_dds/simulator.hpp"

int main(int argc, char** argv) {
  using namespace fairway;
  CLI::App app("Simulates a robot with ROS 2's topics, over DDS");
  std::string map;
  std::vector<double> start{0.0, 0.0, 0.0};
  dds::SimulatorOptions options;
  std::string body;
  bool noise = false;
  app.add_option("map", map, "map_server YAML file")->required();
  app.add_option("--start", start, "x,y,heading")->delimiter(',')->expected(3);
  app.add_option("--domain", options.domain, "ROS_DOMAIN_ID")->check(CLI::Range(0, 232));
  app.add_option("--namespace", options.space, "Namespace of the robot's topics");
  app.add_option("--track", options.track, "Write the true poses to this CSV file");
  app.add_flag("--stamped", options.stamped, "Receive commands as TwistStamped");
  app.add_flag("--sim-time", options.sim_time, "Publish a simulated time on /clock");
  app.add_option("--body", body, "File (YAML) with the outline and the base of the robot");
  app.add_flag("--noise", noise, "Add the standard errors of lidar and odometry");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "fairway: %s\n", error.what());
    return 2;
  }
  const Expected<OccupancyGrid> grid = io::read_map(map);
  if (!grid) {
    std::fprintf(stderr, "fairway: %s\n", grid.error().message.c_str());
    return 2;
  }
  Scenario scenario;
  scenario.map = *grid;
  const Pose2 pose{.position = {start[0], start[1]}, .heading = start[2]};
  scenario.robots = {{.name = "robot", .start = pose, .goal = {.position = pose.position}}};
  if (!body.empty()) {
    const Expected<RobotModel> read = io::read_robot_model(body);
    if (!read) {
      std::fprintf(stderr, "fairway: %s\n", read.error().message.c_str());
      return 2;
    }
    scenario.robots.front().model = *read;
    describe_models(scenario);
  }
  if (noise) use_standard_noise(scenario.sensing);
  try {
    dds::take_over_exit();
    dds::Simulator simulator(scenario, options);
    while (dds::exits_wanted == 0)
      simulator.tick();
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "fairway: %s\n", error.what());
    return 2;
  }
  return 0;
}
