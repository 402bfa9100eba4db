// SPDX-License-Identifier: Apache-2.0
// fairway_vda5050_ros: robots of ROS 1.
#include <stdexcept>

#include <ros/init.h>
#include <ros/master.h>

#include "bases/linked_robots.hpp"
#include "bases/ros1_link.hpp"
#include "node/program.hpp"

namespace {

using namespace fairway::vda5050;

std::unique_ptr<RobotBases> make_bases(const NodeOptions& options) {
  if (!ros::master::check())
    throw std::runtime_error("expected a ROS master at " + ros::master::getURI() + ", found none");
  fairway::ros1::take_over_exit();
  const MiddlewareOptions& given = options.middleware;
  std::vector<std::unique_ptr<RobotLink>> links;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < options.vehicles.size(); ++i) {
    names.push_back(options.vehicles[i].serial);
    links.push_back(std::make_unique<Ros1Link>(
        given.spaces[i], fairway::ros1::SensorOptions{.map_frame = given.map_frame,
                                                      .base_frame = given.base_frames[i],
                                                      .use_scan = given.use_scan}));
  }
  return std::make_unique<LinkedRobots>(
      options.scenario.settings,
      LinkOptions{.use_scan = given.use_scan, .use_monitor = given.use_monitor}, std::move(links),
      std::move(names));
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "fairway_vda5050", ros::init_options::NoSigintHandler);
  const int code = run_program(argc, argv, RobotKind::Linked, make_bases);
  ros::shutdown();
  return code;
}
