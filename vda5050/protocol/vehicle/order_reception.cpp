// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "protocol/vehicle/vehicle.hpp"

namespace fairway::vda5050 {

namespace {

constexpr double kStartSlack = 0.05;  // beyond the deviation of the first node [m]

Fault fault_of(OrderFault::Kind kind) noexcept {
  switch (kind) {
    case OrderFault::Kind::Invalid:
      return Fault::Validation;
    case OrderFault::Kind::Unsupported:
      return Fault::UnsupportedField;
    case OrderFault::Kind::TooLarge:
      return Fault::TooLarge;
  }
  return Fault::Validation;
}

bool takes_orders(OperatingMode mode) noexcept {
  return mode == OperatingMode::Automatic || mode == OperatingMode::Semiautomatic ||
         mode == OperatingMode::Intervened;
}

}  // namespace

VehicleError Vehicle::order_error(Fault fault, std::string text, const Order& order) const {
  return make_error(fault, identity_.version, std::move(text),
                    {{.key = "orderId", .value = order.id},
                     {.key = "orderUpdateId", .value = std::to_string(order.update)}});
}

void Vehicle::refuse_order(VehicleError error) {
  changed_ = true;
  // Some fleet controls find the error by its topic.
  const Reference topic{.key = "topic", .value = to_text(Topic::Order)};
  std::vector<Reference>& references = error.references;
  if (std::find(references.begin(), references.end(), topic) == references.end())
    references.push_back(topic);
  // A message that is repeated replaces its error.
  std::erase_if(order_errors_, [&](const VehicleError& old) {
    return old.type == error.type && old.references == error.references;
  });
  constexpr std::size_t kMost = 10;
  if (order_errors_.size() >= kMost) order_errors_.erase(order_errors_.begin());
  order_errors_.push_back(std::move(error));
}

// The actions that the vehicle cannot do, and the checks of the present order.
std::optional<VehicleError> Vehicle::order_problem(const Order& order) const {
  std::optional<VehicleError> unknown;
  const auto check = [&](const std::vector<Action>& actions) {
    for (const Action& action : actions) {
      const bool known =
          std::any_of(description_.order_actions.begin(), description_.order_actions.end(),
                      [&](const OrderAction& own) { return own.type == action.type; });
      if (known || unknown) continue;
      unknown = order_error(Fault::UnknownAction,
                            "this vehicle has no action \"" + action.type + "\" in orders", order);
      unknown->references.push_back({.key = "actionId", .value = action.id});
      unknown->references.push_back({.key = "actionType", .value = action.type});
    }
  };
  for (const OrderNode& node : order.nodes)
    check(node.actions);
  for (const OrderEdge& edge : order.edges)
    check(edge.actions);
  if (unknown) return unknown;
  if (!takes_orders(mode_))
    return order_error(Fault::NotAvailable, "the operating mode takes no orders", order);
  return order.id == order_.id ? update_problem(order) : new_order_problem(order);
}

std::optional<VehicleError> Vehicle::new_order_problem(const Order& order) const {
  if (!idle() || cancelling_) {
    return order_error(Fault::OtherOrderActive,
                       "order \"" + order_.id + "\" is not finished; cancel it or wait", order);
  }
  if (is_v3(identity_.version) && order.update != 0) {
    return order_error(
        Fault::Validation,
        "orderUpdateId: expected 0 for a new order, found " + std::to_string(order.update), order);
  }
  if (std::optional<VehicleError> problem = place_problem(order)) return problem;
  const OrderNode& first = order.nodes.front();
  NodePosition place = first.place;
  place.theta.reset();  // the vehicle can turn on its place
  if (!has_motion_ || !motion_.localized || !is_at(place, motion_.pose, kStartSlack)) {
    VehicleError error =
        order_error(Fault::StartNode,
                    "the vehicle at (" + std::to_string(motion_.pose.position.x()) + ", " +
                        std::to_string(motion_.pose.position.y()) +
                        ") is not in the deviation range of node \"" + first.id + "\"",
                    order);
    error.references.push_back({.key = "nodeId", .value = first.id});
    return error;
  }
  return route_problem(order);
}

std::optional<VehicleError> Vehicle::update_problem(const Order& order) const {
  if (order.update < order_.update) {
    return order_error(Fault::OutdatedUpdate,
                       "expected an orderUpdateId above " + std::to_string(order_.update), order);
  }
  if (order_.cancelled || cancelling_)
    return order_error(Fault::UpdateAfterCancel, "the order was cancelled", order);
  if (!order_.is_decision_point(order.nodes.front())) {
    const std::size_t released = order_.released_nodes();
    const std::string& end = released > 0 ? order_.nodes[released - 1].id : order_.last_node_id;
    const std::uint32_t sequence =
        released > 0 ? order_.nodes[released - 1].sequence : order_.last_node_sequence;
    VehicleError error =
        order_error(Fault::Stitching,
                    "expected an update that begins at the end of the base, node \"" + end +
                        "\" with sequenceId " + std::to_string(sequence),
                    order);
    error.references.push_back({.key = "nodeId", .value = order.nodes.front().id});
    return error;
  }
  if (std::optional<VehicleError> problem = place_problem(order)) return problem;
  return route_problem(order);
}

std::optional<VehicleError> Vehicle::place_problem(const Order& order) const {
  for (const OrderNode& node : order.nodes) {
    if (node.place.map_id == map_id_) continue;
    VehicleError error = order_error(
        Fault::UnknownMap,
        "expected the map \"" + map_id_ + "\", found \"" + node.place.map_id + "\"", order);
    error.references.push_back({.key = "nodeId", .value = node.id});
    error.references.push_back({.key = "mapId", .value = node.place.map_id});
    return error;
  }
  return std::nullopt;
}

// Corridors that need leave count as usable: leave is requested on the way.
std::optional<VehicleError> Vehicle::route_problem(const Order& order) const {
  if (!route_check_) return std::nullopt;
  std::vector<OrderNode> nodes(order.nodes.begin() + 1, order.nodes.end());
  Route route{.legs = legs_of(order.nodes.front().place, nodes, order.edges)};
  const auto released = static_cast<std::size_t>(std::count_if(
      order.edges.begin(), order.edges.end(), [](const OrderEdge& edge) { return edge.released; }));
  route.legs.resize(std::min(route.legs.size(), released));
  if (route.legs.empty()) return std::nullopt;
  const std::optional<std::size_t> leg = route_check_(route, zones_with_leave());
  if (!leg || *leg >= route.legs.size()) return std::nullopt;
  VehicleError error =
      order_error(Fault::NoRoute,
                  "no path inside the allowed area leads along edge \"" + route.legs[*leg].edge_id +
                      "\" to node \"" + route.legs[*leg].end_node_id + "\"",
                  order);
  error.references.push_back({.key = "nodeId", .value = route.legs[*leg].end_node_id});
  error.references.push_back({.key = "edgeId", .value = route.legs[*leg].edge_id});
  return error;
}

void Vehicle::list_actions(const Order& order, std::size_t first_node) {
  const auto list = [&](const std::vector<Action>& actions, std::uint32_t sequence, bool released) {
    std::vector<double> durations;
    for (const Action& action : actions) {
      for (const OrderAction& own : description_.order_actions) {
        if (own.type != action.type) continue;
        durations.push_back(own.duration);
        break;
      }
    }
    queue_.list(actions, durations, sequence, released);
  };
  for (std::size_t i = first_node; i < order.nodes.size(); ++i) {
    if (i > 0)
      list(order.edges[i - 1].actions, order.edges[i - 1].sequence, order.edges[i - 1].released);
    list(order.nodes[i].actions, order.nodes[i].sequence, order.nodes[i].released);
  }
}

void Vehicle::receive_order(const nlohmann::json& message, double now) {
  Order order;
  const OrderAbilities abilities{.angular_max = description_.robot.angular_max,
                                 .height = description_.height,
                                 .most_nodes = description_.most_nodes};
  if (const auto fault = read_order(message, identity_.version, abilities, order)) {
    VehicleError error = order_error(fault_of(fault->kind), fault->text, order);
    for (const std::string& field : fault->fields)
      error.references.push_back({.key = "field", .value = field});
    return refuse_order(std::move(error));
  }
  const bool same = order.id == order_.id && order.update == order_.update;
  if (same && (!is_v3(identity_.version) || order.graph == order_.graph)) return;  // repeated
  if (same) {
    return refuse_order(
        order_error(Fault::SameUpdate, "this orderUpdateId is known with other content", order));
  }
  if (std::optional<VehicleError> problem = order_problem(order))
    return refuse_order(*std::move(problem));
  changed_ = true;
  order_errors_.clear();
  unreachable_ = false;
  closed_since_ = -1.0;
  set_condition(Fault::NodeUnreachable, false, {}, {});
  set_condition(Fault::CorridorClosed, false, {}, {});
  if (order.id != order_.id) {
    order_.begin(order);
    leave_.clear();
    queue_.clear();
    passing_.reset();
    last_leg_.reset();
    distance_ = 0.0;
    std::erase_if(instant_, [&](const InstantEntry& entry) {
      return !is_v3(identity_.version) && entry.state.done();
    });
    list_actions(order, 0);
    queue_.enter(order.nodes.front().sequence);
  } else {
    order_.extend(order);
    queue_.drop_horizon();
    list_actions(order, 1);
  }
  queue_.update(now);
  rebuild_route();
}

}  // namespace fairway::vda5050
