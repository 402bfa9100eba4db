// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway_dds/message_types.hpp"
#include "ros2_actions.h"

namespace fairway::dds {

template <>
inline const dds_topic_descriptor_t& descriptor<action_msgs_msg_dds__GoalStatusArray_>() noexcept {
  return action_msgs_msg_dds__GoalStatusArray__desc;
}
template <>
inline const dds_topic_descriptor_t&
descriptor<action_msgs_srv_dds__CancelGoal_Request_>() noexcept {
  return action_msgs_srv_dds__CancelGoal_Request__desc;
}
template <>
inline const dds_topic_descriptor_t&
descriptor<action_msgs_srv_dds__CancelGoal_Response_>() noexcept {
  return action_msgs_srv_dds__CancelGoal_Response__desc;
}

/// The types of an action, and its name below the robot's namespace.
struct NavigateToPose {
  static constexpr const char* kName = "navigate_to_pose";
  using Goal = nav2_msgs_action_dds__NavigateToPose_Goal_;
  using Result = nav2_msgs_action_dds__NavigateToPose_Result_;
  using Feedback = nav2_msgs_action_dds__NavigateToPose_Feedback_;
  using SendGoalRequest = nav2_msgs_action_dds__NavigateToPose_SendGoal_Request_;
  using SendGoalResponse = nav2_msgs_action_dds__NavigateToPose_SendGoal_Response_;
  using GetResultRequest = nav2_msgs_action_dds__NavigateToPose_GetResult_Request_;
  using GetResultResponse = nav2_msgs_action_dds__NavigateToPose_GetResult_Response_;
  using FeedbackMessage = nav2_msgs_action_dds__NavigateToPose_FeedbackMessage_;
};

struct FollowPath {
  static constexpr const char* kName = "follow_path";
  using Goal = nav2_msgs_action_dds__FollowPath_Goal_;
  using Result = nav2_msgs_action_dds__FollowPath_Result_;
  using Feedback = nav2_msgs_action_dds__FollowPath_Feedback_;
  using SendGoalRequest = nav2_msgs_action_dds__FollowPath_SendGoal_Request_;
  using SendGoalResponse = nav2_msgs_action_dds__FollowPath_SendGoal_Response_;
  using GetResultRequest = nav2_msgs_action_dds__FollowPath_GetResult_Request_;
  using GetResultResponse = nav2_msgs_action_dds__FollowPath_GetResult_Response_;
  using FeedbackMessage = nav2_msgs_action_dds__FollowPath_FeedbackMessage_;
};

template <>
inline const dds_topic_descriptor_t& descriptor<NavigateToPose::SendGoalRequest>() noexcept {
  return nav2_msgs_action_dds__NavigateToPose_SendGoal_Request__desc;
}
template <>
inline const dds_topic_descriptor_t& descriptor<NavigateToPose::SendGoalResponse>() noexcept {
  return nav2_msgs_action_dds__NavigateToPose_SendGoal_Response__desc;
}
template <>
inline const dds_topic_descriptor_t& descriptor<NavigateToPose::GetResultRequest>() noexcept {
  return nav2_msgs_action_dds__NavigateToPose_GetResult_Request__desc;
}
template <>
inline const dds_topic_descriptor_t& descriptor<NavigateToPose::GetResultResponse>() noexcept {
  return nav2_msgs_action_dds__NavigateToPose_GetResult_Response__desc;
}
template <>
inline const dds_topic_descriptor_t& descriptor<NavigateToPose::FeedbackMessage>() noexcept {
  return nav2_msgs_action_dds__NavigateToPose_FeedbackMessage__desc;
}
template <>
inline const dds_topic_descriptor_t& descriptor<FollowPath::SendGoalRequest>() noexcept {
  return nav2_msgs_action_dds__FollowPath_SendGoal_Request__desc;
}
template <>
inline const dds_topic_descriptor_t& descriptor<FollowPath::SendGoalResponse>() noexcept {
  return nav2_msgs_action_dds__FollowPath_SendGoal_Response__desc;
}
template <>
inline const dds_topic_descriptor_t& descriptor<FollowPath::GetResultRequest>() noexcept {
  return nav2_msgs_action_dds__FollowPath_GetResult_Request__desc;
}
template <>
inline const dds_topic_descriptor_t& descriptor<FollowPath::GetResultResponse>() noexcept {
  return nav2_msgs_action_dds__FollowPath_GetResult_Response__desc;
}
template <>
inline const dds_topic_descriptor_t& descriptor<FollowPath::FeedbackMessage>() noexcept {
  return nav2_msgs_action_dds__FollowPath_FeedbackMessage__desc;
}

}  // namespace fairway::dds
