// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "protocol/messages/action.hpp"
#include "protocol/messages/protocol_version.hpp"
#include "protocol/messages/trajectory.hpp"

namespace fairway::vda5050 {

/// The ellipse about a node in which the vehicle may pass it; version 2 has a radius. All zero: as
/// exactly as the vehicle can.
struct NodeDeviation {
  double a = 0.0;      ///< semi-axis along `theta` [m]
  double b = 0.0;      ///< the other semi-axis [m]
  double theta = 0.0;  ///< from the x axis of the map to the axis `a` [rad]
};

/// The place of a node.
struct NodePosition {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m]
  std::optional<double> theta{};                       ///< heading required at the node [rad]
  double theta_deviation = 0.0;                        ///< about theta [rad]; 0: own tolerance
  NodeDeviation deviation;
  std::string map_id;
};

struct OrderNode {
  std::string id;
  std::uint32_t sequence = 0;
  std::string descriptor;
  bool released = false;
  NodePosition place;
  std::vector<Action> actions;
};

/// What the vehicle does when the leave for a corridor ends.
enum class ReleaseLoss : std::uint8_t { Stop, Return };

/// The strip along an edge in which the vehicle may leave its trajectory.
struct Corridor {
  double left = 0.0;     ///< width to the left of the direction of travel [m]
  double right = 0.0;    ///< [m]
  bool contour = false;  ///< the whole body stays inside; otherwise its reference point
  bool release_required = false;
  ReleaseLoss release_loss = ReleaseLoss::Stop;
};

struct OrderEdge {
  std::string id;
  std::uint32_t sequence = 0;
  std::string descriptor;
  bool released = false;
  std::optional<double> speed_max{};  ///< [m/s]
  std::optional<Trajectory> trajectory{};
  std::optional<Corridor> corridor{};
  std::vector<Action> actions;
};

/// An order, or an update of one: nodes and the edges between them.
struct Order {
  std::string id;
  std::uint32_t update = 0;
  std::vector<OrderNode> nodes;
  std::vector<OrderEdge> edges;
  nlohmann::json graph;  ///< nodes and edges as given, to compare repeated messages
};

/// Why an order cannot be used.
struct OrderFault {
  enum class Kind : std::uint8_t {
    Invalid,      ///< not an order: schema, graph, released order or knots
    Unsupported,  ///< a field of the standard that this vehicle does not honour
    TooLarge,
  };
  Kind kind = Kind::Invalid;
  std::vector<std::string> fields{};  ///< paths of the fields
  std::string text;                   ///< expected ..., found ...
};

/// What a vehicle can honour in an order.
struct OrderAbilities {
  double angular_max = 1.5;  ///< [rad/s]; a lower limit of an edge is refused
  double height = 0.3;       ///< of the vehicle [m]
  std::size_t most_nodes = 1000;
};

/// Reads an order and checks all that does not depend on the vehicle's state.
/// @return the fault, or none; `order` is complete only without a fault, but holds the ids.
[[nodiscard]] std::optional<OrderFault> read_order(const nlohmann::json& message,
                                                   ProtocolVersion version,
                                                   const OrderAbilities& abilities,
                                                   Order& order);

}  // namespace fairway::vda5050
