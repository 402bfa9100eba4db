// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "protocol/messages/order.hpp"
#include "protocol/orders/route.hpp"

namespace fairway::vda5050 {

/// The order that a vehicle executes, or executed last: what is still ahead of it.
struct ActiveOrder {
  std::string id;
  std::uint32_t update = 0;
  nlohmann::json graph;          ///< of the last message, to recognise repeated ones
  bool cancelled = false;        ///< no update of it is taken any more
  std::vector<OrderNode> nodes;  ///< not passed yet
  std::vector<OrderEdge> edges;  ///< not passed yet; the first one is being driven
  std::vector<RouteLeg> legs;    ///< one per edge
  std::string last_node_id;
  std::uint32_t last_node_sequence = 0;
  NodePosition last_place;  ///< of the last node

  /// Returns whether nothing is left to drive.
  [[nodiscard]] bool passed_all() const noexcept { return nodes.empty() && edges.empty(); }

  /// Number of nodes ahead that are released; they come first.
  [[nodiscard]] std::size_t released_nodes() const noexcept;

  /// Returns whether `node` is the end of the base, where an update must begin: the last released
  /// node, or the last node passed if no released node is ahead.
  [[nodiscard]] bool is_decision_point(const OrderNode& node) const noexcept;

  /// Replaces the order. The first node counts as passed.
  void begin(const Order& order);

  /// Replaces the horizon by the nodes and edges of an update after its first node.
  void extend(const Order& update);

  /// Notes that the next node is passed. @pre there is a node ahead.
  void pass_node();

  /// Forgets all nodes and edges ahead.
  void clear_ahead();
};

}  // namespace fairway::vda5050
