// SPDX-License-Identifier: Apache-2.0
#include "protocol/messages/factsheet.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "fairway/geometry/footprint.hpp"
#include "protocol/messages/zone_set.hpp"

namespace fairway::vda5050 {

using nlohmann::json;

namespace {

struct Parameter {
  const char* key;
  const char* type;  // of version 2
  bool optional = false;
};

struct InstantAction {
  const char* type;
  std::vector<Parameter> parameters{};
};

std::vector<InstantAction> instant_actions(bool third) {
  std::vector<InstantAction> actions{{"cancelOrder", {{"orderId", "STRING", true}}},
                                     {"startPause"},
                                     {"stopPause"},
                                     {"stateRequest"},
                                     {"factsheetRequest"},
                                     {third ? "initializePosition" : "initPosition",
                                      {{"x", "FLOAT"},
                                       {"y", "FLOAT"},
                                       {"theta", "FLOAT"},
                                       {"mapId", "STRING"},
                                       {"lastNodeId", "STRING", true}}}};
  if (!third) {
    actions.front().parameters.clear();
    return actions;
  }
  actions.push_back({"enableZoneSet", {{"zoneSetId", "STRING"}}});
  actions.push_back({"deleteZoneSet", {{"zoneSetId", "STRING"}}});
  actions.push_back({"clearInstantActions"});
  return actions;
}

json action_json(const char* type,
                 json scopes,
                 const std::vector<Parameter>& parameters,
                 bool third) {
  json action{{"actionType", type}, {"actionScopes", std::move(scopes)}};
  json list = json::array();
  for (const Parameter& parameter : parameters) {
    // Version 3 has NUMBER in place of FLOAT.
    const bool number = std::string(parameter.type) == "FLOAT" && third;
    list.push_back({{"key", parameter.key},
                    {"valueDataType", number ? "NUMBER" : parameter.type},
                    {"isOptional", parameter.optional}});
  }
  action["actionParameters"] = std::move(list);
  if (third) {
    action["pauseAllowed"] = false;
    action["cancelAllowed"] = false;
  }
  return action;
}

json features_json(const VehicleDescription& description, bool third) {
  json actions = json::array();
  for (const InstantAction& action : instant_actions(third))
    actions.push_back(action_json(action.type, json::array({"INSTANT"}), action.parameters, third));
  for (const OrderAction& action : description.order_actions)
    actions.push_back(action_json(action.type.c_str(), json::array({"NODE", "EDGE"}), {}, third));
  json parameters = json::array();
  parameters.push_back({{"parameter", "order.nodes.nodePosition"}, {"support", "REQUIRED"}});
  for (const char* name :
       {"order.nodes.nodePosition.theta", "order.nodes.nodePosition.allowedDeviationXY",
        "order.nodes.nodePosition.allowedDeviationTheta", "order.edges.corridor",
        "order.edges.trajectory"}) {
    parameters.push_back({{"parameter", name}, {"support", "SUPPORTED"}});
  }
  parameters.push_back({{"parameter", third ? "order.edges.maximumSpeed" : "order.edges.maxSpeed"},
                        {"support", "SUPPORTED"}});
  return {{"optionalParameters", std::move(parameters)},
          {third ? "mobileRobotActions" : "agvActions", std::move(actions)}};
}

json limits_json(const VehicleDescription& description, bool third) {
  json arrays{{"order.nodes", description.most_nodes},
              {"order.edges", description.most_nodes > 0 ? description.most_nodes - 1 : 0}};
  if (third) arrays["zoneSet.zones"] = 1000;
  const char* least = third ? "minimum" : "min";
  return {{third ? "maximumStringLengths" : "maxStringLens", json::object()},
          {third ? "maximumArrayLengths" : "maxArrayLens", std::move(arrays)},
          {"timing",
           {{std::string(least) + "OrderInterval", 0.1},
            {std::string(least) + "StateInterval", description.least_state_interval},
            {"defaultStateInterval", description.state_interval},
            {"visualizationInterval", description.visualization_interval}}}};
}

// The body's outline: the rectangle, or a polygon about the disc that covers the robot.
std::vector<Eigen::Vector2d> outline(const RobotSettings& robot) {
  if (robot.discs.count == 0 && robot.length > 0.0 && robot.width > 0.0) {
    const double x = 0.5 * robot.length;
    const double y = 0.5 * robot.width;
    return {{x, y}, {-x, y}, {-x, -y}, {x, -y}};
  }
  constexpr int kSides = 16;
  const double radius = robot.radius / std::cos(std::numbers::pi / kSides);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < kSides; ++i)
    points.emplace_back(radius * direction(2.0 * std::numbers::pi * (i + 0.5) / kSides));
  return points;
}

json geometry_json(const RobotSettings& robot, bool third) {
  json points = json::array();
  for (const Eigen::Vector2d& point : outline(robot))
    points.push_back({{"x", point.x()}, {"y", point.y()}});
  const json envelope{{third ? "envelope2dId" : "set", "body"},
                      {third ? "vertices" : "polygonPoints", std::move(points)}};
  return {{"envelopes2d", json::array({envelope})}};
}

json physics_json(const VehicleDescription& description, bool third) {
  const RobotSettings& robot = description.robot;
  const double braking =
      robot.linear_braking_max > 0.0 ? robot.linear_braking_max : robot.linear_acceleration_max;
  const double width = robot.width > 0.0 ? robot.width : 2.0 * robot.radius;
  const double length = robot.length > 0.0 ? robot.length : 2.0 * robot.radius;
  json body{{"width", width}, {"length", length}};
  if (third) {
    body["minimumSpeed"] = 0.0;
    body["maximumSpeed"] = robot.linear_max;
    body["maximumAngularSpeed"] = robot.angular_max;
    body["maximumAcceleration"] = robot.linear_acceleration_max;
    body["maximumDeceleration"] = braking;
    body["minimumHeight"] = description.height;
    body["maximumHeight"] = description.height;
    return body;
  }
  body["speedMin"] = 0.0;
  body["speedMax"] = robot.linear_max;
  body["accelerationMax"] = robot.linear_acceleration_max;
  body["decelerationMax"] = braking;
  body["heightMin"] = description.height;
  body["heightMax"] = description.height;
  return body;
}

}  // namespace

json factsheet_json(const VehicleDescription& description, ProtocolVersion version) {
  const bool third = is_v3(version);
  json type{{"seriesName", "Fairway AMR"}, {"localizationTypes", json::array({"NATURAL"})}};
  type[third ? "mobileRobotKinematics" : "agvKinematic"] = third ? "DIFFERENTIAL" : "DIFF";
  type[third ? "mobileRobotClass" : "agvClass"] = "CARRIER";
  type[third ? "maximumLoadMass" : "maxLoadMass"] = 0;
  type["navigationTypes"] =
      json::array({third ? "FREELY_NAVIGATING" : "AUTONOMOUS", "VIRTUAL_LINE_GUIDED"});
  if (third) {
    json zones = json::array();
    for (std::size_t i = 0; i < kZoneTypeNames.size(); ++i) {
      if (is_supported(static_cast<ZoneType>(i))) zones.push_back(kZoneTypeNames[i]);
    }
    type["supportedZones"] = std::move(zones);
  }
  return {{"typeSpecification", std::move(type)},
          {"physicalParameters", physics_json(description, third)},
          {"protocolLimits", limits_json(description, third)},
          {"protocolFeatures", features_json(description, third)},
          {third ? "mobileRobotGeometry" : "agvGeometry", geometry_json(description.robot, third)},
          {"loadSpecification", json::object()}};
}

}  // namespace fairway::vda5050
