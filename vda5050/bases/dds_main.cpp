// SPDX-License-Identifier: Apache-2.0
// fairway_vda5050_dds: robots with ROS 2's topics, over DDS.
#include "bases/dds_link.hpp"
#include "bases/linked_robots.hpp"
#include "node/program.hpp"

namespace {

using namespace fairway::vda5050;

std::unique_ptr<RobotBases> make_bases(const NodeOptions& options) {
  const MiddlewareOptions& given = options.middleware;
  std::vector<std::unique_ptr<RobotLink>> links;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < options.vehicles.size(); ++i) {
    names.push_back(options.vehicles[i].serial);
    links.push_back(
        std::make_unique<DdsLink>(DdsLinkOptions{.domain = given.domain,
                                                 .space = given.spaces[i],
                                                 .name = names.back(),
                                                 .stamped = given.stamped,
                                                 .sensors = {.map_frame = given.map_frame,
                                                             .base_frame = given.base_frames[i],
                                                             .use_scan = given.use_scan}}));
  }
  return std::make_unique<LinkedRobots>(
      options.scenario.settings,
      LinkOptions{.use_scan = given.use_scan, .use_monitor = given.use_monitor}, std::move(links),
      std::move(names));
}

}  // namespace

int main(int argc, char** argv) { return run_program(argc, argv, RobotKind::Linked, make_bases); }
