// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "node/order_client.hpp"

namespace fairway::vda5050 {

using nlohmann::json;

namespace {

bool is_final(const json& action) {
  const std::string status = action.value("actionStatus", "");
  return status == "FINISHED" || status == "FAILED";
}

json list_of(const json& state, const char* key) {
  return state.contains(key) && state[key].is_array() ? state[key] : json::array();
}

// The error of a state that refers to a value; null if there is none.
json error_about(const json& state, const char* key, const std::string& value) {
  for (const json& error : list_of(state, "errors")) {
    for (const json& reference : list_of(error, "errorReferences")) {
      if (reference.value("referenceKey", "") == key &&
          reference.value("referenceValue", "") == value)
        return error;
    }
  }
  return nullptr;
}

std::string error_text(const json& error) {
  return error.value("errorType", "error") + ": " + error.value("errorDescription", "");
}

std::optional<ClientResult> order_result(const json& sent, const json& state) {
  const std::string id = sent.value("orderId", "");
  const auto update = sent.value("orderUpdateId", json(0));
  const bool ours =
      state.value("orderId", "") == id && state.value("orderUpdateId", json()) == update;
  const json error = error_about(state, "orderId", id);
  // While the order is driven, an error such as a closed corridor can still end.
  const bool refused = error.is_object() && !ours;
  const bool given_up = ours && error.is_object() &&
                        (error.value("errorType", "") == "NODE_UNREACHABLE" ||
                         error.value("errorType", "") == "nodeUnreachable");
  if (refused || given_up)
    return ClientResult{.done = false, .text = error_text(error), .last_state = state};
  if (!ours) return std::nullopt;
  const json nodes = list_of(state, "nodeStates");
  const bool released = std::any_of(nodes.begin(), nodes.end(),
                                    [](const json& node) { return node.value("released", false); });
  const json actions = list_of(state, "actionStates");
  const bool acts = std::any_of(actions.begin(), actions.end(), [&](const json& action) {
    return !is_final(action) && nodes.empty();
  });
  if (released || acts || state.value("driving", false)) return std::nullopt;
  // The first released node counts as passed, so an order is done when no released one is left.
  return ClientResult{.done = true,
                      .text = "at node \"" + state.value("lastNodeId", "") + "\"" +
                              (nodes.empty() ? "" : ", the end of the base"),
                      .last_state = state};
}

std::optional<ClientResult> action_result(const json& sent, const json& state) {
  const json known = [&] {
    json all = list_of(state, "actionStates");
    for (const json& action : list_of(state, "instantActionStates"))
      all.push_back(action);
    return all;
  }();
  std::string text;
  bool failed = false;
  for (const json& action : sent.at("actions")) {
    const std::string id = action.value("actionId", "");
    const auto found = std::find_if(known.begin(), known.end(), [&](const json& one) {
      return one.value("actionId", "") == id;
    });
    if (found == known.end() || !is_final(*found)) return std::nullopt;
    const std::string status = found->value("actionStatus", "");
    failed = failed || status == "FAILED";
    text += (text.empty() ? "" : ", ") + id + " " + status;
  }
  return ClientResult{.done = !failed, .text = text, .last_state = state};
}

std::optional<ClientResult> zone_result(const json& sent, const json& state) {
  const std::string id = sent.at("zoneSet").value("zoneSetId", "");
  const json error = error_about(state, "zoneSetId", id);
  if (error.is_object())
    return ClientResult{.done = false, .text = error_text(error), .last_state = state};
  for (const json& set : list_of(state, "zoneSets")) {
    if (set.value("zoneSetId", "") == id)
      return ClientResult{
          .done = true, .text = "zone set \"" + id + "\" is known", .last_state = state};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Topic> topic_of(const json& message) {
  if (!message.is_object()) return std::nullopt;
  const auto has = [&](const char* key, json::value_t type) {
    return message.contains(key) && message[key].type() == type;
  };
  if (has("orderId", json::value_t::string) && has("nodes", json::value_t::array))
    return Topic::Order;
  if (has("actions", json::value_t::array)) return Topic::InstantActions;
  if (has("zoneSet", json::value_t::object)) return Topic::ZoneSet;
  if (has("responses", json::value_t::array)) return Topic::Responses;
  return std::nullopt;
}

std::optional<ClientResult> result_of(const json& sent, const json& state) {
  switch (topic_of(sent).value_or(Topic::State)) {
    case Topic::Order:
      return order_result(sent, state);
    case Topic::InstantActions:
      return action_result(sent, state);
    case Topic::ZoneSet:
      return zone_result(sent, state);
    case Topic::Responses:
    case Topic::State:
    case Topic::Visualization:
    case Topic::Connection:
    case Topic::Factsheet:
      return ClientResult{.done = true, .text = "sent", .last_state = state};
  }
  return std::nullopt;
}

}  // namespace fairway::vda5050
