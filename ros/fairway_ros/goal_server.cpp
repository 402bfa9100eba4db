// SPDX-License-Identifier: Apache-2.0
#include "fairway_ros/goal_server.hpp"

namespace fairway::ros1 {

namespace {

constexpr std::size_t kMostSenders = 1000;

move_base_msgs::MoveBaseResult no_details() { return {}; }

}  // namespace

GoalServer::GoalServer(ros::NodeHandle node, bool cancel_with_client, Callbacks callbacks)
    : callbacks_(std::move(callbacks)),
      cancel_with_client_(cancel_with_client),
      feedback_(node.advertise<move_base_msgs::MoveBaseActionFeedback>(
          "move_base/feedback",
          10,
          ros::SubscriberStatusCallback(),
          [this](const ros::SingleSubscriberPublisher& client) { on_disconnect(client); })),
      raw_goals_(node.subscribe("move_base/goal", 10, &GoalServer::on_raw_goal, this)),
      simple_goals_(node.subscribe("move_base_simple/goal", 1, &GoalServer::on_simple_goal, this)),
      server_(
          node,
          "move_base",
          [this](GoalHandle goal) { on_goal(std::move(goal)); },
          [this](GoalHandle goal) { on_cancel(std::move(goal)); },
          false) {
  server_.start();
}

void GoalServer::on_raw_goal(
    const ros::MessageEvent<move_base_msgs::MoveBaseActionGoal const>& event) {
  if (senders_.size() > kMostSenders) senders_.clear();
  senders_[event.getMessage()->goal_id.id] = event.getPublisherName();
}

void GoalServer::on_goal(GoalHandle goal) {
  const std::string refusal = callbacks_.accept(goal.getGoal()->target_pose);
  if (!refusal.empty()) {
    ROS_WARN("goal rejected: %s", refusal.c_str());
    goal.setRejected(no_details(), refusal);
    return;
  }
  preempt("a new goal has replaced this one");
  goal.setAccepted();
  active_ = std::move(goal);
}

void GoalServer::on_cancel(GoalHandle goal) {
  if (!active_ || !(*active_ == goal)) return;
  callbacks_.cancel();
  preempt("cancelled");
}

void GoalServer::on_simple_goal(const geometry_msgs::PoseStamped::ConstPtr& goal) {
  const std::string refusal = callbacks_.accept(*goal);
  if (refusal.empty()) {
    preempt("a new goal has replaced this one");
  } else {
    ROS_WARN("goal rejected: %s", refusal.c_str());
  }
}

void GoalServer::on_disconnect(const ros::SingleSubscriberPublisher& client) {
  if (!active_ || !cancel_with_client_) return;
  const auto sender = senders_.find(active_->getGoalID().id);
  if (sender == senders_.end() || sender->second != client.getSubscriberName()) return;
  ROS_WARN("%s has disconnected: its goal is cancelled", sender->second.c_str());
  callbacks_.cancel();
  preempt("its client has disconnected");
}

void GoalServer::preempt(const char* reason) {
  if (!active_) return;
  active_->setCanceled(no_details(), reason);
  active_.reset();
}

void GoalServer::succeed(const std::string& text) {
  if (!active_) return;
  active_->setSucceeded(no_details(), text);
  active_.reset();
}

void GoalServer::abort(const std::string& text) {
  if (!active_) return;
  active_->setAborted(no_details(), text);
  active_.reset();
}

void GoalServer::give_feedback(const geometry_msgs::PoseStamped& pose) {
  if (!active_) return;
  move_base_msgs::MoveBaseFeedback feedback;
  feedback.base_position = pose;
  active_->publishFeedback(feedback);
}

}  // namespace fairway::ros1
