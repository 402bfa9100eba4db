// SPDX-License-Identifier: Apache-2.0
#include "protocol/orders/active_order.hpp"

#include <algorithm>

namespace fairway::vda5050 {

std::size_t ActiveOrder::released_nodes() const noexcept {
  const auto end = std::find_if(nodes.begin(), nodes.end(),
                                [](const OrderNode& node) { return !node.released; });
  return static_cast<std::size_t>(end - nodes.begin());
}

bool ActiveOrder::is_decision_point(const OrderNode& node) const noexcept {
  const std::size_t released = released_nodes();
  if (released == 0) return node.id == last_node_id && node.sequence == last_node_sequence;
  const OrderNode& last = nodes[released - 1];
  return node.id == last.id && node.sequence == last.sequence;
}

void ActiveOrder::begin(const Order& order) {
  id = order.id;
  update = order.update;
  graph = order.graph;
  cancelled = false;
  nodes.assign(order.nodes.begin() + 1, order.nodes.end());
  edges = order.edges;
  last_node_id = order.nodes.front().id;
  last_node_sequence = order.nodes.front().sequence;
  last_place = order.nodes.front().place;
  legs = legs_of(last_place, nodes, edges);
}

void ActiveOrder::extend(const Order& given) {
  update = given.update;
  graph = given.graph;
  const std::size_t released = released_nodes();
  nodes.resize(released);
  std::erase_if(edges, [](const OrderEdge& edge) { return !edge.released; });
  const NodePosition stitch = released == 0 ? last_place : nodes.back().place;
  edges.resize(std::min(edges.size(), released));
  legs.resize(edges.size());
  const std::vector<OrderNode> new_nodes(given.nodes.begin() + 1, given.nodes.end());
  const std::vector<RouteLeg> new_legs = legs_of(stitch, new_nodes, given.edges);
  nodes.insert(nodes.end(), new_nodes.begin(), new_nodes.end());
  edges.insert(edges.end(), given.edges.begin(), given.edges.end());
  legs.insert(legs.end(), new_legs.begin(), new_legs.end());
}

void ActiveOrder::pass_node() {
  last_node_id = nodes.front().id;
  last_node_sequence = nodes.front().sequence;
  last_place = nodes.front().place;
  nodes.erase(nodes.begin());
  if (edges.empty()) return;
  edges.erase(edges.begin());
  legs.erase(legs.begin());
}

void ActiveOrder::clear_ahead() {
  nodes.clear();
  edges.clear();
  legs.clear();
}

}  // namespace fairway::vda5050
