// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>
#include <set>

#include "protocol/messages/order.hpp"

namespace fairway::vda5050 {

namespace {

constexpr double kMostCoordinate = 1e7;  // [m]
constexpr double kHalfTurn = std::numbers::pi + 1e-9;

struct Reading {
  ProtocolVersion version;
  const OrderAbilities& abilities;
  std::vector<std::string> unsupported{};  // paths of fields
};

NodePosition read_position(FieldReader reader, Reading& reading) {
  NodePosition place;
  const FieldRange range{.low = -kMostCoordinate, .high = kMostCoordinate};
  place.position = {reader.number("x", range), reader.number("y", range)};
  place.theta = reader.optional_number("theta", {.low = -kHalfTurn, .high = kHalfTurn});
  place.map_id = reader.text("mapId");
  if (is_v3(reading.version)) {
    if (reader.has("allowedDeviationXY")) {
      FieldReader ellipse = reader.object("allowedDeviationXY");
      place.deviation = {
          .a = ellipse.number("a", {.low = 0.0}),
          .b = ellipse.number("b", {.low = 0.0}),
          .theta = ellipse.number("theta", {.low = -0.5 * kHalfTurn, .high = 0.5 * kHalfTurn})};
    }
  } else if (const auto radius = reader.optional_number("allowedDeviationXY", {.low = 0.0})) {
    place.deviation = {.a = *radius, .b = *radius};
  }
  // The schema of version 2 allows a negative deviation; its amount counts.
  const double least = is_v3(reading.version) ? 0.0 : -kHalfTurn;
  place.theta_deviation =
      std::abs(reader.optional_number("allowedDeviationTheta", {.low = least, .high = kHalfTurn})
                   .value_or(0.0));
  return place;
}

std::vector<Action> read_actions(FieldReader& reader) {
  std::vector<Action> actions;
  for (FieldReader& action : reader.objects("actions"))
    actions.push_back(read_action(action));
  return actions;
}

OrderNode read_node(FieldReader& reader, Reading& reading) {
  OrderNode node;
  node.id = reader.text("nodeId");
  node.sequence = reader.count("sequenceId");
  node.released = reader.flag("released");
  node.descriptor =
      reader.optional_text(is_v3(reading.version) ? "nodeDescriptor" : "nodeDescription");
  if (reader.has("nodePosition")) {
    node.place = read_position(reader.object("nodePosition"), reading);
  } else {
    // A node without a position is valid, but a vehicle without a map of nodes cannot use it.
    reading.unsupported.push_back(reader.path() + ".nodePosition");
  }
  node.actions = read_actions(reader);
  return node;
}

Corridor read_corridor(FieldReader reader, ProtocolVersion version) {
  static constexpr std::array<const char*, 2> kPoints2{"KINEMATICCENTER", "CONTOUR"};
  static constexpr std::array<const char*, 2> kPoints3{"KINEMATIC_CENTER", "CONTOUR"};
  static constexpr std::array<const char*, 2> kLosses{"STOP", "RETURN"};
  const bool third = is_v3(version);
  Corridor corridor;
  corridor.left = reader.number("leftWidth", {.low = 0.0});
  corridor.right = reader.number("rightWidth", {.low = 0.0});
  corridor.contour = reader.optional_word(third ? "corridorReferencePoint" : "corridorRefPoint",
                                          third ? kPoints3 : kPoints2, 0) == 1;
  if (third) {
    corridor.release_required = reader.optional_flag("releaseRequired", false);
    corridor.release_loss = reader.optional_word("releaseLossBehavior", kLosses, 0) == 1
                                ? ReleaseLoss::Return
                                : ReleaseLoss::Stop;
  }
  return corridor;
}

// Notes the fields of an edge that the vehicle cannot honour.
void note_unsupported(FieldReader& reader, Reading& reading) {
  const bool third = is_v3(reading.version);
  const auto refuse = [&](const char* name) {
    reading.unsupported.push_back(reader.path() + "." + name);
  };
  const FieldRange turn{.low = -kHalfTurn, .high = kHalfTurn};
  constexpr double kStraight = 1e-6;
  if (std::abs(reader.optional_number("orientation", turn).value_or(0.0)) > kStraight)
    refuse("orientation");
  if (reader.optional_text("orientationType", "TANGENTIAL") != "TANGENTIAL")
    refuse("orientationType");
  if (!reader.optional_text("direction").empty()) refuse("direction");
  for (const char* name : {"maxRotationSpeed", "maximumRotationSpeed"}) {
    const double most = reader.optional_number(name).value_or(reading.abilities.angular_max);
    if (most < reading.abilities.angular_max) refuse(name);
  }
  const char* height = third ? "maximumMobileRobotHeight" : "maxHeight";
  if (reader.optional_number(height).value_or(reading.abilities.height) <
      reading.abilities.height) {
    refuse(height);
  }
  const char* lift = third ? "minimumLoadHandlingDeviceHeight" : "minHeight";
  if (reader.optional_number(lift).value_or(0.0) > 0.0) refuse(lift);
  if (third && reader.optional_flag("reachOrientationBeforeEntering", false))
    refuse("reachOrientationBeforeEntering");
  if (!third && !reader.optional_flag("rotationAllowed", true)) refuse("rotationAllowed");
  (void)reader.optional_number("length");
}

OrderEdge read_edge(FieldReader& reader, Reading& reading, const Order& order, std::size_t index) {
  const bool third = is_v3(reading.version);
  OrderEdge edge;
  edge.id = reader.text("edgeId");
  edge.sequence = reader.count("sequenceId");
  edge.released = reader.flag("released");
  edge.descriptor = reader.optional_text(third ? "edgeDescriptor" : "edgeDescription");
  edge.speed_max = reader.optional_number(third ? "maximumSpeed" : "maxSpeed");
  if (edge.speed_max && !(*edge.speed_max > 0.0)) {
    reader.complain(third ? "maximumSpeed" : "maxSpeed", "expected a number above 0");
  }
  if (!third) {
    const std::string start = reader.text("startNodeId");
    const std::string end = reader.text("endNodeId");
    const bool known = index + 1 < order.nodes.size();
    if (known && start != order.nodes[index].id) {
      reader.complain("startNodeId", "expected the node before the edge, \"" +
                                         order.nodes[index].id + "\", found \"" + start + "\"");
    }
    if (known && end != order.nodes[index + 1].id) {
      reader.complain("endNodeId", "expected the node after the edge, \"" +
                                       order.nodes[index + 1].id + "\", found \"" + end + "\"");
    }
  }
  note_unsupported(reader, reading);
  if (reader.has("trajectory")) {
    FieldReader trajectory = reader.object("trajectory");
    edge.trajectory = read_trajectory(trajectory, !third);
  }
  if (reader.has("corridor"))
    edge.corridor = read_corridor(reader.object("corridor"), reading.version);
  edge.actions = read_actions(reader);
  return edge;
}

// Checks the numbers, the alternation and the release of nodes and edges.
void check_graph(const Order& order, FieldReader& reader) {
  if (order.nodes.empty())
    return reader.complain("nodes", "expected at least one node, found none");
  if (order.edges.size() + 1 != order.nodes.size()) {
    return reader.complain("edges", "expected " + std::to_string(order.nodes.size() - 1) +
                                        " edges for " + std::to_string(order.nodes.size()) +
                                        " nodes, found " + std::to_string(order.edges.size()));
  }
  const std::uint32_t first = order.nodes.front().sequence;
  if (first % 2 != 0)
    return reader.complain("nodes[0].sequenceId",
                           "expected an even number, found " + std::to_string(first));
  bool released = true;
  std::set<std::string> action_ids;
  const auto check = [&](const std::string& path, std::uint32_t sequence, std::uint32_t expected,
                         bool is_released, const std::vector<Action>& actions) {
    if (sequence != expected) {
      reader.complain(path + ".sequenceId", "expected " + std::to_string(expected) + ", found " +
                                                std::to_string(sequence));
    }
    if (is_released && !released)
      reader.complain(path + ".released", "expected false after a part that is not released");
    released = released && is_released;
    for (const Action& action : actions) {
      if (!action_ids.insert(action.id).second)
        reader.complain(path + ".actions",
                        "expected ids that differ, found \"" + action.id + "\" again");
    }
  };
  for (std::size_t i = 0; i < order.nodes.size(); ++i) {
    const auto offset = static_cast<std::uint32_t>(2 * i);
    const std::string index = "[" + std::to_string(i) + "]";
    if (i == 0 && !order.nodes[0].released)
      reader.complain("nodes[0].released", "expected true: the first node is always released");
    check("nodes" + index, order.nodes[i].sequence, first + offset, order.nodes[i].released,
          order.nodes[i].actions);
    if (i == order.edges.size()) break;
    check("edges" + index, order.edges[i].sequence, first + offset + 1, order.edges[i].released,
          order.edges[i].actions);
    if (order.edges[i].released && !order.nodes[i + 1].released)
      reader.complain("edges" + index + ".released",
                      "expected false: its end node is not released");
  }
}

bool near_node(const Eigen::Vector2d& point, const NodePosition& place) {
  constexpr double kSlack = 0.05;  // [m]
  return (point - place.position).norm() <= std::max(place.deviation.a, place.deviation.b) + kSlack;
}

void check_trajectories(const Order& order, FieldReader& reader) {
  for (std::size_t i = 0; i < order.edges.size() && reader.sound(); ++i) {
    const auto& curve = order.edges[i].trajectory;
    if (!curve) continue;
    const std::string path = "edges[" + std::to_string(i) + "].trajectory";
    if (!near_node(curve->points.front().position, order.nodes[i].place))
      reader.complain(path, "expected a curve that begins at node \"" + order.nodes[i].id + "\"");
    if (!near_node(curve->points.back().position, order.nodes[i + 1].place))
      reader.complain(path, "expected a curve that ends at node \"" + order.nodes[i + 1].id + "\"");
  }
}

}  // namespace

std::optional<OrderFault> read_order(const nlohmann::json& message,
                                     ProtocolVersion version,
                                     const OrderAbilities& abilities,
                                     Order& order) {
  using Kind = OrderFault::Kind;
  std::optional<FieldProblem> problem;
  FieldReader reader(message, "", problem);
  Reading reading{.version = version, .abilities = abilities};
  order.id = reader.text("orderId");
  order.update = reader.count("orderUpdateId");
  if (reader.sound() && order.id.empty())
    reader.complain("orderId", "expected a text that is not empty");
  std::vector<FieldReader> nodes = reader.objects("nodes");
  std::vector<FieldReader> edges = reader.objects("edges");
  if (nodes.size() > abilities.most_nodes) {
    return OrderFault{.kind = Kind::TooLarge,
                      .fields = {"nodes"},
                      .text = "expected at most " + std::to_string(abilities.most_nodes) +
                              " nodes, found " + std::to_string(nodes.size())};
  }
  for (FieldReader& node : nodes)
    order.nodes.push_back(read_node(node, reading));
  for (std::size_t i = 0; i < edges.size(); ++i)
    order.edges.push_back(read_edge(edges[i], reading, order, i));
  if (!is_v3(version) && !reader.optional_text("zoneSetId").empty())
    reading.unsupported.emplace_back("zoneSetId");
  if (reader.sound()) check_graph(order, reader);
  if (reader.sound() && reading.unsupported.empty()) check_trajectories(order, reader);
  if (problem)
    return OrderFault{.kind = Kind::Invalid, .fields = {problem->field}, .text = problem->text()};
  if (!reading.unsupported.empty()) {
    return OrderFault{.kind = Kind::Unsupported,
                      .fields = reading.unsupported,
                      .text = "this vehicle cannot honour " + reading.unsupported.front()};
  }
  order.graph = {{"nodes", message.at("nodes")}, {"edges", message.at("edges")}};
  return std::nullopt;
}

}  // namespace fairway::vda5050
