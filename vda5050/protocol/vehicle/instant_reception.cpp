// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "protocol/vehicle/vehicle.hpp"

namespace fairway::vda5050 {

void Vehicle::receive_instant_actions(const nlohmann::json& message, double now) {
  std::optional<FieldProblem> problem;
  FieldReader reader(message, "", problem);
  // Version 2.0.0 of a widespread library has another name for the list.
  const char* list = message.contains("actions") ? "actions" : "instantActions";
  if (!message.contains(list)) list = "actions";
  std::vector<Action> actions;
  for (FieldReader& item : reader.objects(list)) {
    std::optional<FieldProblem> own;
    FieldReader one(item.value(), item.path(), own);
    const Action action = read_action(one);
    if (!own) {
      actions.push_back(action);
      continue;
    }
    if (!problem) problem = own;
    if (action.id.empty() || action.type.empty()) continue;
    // The sender waits for an answer to every action whose id can be read.
    instant_.push_back({.state = {.id = action.id,
                                  .type = action.type,
                                  .status = ActionStatus::Failed,
                                  .result = own->text()}});
  }
  if (problem) refuse_message(Topic::InstantActions, problem->text(), message);
  for (const Action& action : actions)
    start_instant(action, now);
}

void Vehicle::start_instant(const Action& action, double /*now*/) {
  const bool known = std::any_of(instant_.begin(), instant_.end(), [&](const InstantEntry& entry) {
    return entry.state.id == action.id;
  });
  if (known) return;  // a repeated message
  changed_ = true;
  // Done actions are dropped only where a fleet control never clears them.
  constexpr std::size_t kMost = 500;
  if (instant_.size() >= kMost) {
    const auto old = std::find_if(instant_.begin(), instant_.end(),
                                  [](const InstantEntry& entry) { return entry.state.done(); });
    if (old != instant_.end()) instant_.erase(old);
  }
  InstantEntry entry{
      .state = {
          .id = action.id, .type = action.type, .status = ActionStatus::Finished, .result = {}}};
  const bool third = is_v3(identity_.version);
  if (action.type == "cancelOrder") {
    cancel_order(action, entry);
  } else if (action.type == "startPause") {
    paused_ = true;
    entry.pauses = true;
    entry.state.status = ActionStatus::Running;
  } else if (action.type == "stopPause") {
    paused_ = false;
  } else if (action.type == "stateRequest") {
    wants_state_ = true;
  } else if (action.type == "factsheetRequest") {
    wants_factsheet_ = true;
  } else if (action.type == (third ? "initializePosition" : "initPosition")) {
    set_position(action, entry);
  } else if (third && (action.type == "enableZoneSet" || action.type == "deleteZoneSet")) {
    change_zones(action, entry);
  } else if (third && action.type == "clearInstantActions") {
    std::erase_if(instant_, [](const InstantEntry& old) { return old.state.done(); });
  } else {
    fail_instant(entry, Fault::InvalidAction,
                 "this vehicle has no instant action \"" + action.type + "\"");
  }
  if (entry.state.status != ActionStatus::Failed) instant_errors_.clear();
  instant_.push_back(std::move(entry));
  finish_waiting_actions();
}

void Vehicle::fail_instant(InstantEntry& entry, Fault fault, std::string text) {
  entry.state.status = ActionStatus::Failed;
  entry.state.result = text;
  instant_errors_.push_back(
      make_error(fault, identity_.version, std::move(text),
                 {{.key = "actionId", .value = entry.state.id},
                  {.key = "actionType", .value = entry.state.type},
                  // Some fleet controls find the error by its topic.
                  {.key = "topic", .value = to_text(Topic::InstantActions)}}));
  constexpr std::size_t kMost = 10;
  if (instant_errors_.size() > kMost) instant_errors_.erase(instant_errors_.begin());
}

void Vehicle::cancel_order(const Action& action, InstantEntry& entry) {
  if (idle() && !cancelling_)
    return fail_instant(entry, Fault::NothingToCancel, "no order is being executed");
  const std::optional<std::string> wanted = action.text("orderId");
  if (is_v3(identity_.version) && wanted && !wanted->empty() && *wanted != order_.id) {
    return fail_instant(entry, Fault::NothingToCancel,
                        "expected order \"" + order_.id + "\", found \"" + *wanted + "\"");
  }
  cancelling_ = true;
  order_.cancelled = true;
  queue_.cancel();
  entry.cancels = true;
  entry.state.status = ActionStatus::Running;
  rebuild_route();
}

void Vehicle::set_position(const Action& action, InstantEntry& entry) {
  const std::optional<double> x = action.number("x");
  const std::optional<double> y = action.number("y");
  const std::optional<double> theta = action.number("theta");
  const std::optional<std::string> map = action.text("mapId");
  if (!x || !y || !theta || !map) {
    return fail_instant(entry, Fault::InvalidAction,
                        "expected the parameters x, y, theta (numbers) and mapId (text)");
  }
  if (*map != map_id_) {
    return fail_instant(entry, Fault::InvalidAction,
                        "mapId: expected \"" + map_id_ + "\", found \"" + *map + "\"");
  }
  const Pose2 pose{{*x, *y}, *theta};
  if (!is_plausible(pose) || !pose_setter_ || !pose_setter_(pose))
    return fail_instant(entry, Fault::InvalidAction, "the vehicle cannot be at this position");
  motion_.pose = pose;
  if (const std::optional<std::string> node = action.text("lastNodeId"); node && idle()) {
    order_.last_node_id = *node;
  }
}

void Vehicle::change_zones(const Action& action, InstantEntry& entry) {
  const std::optional<std::string> id = action.text("zoneSetId");
  if (!id)
    return fail_instant(entry, Fault::InvalidAction, "expected the parameter zoneSetId (text)");
  const bool known =
      action.type == "enableZoneSet" ? zone_sets_.enable(*id) : zone_sets_.remove(*id);
  if (!known)
    return fail_instant(entry, Fault::InvalidAction, "no zone set \"" + *id + "\" is known");
  use_zones(zone_sets_.zones(map_id_));
}

// Ends the actions that wait until the vehicle has stopped.
void Vehicle::finish_waiting_actions() {
  for (InstantEntry& entry : instant_) {
    if (entry.state.done()) continue;
    if (entry.pauses && (!paused_ || !motion_.driving)) {
      entry.state.status = paused_ ? ActionStatus::Finished : ActionStatus::Failed;
      if (!paused_) entry.state.result = "the pause ended before the vehicle had stopped";
      changed_ = true;
    }
  }
  if (!cancelling_ || motion_.driving || queue_.running()) return;
  cancelling_ = false;
  changed_ = true;
  order_.clear_ahead();
  leave_.clear();
  unreachable_ = false;
  set_condition(Fault::NodeUnreachable, false, {}, {});
  set_condition(Fault::CorridorClosed, false, {}, {});
  for (InstantEntry& entry : instant_) {
    if (entry.cancels && !entry.state.done()) entry.state.status = ActionStatus::Finished;
  }
  rebuild_route();
}

}  // namespace fairway::vda5050
