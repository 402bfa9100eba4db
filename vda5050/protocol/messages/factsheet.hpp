// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "fairway/geometry/robot_settings.hpp"
#include "protocol/messages/protocol_version.hpp"

namespace fairway::vda5050 {

/// An action of nodes and edges that the vehicle can do; it takes a fixed time.
struct OrderAction {
  std::string type;
  double duration = 0.0;  ///< [s]
};

/// What the factsheet says beyond the settings of the robot.
struct VehicleDescription {
  RobotSettings robot;
  std::vector<OrderAction> order_actions{};
  double height = 0.3;                  ///< [m]
  std::size_t most_nodes = 1000;        ///< of an order
  double state_interval = 1.0;          ///< longest time between states [s]
  double least_state_interval = 0.1;    ///< shortest time between states [s]
  double visualization_interval = 0.1;  ///< [s]
};

/// Writes the body of the factsheet: all fields but the header.
[[nodiscard]] nlohmann::json factsheet_json(const VehicleDescription& description,
                                            ProtocolVersion version);

}  // namespace fairway::vda5050
