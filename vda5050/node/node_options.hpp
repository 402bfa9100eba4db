// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fairway/base/error.hpp"
#include "fairway/simulation/physics.hpp"
#include "fairway/simulation/scenario.hpp"
#include "node/broker_connection.hpp"
#include "node/fleet_file.hpp"

namespace fairway::vda5050 {

/// What robots behind a middleware need besides their names.
struct MiddlewareOptions {
  std::vector<std::string> spaces;       ///< namespace of each robot's topics
  std::vector<std::string> base_frames;  ///< frame of each robot
  std::string map_frame = "map";
  std::uint32_t domain = 0;  ///< ROS_DOMAIN_ID, of DDS
  bool stamped = false;      ///< commands as TwistStamped, of DDS
  bool use_scan = true;
  bool use_monitor = true;
};

/// What the command line of fairway_vda5050 asks for.
struct NodeOptions {
  BrokerAddress broker;
  std::vector<VehicleIdentity> vehicles;  ///< one per robot of the scenario
  Scenario scenario;                      ///< map, settings, robots and sensing
  PhysicsMaker physics;                   ///< empty for the unicycle
  std::string map_id;
  double speed = 1.0;              ///< simulated seconds in a second
  std::optional<int> page{};       ///< port of the live page; 0 takes a free one
  MiddlewareOptions middleware{};  ///< of robots behind a middleware
};

/// The options, or how the program ends at once.
struct ParsedOptions {
  NodeOptions options;
  bool only_help = false;  ///< the help was printed
};

/// Reads the command line and the files that it names.
[[nodiscard]] Expected<ParsedOptions> parse_options(int argc, char** argv, RobotKind kind);

}  // namespace fairway::vda5050
