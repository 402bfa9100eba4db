// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fairway/base/error.hpp"
#include "fairway/simulation/physics.hpp"
#include "fairway/simulation/scenario.hpp"
#include "node/broker_connection.hpp"

namespace fairway::vda5050 {

/// What the command line of fairway_vda5050 asks for.
struct NodeOptions {
  BrokerAddress broker;
  std::vector<VehicleIdentity> vehicles;  ///< one per robot of the scenario
  Scenario scenario;                      ///< map, settings, robots and sensing
  PhysicsMaker physics;                   ///< empty for the unicycle
  std::string map_id;
  double speed = 1.0;         ///< simulated seconds in a second
  std::optional<int> page{};  ///< port of the live page; 0 takes a free one
};

/// The options, or how the program ends at once.
struct ParsedOptions {
  NodeOptions options;
  bool only_help = false;  ///< the help was printed
};

/// Reads the command line and the files that it names.
[[nodiscard]] Expected<ParsedOptions> parse_options(int argc, char** argv);

}  // namespace fairway::vda5050
