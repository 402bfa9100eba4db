// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace fairway::bridge {

/// The identity of a goal of a ROS 2 action; all zeros mean every goal.
using GoalId = std::array<std::uint8_t, 16>;

/// The state of a goal, with the numbers of action_msgs/GoalStatus.
enum class ActionStatus : std::int8_t {
  Unknown = 0,
  Accepted = 1,
  Executing = 2,
  Canceling = 3,  ///< the robot brakes, because a client has cancelled the goal
  Succeeded = 4,
  Canceled = 5,
  Aborted = 6,
};

/// Returns whether a goal in this state has ended.
[[nodiscard]] constexpr bool is_terminal(ActionStatus status) noexcept {
  return status == ActionStatus::Succeeded || status == ActionStatus::Canceled ||
         status == ActionStatus::Aborted;
}

/// The reason why a goal ended: an error code of the action, 0 for none, and a text for the user.
struct ActionOutcome {
  std::uint16_t error_code = 0;
  std::string text;
};

/// A goal that was accepted.
struct ActionGoal {
  GoalId id{};
  std::int64_t accepted = 0;  ///< time of acceptance [ns]
  ActionStatus status = ActionStatus::Accepted;
  ActionOutcome outcome;   ///< of a goal that has ended
  std::int64_t ended = 0;  ///< [ns]
};

/// The answer to a cancel request, with the numbers of action_msgs/CancelGoal.
struct CancelAnswer {
  enum class Code : std::int8_t { None = 0, Rejected = 1, UnknownGoal = 2, Terminated = 3 };
  Code code = Code::None;
  std::vector<ActionGoal> canceling;
};

/// The goals of a ROS 2 action server that executes one goal at a time. Goals that have ended are
/// kept for a while, so that a client can request their result.
class ActionGoals {
 public:
  static constexpr std::int64_t kKept = 60'000'000'000;  ///< time after the end of a goal [ns]
  static constexpr std::size_t kMost = 64;               ///< goals; the oldest are forgotten

  /// Starts to execute a new goal. A goal that is still active is aborted with a text.
  /// @return whether the goal was accepted; not if its id was used before.
  bool accept(const GoalId& id, std::int64_t time);

  /// Cancels goals by the rules of action_msgs/CancelGoal.
  /// @param stamp  All goals accepted until this time are cancelled, too; 0: none [ns].
  [[nodiscard]] CancelAnswer cancel(const GoalId& id, std::int64_t stamp);

  /// Ends the active goal. @pre there is one, and `status` is terminal.
  void end(ActionStatus status, ActionOutcome outcome, std::int64_t time);

  /// Forgets goals that ended long ago.
  void forget_old(std::int64_t time);

  [[nodiscard]] const ActionGoal* find(const GoalId& id) const noexcept;
  [[nodiscard]] const ActionGoal* active() const noexcept;  ///< null if there is none
  [[nodiscard]] std::span<const ActionGoal> all() const noexcept { return goals_; }

 private:
  std::vector<ActionGoal> goals_;  // in the order of acceptance; only the last may be active
};

}  // namespace fairway::bridge
