// SPDX-License-Identifier: Apache-2.0
// The goals of the navigation node: from topics and actions to the pilot, and what became of them.
#include <cmath>
#include <optional>
#include <utility>

#include "bridge/message_conversions.hpp"
#include "fairway_dds/dds_conversions.hpp"
#include "fairway_dds/navigation_node.hpp"

namespace fairway::dds {

namespace {

std::optional<double> finite(double heading) {
  return std::isfinite(heading) ? std::optional(heading) : std::nullopt;
}

}  // namespace

void NavigationNode::take_goal(const geometry_msgs_msg_dds__PoseStamped_& message,
                               bool from_action) {
  const Pose2 pose = bridge::to_pose(message.pose);
  if (!from_action && !is_finite(pose)) {
    tell_status("goal rejected: not finite");
    return;
  }
  if (!from_action) {
    actions_.abort(ActionFault::Unknown, "replaced by a goal of the topic goal_pose", now());
  }
  drive_.reset();
  progress_.begin(now());
  waiting_goal_ = WaitingGoal{
      .frame = message.header.frame_id, .pose = pose, .from_action = from_action, .since = now()};
}

// The goal of the action FollowPath: the last pose of a path.
void NavigationNode::take_path(const nav_msgs_msg_dds__Path_& message) {
  const auto poses = elements(message.poses);
  drive_.reset();
  progress_.begin(now());
  if (poses.empty()) {
    actions_.abort(ActionFault::InvalidPath, "expected a path with poses, found none", now());
    cancel_goal();
    return;
  }
  WaitingGoal goal{.frame = message.header.frame_id,
                   .pose = bridge::to_pose(poses.back().pose),
                   .from_action = true,
                   .since = now()};
  for (const geometry_msgs_msg_dds__PoseStamped_& pose : poses)
    goal.path.push_back(bridge::to_pose(pose.pose));
  waiting_goal_ = std::move(goal);
}

void NavigationNode::cancel_goal() {
  drop_goal();
  pilot_.cancel();
}

void NavigationNode::drop_goal() {
  waiting_goal_.reset();
  drive_.reset();
}

// A goal may come before its frame is known; it waits. The sender of a topic could not be informed;
// a goal of an action ends with an error after some time.
void NavigationNode::place_goal() {
  constexpr double kLongestWait = 2.0;  // [s], of an action
  if (!waiting_goal_) return;
  const auto frame = find_frame(waiting_goal_->frame);
  const bool known = frame && (!waiting_goal_->from_action || pilot_.pose());
  const bool is_late =
      waiting_goal_->from_action && std::abs(now() - waiting_goal_->since) > kLongestWait;
  if (known) {
    const std::string fault = start_goal(*frame);
    if (!fault.empty()) {
      const bool path = !waiting_goal_->path.empty();
      cancel_goal();
      actions_.abort(path ? ActionFault::InvalidPath : ActionFault::Unknown, fault, now());
    }
    waiting_goal_.reset();
    return;
  }
  const std::string text =
      frame ? "goal waits for the robot's pose" : "goal waits for frame " + waiting_goal_->frame;
  if (text != told_) tell_status(text);
  if (!is_late) return;
  cancel_goal();
  actions_.abort(ActionFault::NoTransform,
                 frame ? "the robot's pose in the frame " + world_frame() + " is not known"
                       : "no transform from the goal's frame to " + world_frame(),
                 now());
}

// Gives the waiting goal to the pilot. Returns why it is not valid, or an empty text.
std::string NavigationNode::start_goal(const Pose2& frame) {
  const Pose2 goal = bridge::compose(frame, waiting_goal_->pose);
  if (waiting_goal_->path.empty()) {
    if (!is_finite(goal)) return "expected a finite position and a rotation of length 1";
    goal_position_ = goal.position;
    pilot_.set_goal({.position = goal.position, .heading = goal.heading});
    return {};
  }
  Path path;
  PosePath poses;
  for (const Pose2& pose : waiting_goal_->path) {
    const Pose2 placed = bridge::compose(frame, pose);
    if (!is_plausible(Pose2{.position = placed.position, .heading = 0.0})) {
      return "pose " + std::to_string(path.waypoints.size()) +
             " of the path: expected a position within 10000 km";
    }
    path.waypoints.push_back(placed.position);
    poses.poses.push_back({.position = placed.position, .heading = finite(placed.heading)});
  }
  goal_position_ = goal.position;
  if (options_.pilot.body) {
    if (options_.max_deviation > 0.0) poses.max_deviation = options_.max_deviation;
    pilot_.follow(std::move(poses));
    return {};
  }
  const std::optional<double> heading = finite(goal.heading);
  drive_.emplace(std::move(path), heading, pilot_.pose()->position, options_.max_deviation,
                 pilot_.settings().robot.radius);
  return {};
}

void NavigationNode::follow_piece() {
  const std::optional<Pose2> here = pilot_.pose();
  if (!drive_ || !here) return;
  if (auto piece = drive_->next(here->position)) {
    pilot_.follow(std::move(piece->path), piece->heading, piece->bound);
  }
}

// Returns whether the pilot has reached the end of a piece of a path that is not the last.
bool NavigationNode::ends_piece(const bridge::PilotStep& step, double now) {
  if (drive_) drive_->note(step, now);
  return drive_ && step.end == bridge::GoalEnd::Reached && !drive_->end_piece();
}

// Whether the goal will never be reached, so that waiting makes no sense.
bool NavigationNode::is_outside_map() const {
  const bridge::AnyNavigator* const navigator = pilot_.navigator();
  return options_.pilot.use_map && navigator != nullptr && !waiting_goal_ && !drive_ &&
         pilot_.has_planned() && navigator->plan_is_current() &&
         navigator->plan().path_status == PathStatus::GoalOutsideMap;
}

// Length of the path to the goal; without a path, the distance.
double NavigationNode::remaining_length(const Eigen::Vector2d& position) const {
  if (drive_) return drive_->remaining();
  const bridge::AnyNavigator& navigator = *pilot_.navigator();
  if (const auto place = navigator.place_on_path()) return place->remaining;
  if (navigator.plan_is_current() && navigator.plan().usable()) {
    return bridge::remaining_length(navigator.plan().path, position);
  }
  return (goal_position_ - position).norm();
}

void NavigationNode::report_goal(const bridge::PilotStep& step, double now) {
  if (step.send) {
    std::string text = to_text(step.status);
    if (step.limit != LimitingFactor::None) text += std::string(": ") + to_text(step.limit);
    if (step.monitor != MonitorReason::None)
      text += std::string(", safety monitor: ") + bridge::to_text(step.monitor);
    if (step.status == NavigationStatus::NoPlan && pilot_.has_planned()) {
      text += ": " + pilot_.navigator()->why_no_plan();
    } else if (!step.explanation.empty()) {
      text += ": " + step.explanation;
    }
    if (step.end == bridge::GoalEnd::GivenUp) text = "goal given up: " + step.reason;
    if (step.end == bridge::GoalEnd::Reached || text != told_) tell_status(text);
  }
  if (!actions_.active()) return;
  const std::optional<Pose2> here = pilot_.pose();
  if (here && pilot_.navigator() != nullptr && !waiting_goal_) {
    progress_.update(step, remaining_length(here->position), now);
    actions_.give_feedback(progress_, *here, world_frame(), now);
  }
  if (actions_.canceling()) {
    if (pilot_.state() == bridge::PilotState::Idle) actions_.canceled(now);
  } else if (step.end == bridge::GoalEnd::Reached) {
    drop_goal();
    actions_.succeed(now);
  } else if (step.end == bridge::GoalEnd::GivenUp) {
    drop_goal();
    actions_.abort(fault_of(step.path), step.reason, now);
  } else if (step.limit == LimitingFactor::InvalidGoal) {
    const std::string why = pilot_.navigator()->why_no_plan();
    cancel_goal();
    actions_.abort(ActionFault::InvalidPath, why, now);
  } else if (is_outside_map()) {
    cancel_goal();
    actions_.abort(ActionFault::GoalOutsideMap, to_text(PathStatus::GoalOutsideMap), now);
  }
}

}  // namespace fairway::dds
