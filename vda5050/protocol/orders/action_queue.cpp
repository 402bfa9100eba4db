// SPDX-License-Identifier: Apache-2.0
#include "protocol/orders/action_queue.hpp"

#include <algorithm>
#include <utility>

namespace fairway::vda5050 {

void ActionQueue::list(const std::vector<Action>& actions,
                       const std::vector<double>& durations,
                       std::uint32_t sequence,
                       bool released) {
  for (std::size_t i = 0; i < actions.size(); ++i) {
    entries_.push_back({.state = {.id = actions[i].id, .type = actions[i].type, .result = {}},
                        .blocking = actions[i].blocking,
                        .duration = i < durations.size() ? durations[i] : 0.0,
                        .sequence = sequence,
                        .released = released});
  }
}

void ActionQueue::drop_horizon() {
  std::erase_if(entries_, [](const Entry& entry) { return !entry.released && !entry.entered; });
}

void ActionQueue::enter(std::uint32_t sequence) {
  for (Entry& entry : entries_) {
    if (entry.sequence == sequence) entry.entered = true;
  }
}

void ActionQueue::leave(std::uint32_t sequence) {
  for (Entry& entry : entries_) {
    if (entry.sequence != sequence || entry.state.done()) continue;
    const bool ran = entry.state.status == ActionStatus::Running;
    entry.state.status = ran ? ActionStatus::Finished : ActionStatus::Failed;
    if (!ran) entry.state.result = "the edge ended before the action could start";
    changed_ = true;
  }
}

void ActionQueue::cancel() {
  for (Entry& entry : entries_) {
    if (entry.state.status != ActionStatus::Waiting) continue;
    entry.state.status = ActionStatus::Failed;
    entry.state.result = "the order was cancelled";
    changed_ = true;
  }
}

bool ActionQueue::update(double now) {
  bool changed = std::exchange(changed_, false);
  bool runs = false;
  bool excludes = false;
  for (Entry& entry : entries_) {
    if (entry.state.status != ActionStatus::Running) continue;
    if (now >= entry.end) {
      entry.state.status = ActionStatus::Finished;
      changed = true;
      continue;
    }
    runs = true;
    excludes = excludes || excludes_others(entry.blocking);
  }
  for (Entry& entry : entries_) {
    if (!entry.entered || entry.state.status != ActionStatus::Waiting) continue;
    // The queue keeps its order: an action that must wait also holds those behind it.
    if (excludes || (runs && excludes_others(entry.blocking))) break;
    entry.state.status = ActionStatus::Running;
    entry.end = now + entry.duration;
    runs = true;
    excludes = excludes_others(entry.blocking);
    changed = true;
  }
  return changed;
}

bool ActionQueue::forbids_driving() const {
  return std::any_of(entries_.begin(), entries_.end(), [](const Entry& entry) {
    return entry.entered && !entry.state.done() && vda5050::forbids_driving(entry.blocking);
  });
}

bool ActionQueue::will_stop_at(std::uint32_t sequence) const {
  return std::any_of(entries_.begin(), entries_.end(), [sequence](const Entry& entry) {
    return entry.sequence == sequence && !entry.state.done() &&
           vda5050::forbids_driving(entry.blocking);
  });
}

bool ActionQueue::running() const {
  return std::any_of(entries_.begin(), entries_.end(), [](const Entry& entry) {
    return entry.state.status == ActionStatus::Running;
  });
}

bool ActionQueue::all_done() const {
  return std::all_of(entries_.begin(), entries_.end(),
                     [](const Entry& entry) { return entry.state.done(); });
}

std::vector<ActionState> ActionQueue::states() const {
  std::vector<ActionState> states;
  states.reserve(entries_.size());
  for (const Entry& entry : entries_)
    states.push_back(entry.state);
  return states;
}

}  // namespace fairway::vda5050
