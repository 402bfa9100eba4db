// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "protocol/vehicle/vehicle.hpp"

namespace fairway::vda5050::test {

using nlohmann::json;

/// Shape of the orders that `lanes` makes.
struct LaneOrder {
  std::string id = "lanes";
  std::uint32_t update = 0;
  std::uint32_t first = 0;     ///< index of the first node
  std::uint32_t nodes = 4;     ///< number of nodes
  std::uint32_t released = 4;  ///< of these, how many are released
  double width = 0.5;          ///< of the corridors to both sides [m]
  bool release_required = false;
};

/// The fleet control of a test: makes messages for a vehicle and reads what it publishes.
class FleetDouble {
 public:
  explicit FleetDouble(ProtocolVersion version, VehicleDescription description = {})
      : version_(version),
        vehicle({.version = version, .interface_name = {}}, std::move(description), "floor") {
    vehicle.set_pose_setter([](const Pose2&) { return true; });
    move_to({0.0, 0.0});
  }

  [[nodiscard]] bool third() const { return is_v3(version_); }

  [[nodiscard]] json header() const {
    return {{"headerId", 0},
            {"timestamp", "2026-11-30T08:00:00.00Z"},
            {"version", to_text(version_)},
            {"manufacturer", "Fairway"},
            {"serialNumber", "amr1"}};
  }

  [[nodiscard]] json deviation(double radius) const {
    if (!third()) return radius;
    return {{"a", radius}, {"b", radius}, {"theta", 0.0}};
  }

  [[nodiscard]] json node(std::uint32_t index, bool released) const {
    return {{"nodeId", "n" + std::to_string(index)},
            {"sequenceId", 2 * index},
            {"released", released},
            {"nodePosition",
             {{"x", 2.0 * index},
              {"y", 0.0},
              {"mapId", "floor"},
              {"allowedDeviationXY", deviation(0.3)}}},
            {"actions", json::array()}};
  }

  [[nodiscard]] json edge(std::uint32_t index, bool released, const LaneOrder& lane) const {
    json edge{{"edgeId", "e" + std::to_string(index)},
              {"sequenceId", 2 * index + 1},
              {"released", released},
              {"corridor", {{"leftWidth", lane.width}, {"rightWidth", lane.width}}},
              {"actions", json::array()}};
    if (lane.release_required) edge["corridor"]["releaseRequired"] = true;
    if (third()) return edge;
    edge["startNodeId"] = "n" + std::to_string(index);
    edge["endNodeId"] = "n" + std::to_string(index + 1);
    return edge;
  }

  /// An order along the x axis: node i lies at (2 i, 0).
  [[nodiscard]] json lanes(const LaneOrder& lane) const {
    json order = header();
    order["orderId"] = lane.id;
    order["orderUpdateId"] = lane.update;
    order["nodes"] = json::array();
    order["edges"] = json::array();
    for (std::uint32_t i = 0; i < lane.nodes; ++i) {
      order["nodes"].push_back(node(lane.first + i, i < lane.released));
      if (i > 0) order["edges"].push_back(edge(lane.first + i - 1, i < lane.released, lane));
    }
    return order;
  }

  [[nodiscard]] json instant(const std::string& type,
                             const std::string& id,
                             const json& parameters = json::object()) const {
    json message = header();
    json action{{"actionType", type}, {"actionId", id}, {"blockingType", "NONE"}};
    action["actionParameters"] = json::array();
    for (const auto& [key, value] : parameters.items())
      action["actionParameters"].push_back({{"key", key}, {"value", value}});
    message["actions"] = json::array({action});
    return message;
  }

  /// Whether the state has an error of this kind.
  [[nodiscard]] bool has_error(Fault fault) const {
    const auto found = errors();
    return std::find(found.begin(), found.end(), type(fault)) != found.end();
  }

  void send(Topic topic, const json& message) { vehicle.receive(topic, message.dump(), time); }
  void send_order(const LaneOrder& lane) { send(Topic::Order, lanes(lane)); }
  void send_instant(const std::string& type,
                    const std::string& id,
                    const json& parameters = json::object()) {
    send(Topic::InstantActions, instant(type, id, parameters));
  }

  /// Moves the vehicle to a place within one cycle.
  void move_to(const Eigen::Vector2d& place, bool driving = false, bool arrived = false) {
    time += 0.1;
    VehicleMotion motion;
    motion.pose.position = place;
    motion.driving = driving;
    motion.twist.linear = driving ? 0.5 : 0.0;
    vehicle.update(motion, {.route = vehicle.route_revision(), .arrived = arrived}, time);
  }

  /// Drives along the x axis in steps of 0.1 m.
  void drive(double from, double to) {
    for (double x = from; x < to; x += 0.1)
      move_to({x, 0.0}, true);
    move_to({to, 0.0}, true);
  }

  /// Stops at the end of the route.
  void arrive(double x) {
    move_to({x, 0.0}, false, true);
    move_to({x, 0.0}, false, true);
  }

  /// Stops at the end of the present leg, on the x axis.
  void stop_at_node(double x) {
    time += 0.1;
    VehicleMotion motion;
    motion.pose.position = {x, 0.0};
    vehicle.update(motion, {.route = vehicle.route_revision(), .at_node = true}, time);
  }

  /// The next state message.
  [[nodiscard]] json state() {
    time += 1.0;
    for (const OutgoingMessage& message : vehicle.take_messages(time)) {
      if (message.topic == Topic::State) return json::parse(message.payload);
    }
    return {};
  }

  /// Types of the errors in the state, each once per error.
  [[nodiscard]] std::vector<std::string> errors() const {
    std::vector<std::string> types;
    for (const VehicleError& error : vehicle.state().errors)
      types.push_back(error.type);
    return types;
  }

  /// The type of a fault in this version.
  [[nodiscard]] std::string type(Fault fault) const { return type_of(fault, version_); }

  /// Status of an instant action; empty if it is not listed.
  [[nodiscard]] std::string instant_status(const std::string& id) const {
    for (const ActionState& action : vehicle.state().instant_actions) {
      if (action.id == id) return to_text(action.status);
    }
    return {};
  }

  /// Status of an action of the order; empty if it is not listed.
  [[nodiscard]] std::string action_status(const std::string& id) const {
    for (const ActionState& action : vehicle.state().actions) {
      if (action.id == id) return to_text(action.status);
    }
    return {};
  }

 private:
  ProtocolVersion version_;

 public:
  Vehicle vehicle;
  double time = 1.8e9;
};

}  // namespace fairway::vda5050::test
