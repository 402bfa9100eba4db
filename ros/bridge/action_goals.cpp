// SPDX-License-Identifier: Apache-2.0
#include "bridge/action_goals.hpp"

#include <algorithm>
#include <utility>

#include "fairway/base/contract.hpp"

namespace fairway::bridge {

bool ActionGoals::accept(const GoalId& id, std::int64_t time) {
  if (find(id) != nullptr) return false;
  if (active() != nullptr) {
    end(ActionStatus::Aborted, {.text = "replaced by a new goal of this action"}, time);
  }
  if (goals_.size() == kMost) goals_.erase(goals_.begin());
  goals_.push_back(
      {.id = id, .accepted = time, .status = ActionStatus::Executing, .outcome = {}, .ended = 0});
  return true;
}

CancelAnswer ActionGoals::cancel(const GoalId& id, std::int64_t stamp) {
  const bool every = id == GoalId{};
  CancelAnswer answer;
  for (ActionGoal& goal : goals_) {
    const bool named = every ? stamp == 0 : goal.id == id;
    const bool older = stamp != 0 && goal.accepted <= stamp;
    if (is_terminal(goal.status) || !(named || older)) continue;
    goal.status = ActionStatus::Canceling;
    answer.canceling.push_back(goal);
  }
  if (!answer.canceling.empty()) return answer;
  const ActionGoal* const known = every ? nullptr : find(id);
  answer.code = every              ? CancelAnswer::Code::Rejected
                : known == nullptr ? CancelAnswer::Code::UnknownGoal
                                   : CancelAnswer::Code::Terminated;
  return answer;
}

void ActionGoals::end(ActionStatus status, ActionOutcome outcome, std::int64_t time) {
  FAIRWAY_EXPECTS(active() != nullptr && is_terminal(status));
  ActionGoal& goal = goals_.back();
  goal.status = status;
  goal.outcome = std::move(outcome);
  goal.ended = time;
}

void ActionGoals::forget_old(std::int64_t time) {
  std::erase_if(goals_, [time](const ActionGoal& goal) {
    return is_terminal(goal.status) && time - goal.ended > kKept;
  });
}

const ActionGoal* ActionGoals::find(const GoalId& id) const noexcept {
  const auto found = std::find_if(goals_.begin(), goals_.end(),
                                  [&](const ActionGoal& goal) { return goal.id == id; });
  return found == goals_.end() ? nullptr : &*found;
}

const ActionGoal* ActionGoals::active() const noexcept {
  return goals_.empty() || is_terminal(goals_.back().status) ? nullptr : &goals_.back();
}

}  // namespace fairway::bridge
