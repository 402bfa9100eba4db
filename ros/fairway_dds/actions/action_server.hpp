// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "bridge/action_goals.hpp"
#include "fairway_dds/actions/dds_service.hpp"
#include "fairway_dds/dds_conversions.hpp"

namespace fairway::dds {

[[nodiscard]] inline bridge::GoalId to_id(
    const unique_identifier_msgs_msg_dds__UUID_& message) noexcept {
  bridge::GoalId id{};
  std::copy_n(static_cast<const std::uint8_t*>(message.uuid), id.size(), id.begin());
  return id;
}
[[nodiscard]] inline unique_identifier_msgs_msg_dds__UUID_ to_uuid(
    const bridge::GoalId& id) noexcept {
  unique_identifier_msgs_msg_dds__UUID_ message{};
  std::copy(id.begin(), id.end(), static_cast<std::uint8_t*>(message.uuid));
  return message;
}

[[nodiscard]] inline std::int64_t nanoseconds_of(
    const builtin_interfaces_msg_dds__Time_& time) noexcept {
  return std::int64_t{time.sec} * 1'000'000'000 + time.nanosec;
}
[[nodiscard]] inline builtin_interfaces_msg_dds__Time_ stamp_of(std::int64_t nanoseconds) noexcept {
  return {.sec = static_cast<std::int32_t>(nanoseconds / 1'000'000'000),
          .nanosec = static_cast<std::uint32_t>(nanoseconds % 1'000'000'000)};
}

/// The name of a topic or service of an action.
template <typename Action>
[[nodiscard]] std::string action_topic(const std::string& part) {
  return std::string(Action::kName) + "/_action/" + part;
}

/// A server of one ROS 2 action, with the topics and services that ROS 2's clients expect. It
/// executes one goal at a time: a new one replaces the one before, which is aborted, as in Nav2.
template <typename Action>
class ActionServer {
 public:
  explicit ActionServer(Participant& participant)
      : send_goal_(participant, action_topic<Action>("send_goal")),
        cancel_goal_(participant, action_topic<Action>("cancel_goal")),
        get_result_(participant, action_topic<Action>("get_result")),
        feedback_(participant, action_topic<Action>("feedback"), {}),
        status_(participant, action_topic<Action>("status"), kLatched) {}

  /// Handles all requests. @param on_goal  Called with each accepted goal. @param on_cancel  Called
  /// when the active goal was cancelled; it stays active until `end`. @param now  [ns]
  /// @return whether a client with another middleware was found, which cannot be served.
  template <typename OnGoal, typename OnCancel>
  bool serve(std::int64_t now, OnGoal&& on_goal, OnCancel&& on_cancel) {
    const double seconds = 1e-9 * static_cast<double>(now);
    goals_.forget_old(now);
    bool foreign = false;
    foreign |= send_goal_.take(seconds, [&](const typename Action::SendGoalRequest& request) {
      take_goal(request, now, on_goal);
    });
    foreign |= cancel_goal_.take(seconds, [&](const action_msgs_srv_dds__CancelGoal_Request_& r) {
      if (take_cancel(r)) on_cancel();
    });
    foreign |= get_result_.take(seconds, [&](const typename Action::GetResultRequest& request) {
      waiting_.push_back({.client = request.header, .id = to_id(request.goal_id)});
    });
    answer_results();
    return foreign;
  }

  [[nodiscard]] const bridge::ActionGoal* active() const noexcept { return goals_.active(); }

  /// Ends the active goal, if there is one.
  void end(bridge::ActionStatus status, bridge::ActionOutcome outcome, std::int64_t now) {
    if (goals_.active() == nullptr) return;
    goals_.end(status, std::move(outcome), now);
    publish_status();
    answer_results();
  }

  /// Publishes feedback for the active goal, if there is one.
  void give_feedback(const typename Action::Feedback& feedback) noexcept {
    if (goals_.active() == nullptr) return;
    feedback_.send({.goal_id = to_uuid(goals_.active()->id), .feedback = feedback});
  }

 private:
  struct WaitingResult {
    ServiceHeader client;
    bridge::GoalId id;
  };

  template <typename OnGoal>
  void take_goal(const typename Action::SendGoalRequest& request,
                 std::int64_t now,
                 OnGoal&& on_goal) {
    const bool accepted = goals_.accept(to_id(request.goal_id), now);
    send_goal_.reply(request.header,
                     {.header = {}, .accepted = accepted, .stamp = stamp_of(accepted ? now : 0)});
    if (!accepted) return;
    publish_status();
    on_goal(request.goal);
  }

  // Returns whether the active goal was cancelled.
  bool take_cancel(const action_msgs_srv_dds__CancelGoal_Request_& request) {
    const bridge::CancelAnswer answer =
        goals_.cancel(to_id(request.goal_info.goal_id), nanoseconds_of(request.goal_info.stamp));
    std::vector<action_msgs_msg_dds__GoalInfo_> infos;
    for (const bridge::ActionGoal& goal : answer.canceling)
      infos.push_back({.goal_id = to_uuid(goal.id), .stamp = stamp_of(goal.accepted)});
    action_msgs_srv_dds__CancelGoal_Response_ response{};
    response.return_code = static_cast<std::int8_t>(answer.code);
    point_to(infos, response.goals_canceling);
    cancel_goal_.reply(request.header, response);
    if (infos.empty()) return false;
    publish_status();
    return true;
  }

  // Answers the requests for results of goals that have ended, or are not known.
  void answer_results() {
    std::erase_if(waiting_, [this](const WaitingResult& waiting) {
      const bridge::ActionGoal* const goal = goals_.find(waiting.id);
      if (goal != nullptr && !bridge::is_terminal(goal->status)) return false;
      std::string text = goal != nullptr ? goal->outcome.text : "the goal is not known";
      typename Action::GetResultResponse response{};
      if (goal != nullptr) {
        response.status = static_cast<std::int8_t>(goal->status);
        response.result.error_code = goal->outcome.error_code;
      }
      response.result.error_msg = text.data();
      get_result_.reply(waiting.client, response);
      return true;
    });
  }

  void publish_status() noexcept {
    std::vector<action_msgs_msg_dds__GoalStatus_> statuses;
    for (const bridge::ActionGoal& goal : goals_.all()) {
      statuses.push_back(
          {.goal_info = {.goal_id = to_uuid(goal.id), .stamp = stamp_of(goal.accepted)},
           .status = static_cast<std::int8_t>(goal.status)});
    }
    action_msgs_msg_dds__GoalStatusArray_ message{};
    point_to(statuses, message.status_list);
    status_.send(message);
  }

  bridge::ActionGoals goals_;
  std::vector<WaitingResult> waiting_;
  ServiceServer<typename Action::SendGoalRequest, typename Action::SendGoalResponse> send_goal_;
  ServiceServer<action_msgs_srv_dds__CancelGoal_Request_, action_msgs_srv_dds__CancelGoal_Response_>
      cancel_goal_;
  ServiceServer<typename Action::GetResultRequest, typename Action::GetResultResponse> get_result_;
  Writer<typename Action::FeedbackMessage> feedback_;
  Writer<action_msgs_msg_dds__GoalStatusArray_> status_;
};

}  // namespace fairway::dds
