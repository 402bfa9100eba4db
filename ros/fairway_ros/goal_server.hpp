// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <actionlib/server/action_server.h>

#include <functional>
#include <map>
#include <optional>

#include <geometry_msgs/PoseStamped.h>
#include <move_base_msgs/MoveBaseAction.h>

namespace fairway::ros1 {

/// The sources of goals: the action `move_base`, with feedback, result and cancel, and the plain
/// topic `move_base_simple/goal`. Both work as in move_base, so that its clients need no change.
///
/// There is one goal at a time: a new one of either kind preempts the old one. A goal of the action
/// also ends when the connection to its client ends for any reason.
class GoalServer {
 public:
  struct Callbacks {
    /// Called with a new goal; returns the reason for refusing it, if any.
    std::function<std::string(const geometry_msgs::PoseStamped&)> accept;
    /// Called when the robot must brake to standstill.
    std::function<void()> cancel;
  };

  GoalServer(ros::NodeHandle node, bool cancel_with_client, Callbacks callbacks);

  /// Ends the goal of the action, if there is one.
  void succeed(const std::string& text);
  void abort(const std::string& text);

  void give_feedback(const geometry_msgs::PoseStamped& pose);

 private:
  using Server = actionlib::ActionServer<move_base_msgs::MoveBaseAction>;
  using GoalHandle = Server::GoalHandle;

  void on_goal(GoalHandle goal);
  void on_cancel(GoalHandle goal);
  void on_simple_goal(const geometry_msgs::PoseStamped::ConstPtr& goal);
  void on_raw_goal(const ros::MessageEvent<move_base_msgs::MoveBaseActionGoal const>& event);
  void on_disconnect(const ros::SingleSubscriberPublisher& client);
  void preempt(const char* reason);

  Callbacks callbacks_;
  bool cancel_with_client_;
  std::optional<GoalHandle> active_;
  std::map<std::string, std::string> senders_;  // sender's node name, by the goal's id
  ros::Publisher feedback_;                     // only to detect clients that disconnect
  ros::Subscriber raw_goals_;                   // only to learn the sender
  ros::Subscriber simple_goals_;
  Server server_;
};

}  // namespace fairway::ros1
