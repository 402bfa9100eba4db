// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "fairway_dds/actions/action_server.hpp"

namespace fairway::dds {

/// A client of one ROS 2 action, which makes the same requests as `ros2 action send_goal`.
///
/// Every request has a number; its answer arrives with the same number in a later `receive`.
template <typename Action>
class ActionClient {
 public:
  explicit ActionClient(Participant& participant)
      : send_goal_(participant, action_topic<Action>("send_goal")),
        cancel_goal_(participant, action_topic<Action>("cancel_goal")),
        get_result_(participant, action_topic<Action>("get_result")),
        feedback_(participant, action_topic<Action>("feedback"), {}),
        status_(participant, action_topic<Action>("status"), kLatched) {}

  /// Whether a server offers all services and topics of the action.
  [[nodiscard]] bool is_served() const {
    return send_goal_.is_served() && cancel_goal_.is_served() && get_result_.is_served() &&
           feedback_.is_written() && status_.is_written();
  }

  std::int64_t send(const bridge::GoalId& id, const typename Action::Goal& goal) noexcept {
    return send_goal_.request({.header = {}, .goal_id = to_uuid(id), .goal = goal});
  }

  /// Requests to cancel a goal; an id of zeros stands for all goals.
  std::int64_t cancel(const bridge::GoalId& id, std::int64_t stamp = 0) noexcept {
    return cancel_goal_.request(
        {.header = {}, .goal_info = {.goal_id = to_uuid(id), .stamp = stamp_of(stamp)}});
  }

  std::int64_t request_result(const bridge::GoalId& id) noexcept {
    return get_result_.request({.header = {}, .goal_id = to_uuid(id)});
  }

  /// Calls one of the functions with every message that has arrived: on_goal, on_cancel and
  /// on_result with (number, response), on_feedback with (id, feedback), on_status with (id,
  /// status).
  template <typename Callbacks>
  void receive(Callbacks&& callbacks) {
    send_goal_.take(
        [&](std::int64_t number, const auto& response) { callbacks.on_goal(number, response); });
    cancel_goal_.take(
        [&](std::int64_t number, const auto& response) { callbacks.on_cancel(number, response); });
    feedback_.take([&](const typename Action::FeedbackMessage& message) {
      callbacks.on_feedback(to_id(message.goal_id), message.feedback);
    });
    status_.take([&](const action_msgs_msg_dds__GoalStatusArray_& message) {
      for (const action_msgs_msg_dds__GoalStatus_& status : elements(message.status_list))
        callbacks.on_status(to_id(status.goal_info.goal_id),
                            static_cast<bridge::ActionStatus>(status.status));
    });
    get_result_.take(
        [&](std::int64_t number, const auto& response) { callbacks.on_result(number, response); });
  }

 private:
  ServiceClient<typename Action::SendGoalRequest, typename Action::SendGoalResponse> send_goal_;
  ServiceClient<action_msgs_srv_dds__CancelGoal_Request_, action_msgs_srv_dds__CancelGoal_Response_>
      cancel_goal_;
  ServiceClient<typename Action::GetResultRequest, typename Action::GetResultResponse> get_result_;
  Reader<typename Action::FeedbackMessage> feedback_;
  Reader<action_msgs_msg_dds__GoalStatusArray_> status_;
};

}  // namespace fairway::dds
