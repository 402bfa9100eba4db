// SPDX-License-Identifier: Apache-2.0
#include "page/page_data.hpp"

namespace fairway::vda5050 {

using nlohmann::json;

namespace {

json points_json(const std::vector<Eigen::Vector2d>& points) {
  json list = json::array();
  for (const Eigen::Vector2d& point : points)
    list.push_back({point.x(), point.y()});
  return list;
}

// The outline of a leg's strip: its left side, and its right side backwards.
json strip_json(const RouteLeg& leg) {
  std::vector<Eigen::Vector2d> left;
  std::vector<Eigen::Vector2d> right;
  for (std::size_t i = 1; i < leg.line.size(); ++i) {
    const Eigen::Vector2d chord = leg.line[i] - leg.line[i - 1];
    if (!(chord.norm() > 0.0)) continue;
    const Eigen::Vector2d side = Eigen::Vector2d(-chord.y(), chord.x()) / chord.norm();
    for (const Eigen::Vector2d& point : {leg.line[i - 1], leg.line[i]}) {
      left.emplace_back(point + leg.strip->left * side);
      right.emplace_back(point - leg.strip->right * side);
    }
  }
  left.insert(left.end(), right.rbegin(), right.rend());
  return points_json(left);
}

}  // namespace

json page_map(const BitGrid& map) {
  const GridFrame& frame = map.frame();
  json rows = json::array();
  for (int y = 0; y < frame.height; ++y) {
    std::string row;
    for (int x = 0; x < frame.width; x += 4) {
      unsigned digit = 0;
      for (int k = 0; k < 4; ++k)
        digit |= map.blocked({.x = x + k, .y = y}) ? 1U << static_cast<unsigned>(k) : 0U;
      row += "0123456789abcdef"[digit];
    }
    rows.push_back(std::move(row));
  }
  return {{"width", frame.width},
          {"height", frame.height},
          {"resolution", frame.resolution},
          {"origin", {frame.origin.position.x(), frame.origin.position.y(), frame.origin.heading}},
          {"rows", std::move(rows)}};
}

json page_robot(const Vehicle& vehicle, double radius) {
  const VehicleState state = vehicle.state();
  json legs = json::array();
  const ActiveOrder& order = vehicle.order();
  for (std::size_t i = 0; i < order.legs.size(); ++i) {
    json leg{{"id", order.legs[i].edge_id},
             {"line", points_json(order.legs[i].line)},
             {"released", order.edges[i].released}};
    if (order.legs[i].strip) leg["strip"] = strip_json(order.legs[i]);
    legs.push_back(std::move(leg));
  }
  json nodes = json::array();
  for (const OrderNode& node : order.nodes)
    nodes.push_back({{"id", node.id},
                     {"x", node.place.position.x()},
                     {"y", node.place.position.y()},
                     {"released", node.released}});
  json zones = json::array();
  for (const Zone& zone : vehicle.zones())
    zones.push_back(
        {{"id", zone.id}, {"type", to_text(zone.type)}, {"vertices", points_json(zone.vertices)}});
  json errors = json::array();
  for (const VehicleError& error : state.errors)
    errors.push_back(error.type + ": " + error.description);
  std::vector<Eigen::Vector2d> ahead;
  for (const PlannedPoint& point : state.motion.intermediate)
    ahead.push_back(point.pose.position);
  return {{"serial", vehicle.identity().serial},
          {"x", state.motion.pose.position.x()},
          {"y", state.motion.pose.position.y()},
          {"theta", state.motion.pose.heading},
          {"radius", radius},
          {"speed", state.motion.twist.linear},
          {"order", state.order_id},
          {"last_node", state.last_node_id},
          {"paused", state.paused},
          {"driving", state.motion.driving},
          {"limit", state.motion.limit},
          {"legs", std::move(legs)},
          {"nodes", std::move(nodes)},
          {"zones", std::move(zones)},
          {"errors", std::move(errors)},
          {"planned", points_json(state.motion.planned)},
          {"ahead", points_json(ahead)}};
}

}  // namespace fairway::vda5050
