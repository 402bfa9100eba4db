// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "protocol/messages/state_writer.hpp"
#include "protocol/messages/timestamp.hpp"
#include "protocol/vehicle/vehicle.hpp"

namespace fairway::vda5050 {

namespace {

const char* connection_text(ConnectionState state, ProtocolVersion version) noexcept {
  switch (state) {
    case ConnectionState::Online:
      return "ONLINE";
    case ConnectionState::Offline:
      return "OFFLINE";
    case ConnectionState::Broken:
      return is_v3(version) ? "CONNECTION_BROKEN" : "CONNECTIONBROKEN";
  }
  return "OFFLINE";
}

}  // namespace

void Vehicle::set_condition(Fault fault,
                            bool holds,
                            std::string text,
                            std::vector<Reference> references) {
  const auto old = std::find_if(conditions_.begin(), conditions_.end(),
                                [&](const auto& condition) { return condition.first == fault; });
  const bool held = old != conditions_.end();
  if (!holds) {
    if (!held) return;
    conditions_.erase(old);
    changed_ = true;
    return;
  }
  VehicleError error = make_error(fault, identity_.version, std::move(text), std::move(references));
  if (held && old->second == error) return;
  if (held) {
    old->second = std::move(error);
  } else {
    conditions_.emplace_back(fault, std::move(error));
  }
  changed_ = true;
}

VehicleState Vehicle::state() const {
  VehicleState state;
  state.map_id = map_id_;
  state.zone_sets = zone_sets_.states();
  state.order_id = order_.id;
  state.order_update = order_.update;
  state.last_node_id = order_.last_node_id;
  state.last_node_sequence = order_.last_node_sequence;
  for (const OrderNode& node : order_.nodes) {
    state.nodes.push_back({.id = node.id,
                           .sequence = node.sequence,
                           .descriptor = node.descriptor,
                           .released = node.released,
                           .place = node.place});
    if (node.released) state.traversed_nodes.push_back(node.id);
  }
  for (const OrderEdge& edge : order_.edges) {
    state.edges.push_back({.id = edge.id,
                           .sequence = edge.sequence,
                           .descriptor = edge.descriptor,
                           .released = edge.released,
                           .trajectory = edge.trajectory});
  }
  state.actions = queue_.states();
  for (const InstantEntry& entry : instant_)
    state.instant_actions.push_back(entry.state);
  for (const auto& request : leave_.all()) {
    state.edge_requests.push_back({.id = request.id,
                                   .edge_id = request.name,
                                   .sequence = request.key,
                                   .status = request.status});
  }
  for (const auto& request : zone_leave_.all()) {
    state.zone_requests.push_back({.id = request.id,
                                   .zone_id = request.key,
                                   .zone_set_id = request.name,
                                   .status = request.status});
  }
  for (const std::vector<VehicleError>* errors : {&order_errors_, &instant_errors_, &zone_errors_})
    state.errors.insert(state.errors.end(), errors->begin(), errors->end());
  for (const auto& [fault, error] : conditions_)
    state.errors.push_back(error);
  state.paused = paused_;
  state.new_base_request = new_base_request_;
  state.distance_since_last_node = distance_;
  state.mode = mode_;
  state.motion = motion_;
  return state;
}

std::string Vehicle::message_text(Topic topic, nlohmann::json body, double now) {
  body["headerId"] = header_ids_.at(static_cast<std::size_t>(topic))++;
  body["timestamp"] = to_timestamp(now);
  body["version"] = to_text(identity_.version);
  body["manufacturer"] = identity_.manufacturer;
  body["serialNumber"] = identity_.serial;
  return body.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

OutgoingMessage Vehicle::connection_message(ConnectionState state, double now) {
  nlohmann::json body{{"connectionState", connection_text(state, identity_.version)}};
  return {.topic = Topic::Connection,
          .payload = message_text(Topic::Connection, std::move(body), now),
          .qos = 1,
          .retained = true};
}

void Vehicle::announce(double now) {
  announces_ = true;
  wants_factsheet_ = true;
  wants_state_ = true;
  (void)now;
}

std::vector<OutgoingMessage> Vehicle::take_messages(double now) {
  std::vector<OutgoingMessage> messages;
  if (std::exchange(announces_, false))
    messages.push_back(connection_message(ConnectionState::Online, now));
  if (std::exchange(wants_factsheet_, false)) {
    messages.push_back({.topic = Topic::Factsheet,
                        .payload = message_text(
                            Topic::Factsheet, factsheet_json(description_, identity_.version), now),
                        .qos = 0,
                        .retained = true});
  }
  const double since_state = now - last_state_;
  const bool due = since_state >= description_.state_interval || since_state < 0.0;
  const bool may = since_state >= description_.least_state_interval || since_state < 0.0;
  if (wants_state_ || due || (changed_ && may)) {
    messages.push_back(
        {.topic = Topic::State,
         .payload = message_text(Topic::State, state_json(state(), identity_.version), now)});
    wants_state_ = false;
    changed_ = false;
    last_state_ = now;
  }
  const double since_picture = now - last_visualization_;
  constexpr double kEarly = 1e-3;  // [s]
  if (has_motion_ &&
      (since_picture >= description_.visualization_interval - kEarly || since_picture < 0.0)) {
    const std::uint32_t last = header_ids_.at(static_cast<std::size_t>(Topic::State));
    messages.push_back(
        {.topic = Topic::Visualization,
         .payload = message_text(
             Topic::Visualization,
             visualization_json(state(), identity_.version, last > 0 ? last - 1 : 0), now)});
    last_visualization_ = now;
  }
  return messages;
}

}  // namespace fairway::vda5050
