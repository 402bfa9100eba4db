// SPDX-License-Identifier: Apache-2.0
#include "fairway_dds/actions/goal_actions.hpp"

#include <cmath>
#include <cstdio>

#include "bridge/message_conversions.hpp"

namespace fairway::dds {

namespace {

std::int64_t nanoseconds(double seconds) noexcept {
  return static_cast<std::int64_t>(std::llround(seconds * 1e9));
}

builtin_interfaces_msg_dds__Duration_ duration(double seconds) noexcept {
  const builtin_interfaces_msg_dds__Time_ time = time_of(std::min(seconds, 1e9));
  return {.sec = time.sec, .nanosec = time.nanosec};
}

}  // namespace

std::uint16_t navigation_code(ActionFault fault) noexcept {
  switch (fault) {
    case ActionFault::None:
      return 0;
    case ActionFault::Unknown:
    case ActionFault::InvalidPath:
      return 200;
    case ActionFault::NoTransform:
      return 202;
    case ActionFault::StartOutsideMap:
      return 203;
    case ActionFault::GoalOutsideMap:
      return 204;
    case ActionFault::StartBlocked:
      return 205;
    case ActionFault::GoalBlocked:
      return 206;
    case ActionFault::NoPath:
      return 208;
    case ActionFault::NoProgress:
      return 105;
  }
  return 200;
}

std::uint16_t following_code(ActionFault fault) noexcept {
  switch (fault) {
    case ActionFault::None:
      return 0;
    case ActionFault::Unknown:
      return 100;
    case ActionFault::NoTransform:
      return 102;
    case ActionFault::InvalidPath:
      return 103;
    case ActionFault::NoProgress:
      return 105;
    case ActionFault::StartOutsideMap:
    case ActionFault::GoalOutsideMap:
    case ActionFault::StartBlocked:
    case ActionFault::GoalBlocked:
    case ActionFault::NoPath:
      return 106;
  }
  return 100;
}

ActionFault fault_of(PathStatus path) noexcept {
  switch (path) {
    case PathStatus::Found:
      return ActionFault::NoProgress;
    case PathStatus::StartOutsideMap:
      return ActionFault::StartOutsideMap;
    case PathStatus::GoalOutsideMap:
      return ActionFault::GoalOutsideMap;
    case PathStatus::StartBlocked:
      return ActionFault::StartBlocked;
    case PathStatus::GoalBlocked:
      return ActionFault::GoalBlocked;
    case PathStatus::NoConnection:
      return ActionFault::NoPath;
    case PathStatus::InvalidInput:
      return ActionFault::Unknown;
  }
  return ActionFault::Unknown;
}

GoalActions::GoalActions(Participant& participant, Callbacks callbacks)
    : callbacks_(std::move(callbacks)),
      navigate_(participant),
      follow_(participant) {}

void GoalActions::serve(double now) {
  const std::int64_t time = nanoseconds(now);
  const bridge::ActionOutcome replaced{.text = "replaced by a goal of another action"};
  bool foreign = navigate_.serve(
      time,
      [&](const NavigateToPose::Goal& goal) {
        follow_.end(bridge::ActionStatus::Aborted, replaced, time);
        callbacks_.navigate(goal.pose);
      },
      callbacks_.cancel);
  foreign |= follow_.serve(
      time,
      [&](const FollowPath::Goal& goal) {
        navigate_.end(bridge::ActionStatus::Aborted, replaced, time);
        callbacks_.follow(goal.path);
      },
      callbacks_.cancel);
  if (!foreign || std::exchange(warned_, true)) return;
  std::fprintf(stderr,
               "fairway: a client of an action is not served: expected the service header of "
               "rmw_cyclonedds_cpp, found another middleware; start the client with "
               "RMW_IMPLEMENTATION=rmw_cyclonedds_cpp, or use the topic goal_pose\n");
}

bool GoalActions::canceling() const noexcept {
  for (const bridge::ActionGoal* const goal : {navigate_.active(), follow_.active()}) {
    if (goal != nullptr && goal->status == bridge::ActionStatus::Canceling) return true;
  }
  return false;
}

void GoalActions::give_feedback(const bridge::DriveProgress& progress,
                                const Pose2& pose,
                                const std::string& frame,
                                double now) {
  NavigateToPose::Feedback feedback{};
  feedback.current_pose.header = header(frame, now);
  bridge::set_pose(pose, feedback.current_pose.pose);
  feedback.navigation_time = duration(progress.seconds());
  feedback.estimated_time_remaining = duration(progress.seconds_left());
  feedback.number_of_recoveries = static_cast<std::int16_t>(progress.recoveries());
  feedback.distance_remaining = static_cast<float>(progress.remaining());
  navigate_.give_feedback(feedback);
  follow_.give_feedback({.distance_to_goal = static_cast<float>(progress.remaining()),
                         .speed = static_cast<float>(progress.speed())});
}

void GoalActions::end(bridge::ActionStatus status,
                      ActionFault fault,
                      const std::string& text,
                      double now) {
  navigate_.end(status, {.error_code = navigation_code(fault), .text = text}, nanoseconds(now));
  follow_.end(status, {.error_code = following_code(fault), .text = text}, nanoseconds(now));
}

void GoalActions::succeed(double now) {
  end(bridge::ActionStatus::Succeeded, ActionFault::None, "", now);
}

void GoalActions::abort(ActionFault fault, const std::string& text, double now) {
  end(bridge::ActionStatus::Aborted, fault, text, now);
}

void GoalActions::canceled(double now) {
  end(bridge::ActionStatus::Canceled, ActionFault::None, "", now);
}

}  // namespace fairway::dds
