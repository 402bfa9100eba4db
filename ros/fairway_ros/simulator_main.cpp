// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include "fairway_ros/simulator_node.hpp"

int main(int argc, char** argv) {
  using namespace fairway;
  ros::init(argc, argv, "fairway_simulator");
  const ros::NodeHandle own("~");
  const Expected<Scenario> scenario = ros1::read_simulation(own);
  if (!scenario) {
    std::fprintf(stderr, "fairway: %s\n", scenario.error().message.c_str());
    return 2;
  }
  ros1::SimulatorNode simulator(*scenario);
  while (ros::ok()) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.002));
    simulator.tick();
  }
  return 0;
}
