// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fairway/geometry/pose2.hpp"
#include "protocol/messages/action.hpp"
#include "protocol/messages/order.hpp"

namespace fairway::vda5050 {

/// Level of an error. Version 2 knows only Warning and Fatal; the others are written as Warning.
enum class ErrorLevel : std::uint8_t { Warning, Urgent, Critical, Fatal };

struct Reference {
  std::string key;
  std::string value;

  friend bool operator==(const Reference&, const Reference&) = default;
};

struct VehicleError {
  std::string type;
  ErrorLevel level = ErrorLevel::Warning;
  std::string description;
  std::vector<Reference> references;

  friend bool operator==(const VehicleError&, const VehicleError&) = default;
};

/// Operating modes; the first two take orders.
enum class OperatingMode : std::uint8_t {
  Automatic,
  Semiautomatic,
  Intervened,
  Manual,
  Service,
  TeachIn,
  Startup,
};

/// A point of the motion that the vehicle plans.
struct PlannedPoint {
  Pose2 pose;
  double time = 0.0;  ///< when the vehicle expects to be there [s since 1970]
};

/// What the vehicle measures and plans in a cycle.
struct VehicleMotion {
  Pose2 pose;
  Twist2 twist;
  bool localized = true;
  bool driving = false;                      ///< the base moves or turns
  std::string limit;                         ///< what limits the speed, for people; empty: nothing
  std::vector<Eigen::Vector2d> planned{};    ///< the path from the vehicle on [m]
  std::vector<PlannedPoint> intermediate{};  ///< the predicted motion
};

/// A node or edge that is still ahead.
struct GraphState {
  std::string id;
  std::uint32_t sequence = 0;
  std::string descriptor;
  bool released = false;
  std::optional<NodePosition> place{};     ///< of a node
  std::optional<Trajectory> trajectory{};  ///< of an edge, as given
};

/// Status of a request for leave.
enum class RequestStatus : std::uint8_t { Requested, Queued, Granted, Revoked, Expired };

/// A request for leave to use the corridor of an edge.
struct EdgeRequest {
  std::string id;
  std::string edge_id;
  std::uint32_t sequence = 0;
  RequestStatus status = RequestStatus::Requested;
};

/// A request for leave to enter a zone.
struct ZoneRequest {
  std::string id;
  std::string zone_id;
  std::string zone_set_id;
  RequestStatus status = RequestStatus::Requested;
};

struct ZoneSetState {
  std::string id;
  std::string map_id;
  bool enabled = false;
};

/// All that a state message says.
struct VehicleState {
  std::string map_id;
  std::vector<ZoneSetState> zone_sets;
  std::string order_id;
  std::uint32_t order_update = 0;
  std::string last_node_id;
  std::uint32_t last_node_sequence = 0;
  std::vector<GraphState> nodes;
  std::vector<GraphState> edges;
  std::vector<ActionState> actions;
  std::vector<ActionState> instant_actions;
  std::vector<EdgeRequest> edge_requests;
  std::vector<ZoneRequest> zone_requests;
  std::vector<VehicleError> errors;
  std::vector<std::string> traversed_nodes;  ///< nodes on the planned path
  bool paused = false;
  bool new_base_request = false;
  double distance_since_last_node = 0.0;  ///< [m]
  OperatingMode mode = OperatingMode::Automatic;
  VehicleMotion motion;
};

}  // namespace fairway::vda5050
