// SPDX-License-Identifier: Apache-2.0
#include "protocol/messages/state_writer.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fairway/geometry/angle.hpp"
#include "protocol/messages/timestamp.hpp"

namespace fairway::vda5050 {

using nlohmann::json;

namespace {

const char* level_text(ErrorLevel level, bool third) {
  if (!third) return level == ErrorLevel::Fatal ? "FATAL" : "WARNING";
  static constexpr std::array<const char*, 4> kLevels{"WARNING", "URGENT", "CRITICAL", "FATAL"};
  return kLevels[static_cast<std::size_t>(level)];
}

const char* mode_text(OperatingMode mode, bool third) {
  switch (mode) {
    case OperatingMode::Automatic:
      return "AUTOMATIC";
    case OperatingMode::Semiautomatic:
      return "SEMIAUTOMATIC";
    case OperatingMode::Intervened:
      return third ? "INTERVENED" : "MANUAL";
    case OperatingMode::Manual:
      return "MANUAL";
    case OperatingMode::Service:
      return "SERVICE";
    case OperatingMode::TeachIn:
      return third ? "TEACH_IN" : "TEACHIN";
    case OperatingMode::Startup:
      return third ? "STARTUP" : "SERVICE";
  }
  return "MANUAL";
}

const char* request_text(RequestStatus status) {
  switch (status) {
    case RequestStatus::Requested:
    case RequestStatus::Queued:
      return "REQUESTED";
    case RequestStatus::Granted:
      return "GRANTED";
    case RequestStatus::Revoked:
      return "REVOKED";
    case RequestStatus::Expired:
      return "EXPIRED";
  }
  return "REQUESTED";
}

json position_json(const VehicleState& state, bool third) {
  const VehicleMotion& motion = state.motion;
  json position{{"x", motion.pose.position.x()},
                {"y", motion.pose.position.y()},
                {"theta", wrap_to_pi(motion.pose.heading)},
                {"mapId", state.map_id}};
  position[third ? "localized" : "positionInitialized"] = motion.localized;
  return position;
}

json velocity_json(const Twist2& twist) {
  return {{"vx", twist.linear}, {"vy", 0.0}, {"omega", twist.angular}};
}

json node_json(const GraphState& node, bool third) {
  json written{{"nodeId", node.id}, {"sequenceId", node.sequence}, {"released", node.released}};
  if (!node.descriptor.empty())
    written[third ? "nodeDescriptor" : "nodeDescription"] = node.descriptor;
  if (node.place) {
    json place{{"x", node.place->position.x()},
               {"y", node.place->position.y()},
               {"mapId", node.place->map_id}};
    if (node.place->theta) place["theta"] = wrap_to_pi(*node.place->theta);
    written["nodePosition"] = std::move(place);
  }
  return written;
}

json edge_json(const GraphState& edge, bool third) {
  json written{{"edgeId", edge.id}, {"sequenceId", edge.sequence}, {"released", edge.released}};
  if (!edge.descriptor.empty())
    written[third ? "edgeDescriptor" : "edgeDescription"] = edge.descriptor;
  if (edge.trajectory) written["trajectory"] = to_json(*edge.trajectory);
  return written;
}

json actions_json(const std::vector<ActionState>& actions, bool third) {
  json list = json::array();
  for (const ActionState& action : actions) {
    // The schema of version 2 has no PAUSED.
    const bool hidden = !third && action.status == ActionStatus::Paused;
    json written{{"actionId", action.id},
                 {"actionType", action.type},
                 {"actionStatus", to_text(hidden ? ActionStatus::Running : action.status)}};
    if (!action.result.empty())
      written[third ? "actionResult" : "resultDescription"] = action.result;
    list.push_back(std::move(written));
  }
  return list;
}

json references_json(const std::vector<Reference>& references) {
  json list = json::array();
  for (const Reference& reference : references)
    list.push_back({{"referenceKey", reference.key}, {"referenceValue", reference.value}});
  return list;
}

json errors_json(const std::vector<VehicleError>& errors, bool third) {
  json list = json::array();
  for (const VehicleError& error : errors) {
    json written{{"errorType", error.type}, {"errorLevel", level_text(error.level, third)}};
    if (!error.description.empty()) written["errorDescription"] = error.description;
    if (!error.references.empty()) written["errorReferences"] = references_json(error.references);
    list.push_back(std::move(written));
  }
  return list;
}

json information_json(const VehicleState& state, bool third) {
  json list = json::array();
  if (state.motion.limit.empty()) return list;
  list.push_back({{"infoType", "fairway.limit"},
                  {third ? "infoDescriptor" : "infoDescription", state.motion.limit},
                  {"infoLevel", "INFO"}});
  return list;
}

void add_paths(const VehicleState& state, json& message) {
  const VehicleMotion& motion = state.motion;
  std::vector<Eigen::Vector2d> path{motion.pose.position};
  constexpr std::size_t kMostPoints = 200;
  const std::size_t stride =
      std::max<std::size_t>(1, (motion.planned.size() + kMostPoints - 1) / kMostPoints);
  for (std::size_t i = 0; i < motion.planned.size(); ++i) {
    if (i % stride == 0 || i + 1 == motion.planned.size()) path.push_back(motion.planned[i]);
  }
  if (path.size() == 1) path.push_back(path.front());
  message["plannedPath"] = {{"trajectory", to_json(polyline_trajectory(path))},
                            {"traversedNodes", state.traversed_nodes}};
  json polyline = json::array();
  for (const PlannedPoint& point : motion.intermediate) {
    polyline.push_back({{"x", point.pose.position.x()},
                        {"y", point.pose.position.y()},
                        {"theta", wrap_to_pi(point.pose.heading)},
                        {"eta", to_timestamp(point.time)}});
  }
  message["intermediatePath"] = {{"polyline", std::move(polyline)}};
}

void add_third(const VehicleState& state, json& message) {
  message["mobileRobotPosition"] = position_json(state, true);
  message["powerSupply"] = {{"stateOfCharge", 100.0}, {"charging", false}};
  message["instantActionStates"] = actions_json(state.instant_actions, true);
  message["safetyState"] = {{"activeEmergencyStop", "NONE"}, {"fieldViolation", false}};
  json sets = json::array();
  for (const ZoneSetState& set : state.zone_sets) {
    sets.push_back({{"zoneSetId", set.id},
                    {"mapId", set.map_id},
                    {"zoneSetStatus", set.enabled ? "ENABLED" : "DISABLED"}});
  }
  message["zoneSets"] = std::move(sets);
  json requests = json::array();
  for (const EdgeRequest& request : state.edge_requests) {
    requests.push_back({{"requestId", request.id},
                        {"requestType", "CORRIDOR"},
                        {"edgeId", request.edge_id},
                        {"sequenceId", request.sequence},
                        {"requestStatus", request_text(request.status)}});
  }
  message["edgeRequests"] = std::move(requests);
  json access = json::array();
  for (const ZoneRequest& request : state.zone_requests) {
    // A request for a zone has no status of its own while it is queued.
    const RequestStatus status =
        request.status == RequestStatus::Queued ? RequestStatus::Requested : request.status;
    access.push_back({{"requestId", request.id},
                      {"requestType", "ACCESS"},
                      {"zoneId", request.zone_id},
                      {"zoneSetId", request.zone_set_id},
                      {"requestStatus", request_text(status)}});
  }
  message["zoneRequests"] = std::move(access);
  add_paths(state, message);
}

}  // namespace

json state_json(const VehicleState& state, ProtocolVersion version) {
  const bool third = is_v3(version);
  json nodes = json::array();
  for (const GraphState& node : state.nodes)
    nodes.push_back(node_json(node, third));
  json edges = json::array();
  for (const GraphState& edge : state.edges)
    edges.push_back(edge_json(edge, third));
  json message{
      {"maps",
       json::array({{{"mapId", state.map_id}, {"mapVersion", "1"}, {"mapStatus", "ENABLED"}}})},
      {"orderId", state.order_id},
      {"orderUpdateId", state.order_update},
      {"lastNodeId", state.last_node_id},
      {"lastNodeSequenceId", state.last_node_sequence},
      {"nodeStates", std::move(nodes)},
      {"edgeStates", std::move(edges)},
      {"driving", state.motion.driving},
      {"paused", state.paused},
      {"newBaseRequest", state.new_base_request},
      {"distanceSinceLastNode", state.distance_since_last_node},
      {"operatingMode", mode_text(state.mode, third)},
      {"velocity", velocity_json(state.motion.twist)},
      {"loads", json::array()},
      {"actionStates", actions_json(state.actions, third)},
      {"errors", errors_json(state.errors, third)},
      {"information", information_json(state, third)}};
  if (third) {
    add_third(state, message);
    return message;
  }
  for (const ActionState& action : state.instant_actions) {
    json one = actions_json({action}, false);
    message["actionStates"].push_back(std::move(one.front()));
  }
  message["agvPosition"] = position_json(state, false);
  message["batteryState"] = {{"batteryCharge", 100.0}, {"charging", false}};
  message["safetyState"] = {{"eStop", "NONE"}, {"fieldViolation", false}};
  return message;
}

json visualization_json(const VehicleState& state,
                        ProtocolVersion version,
                        std::uint32_t state_header) {
  const bool third = is_v3(version);
  json message{{"velocity", velocity_json(state.motion.twist)}};
  message[third ? "mobileRobotPosition" : "agvPosition"] = position_json(state, third);
  if (third) {
    message["referenceStateHeaderId"] = state_header;
    add_paths(state, message);
  }
  return message;
}

}  // namespace fairway::vda5050
