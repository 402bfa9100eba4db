// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include "fairway_ros/navigation_node.hpp"
#include "fairway_ros/orderly_exit.hpp"

int main(int argc, char** argv) {
  using namespace fairway;
  ros::init(argc, argv, "fairway", ros::init_options::NoSigintHandler);
  ros1::take_over_exit();
  ros::NodeHandle own("~");
  ros1::NodeOptions options;
  Settings settings;
  if (const Expected<void> read = ros1::read_parameters(own, options, settings); !read) {
    std::fprintf(stderr, "fairway: %s: %s\n", own.getNamespace().c_str(),
                 read.error().message.c_str());
    return 2;
  }
  ros1::NavigationNode node(settings, options);
  while (ros::ok() && !ros1::exit_wanted()) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.002));
    node.tick();
  }
  node.stop();
  ros::shutdown();
  return 0;
}
