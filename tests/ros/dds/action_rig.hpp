// SPDX-License-Identifier: Apache-2.0
// A server and clients of the actions in one process. The clients do what `ros2 action send_goal`
// does.
#pragma once

#include <cstdlib>
#include <map>

#include <gtest/gtest.h>

#include "fairway_dds/actions/action_client.hpp"
#include "fairway_dds/actions/goal_actions.hpp"
#include "fairway_dds/navigation_node.hpp"

namespace fairway::dds {

using bridge::ActionStatus;
using bridge::GoalId;

inline constexpr GoalId kFirst{1, 2, 3};
inline constexpr GoalId kSecond{4, 5, 6};
inline constexpr double kLongest =
    20.0;  // [s] until a message must have arrived, on a slow machine

// Keeps all traffic inside this machine.
inline dds_domainid_t domain() {
  setenv("CYCLONEDDS_URI",
         "<CycloneDDS><Domain><General><Interfaces><NetworkInterface name=\"lo\"/></Interfaces>"
         "<AllowMulticast>false</AllowMulticast></General></Domain></CycloneDDS>",
         0);
  return 77;
}

// What a client has received.
template <typename Action>
struct Client {
  explicit Client(Participant& participant) : client(participant) {}

  void receive() { client.receive(*this); }
  void on_goal(std::int64_t number, const typename Action::SendGoalResponse& response) {
    accepted[number] = response.accepted;
  }
  void on_cancel(std::int64_t number, const action_msgs_srv_dds__CancelGoal_Response_& response) {
    canceled[number] = response.return_code;
    canceling = static_cast<int>(response.goals_canceling._length);
  }
  void on_result(std::int64_t number, const typename Action::GetResultResponse& response) {
    results[number] = static_cast<ActionStatus>(response.status);
    error_code = response.result.error_code;
    error = response.result.error_msg;
  }
  void on_feedback(const GoalId& id, const typename Action::Feedback& message) {
    feedback[id].push_back(message);
  }
  void on_status(const GoalId& id, ActionStatus status) { statuses[id] = status; }

  ActionClient<Action> client;
  std::map<std::int64_t, bool> accepted;
  std::map<std::int64_t, int> canceled;
  std::map<std::int64_t, ActionStatus> results;
  std::map<GoalId, ActionStatus> statuses;
  std::map<GoalId, std::vector<typename Action::Feedback>> feedback;
  int canceling = 0;
  int error_code = 0;
  std::string error;
};

struct Actions : testing::Test {
  Actions()
      : robot(domain(), "robot_0"),
        user(domain(), "robot_0"),
        actions(robot,
                {.navigate =
                     [this](const geometry_msgs_msg_dds__PoseStamped_& goal) {
                       frame = goal.header.frame_id;
                       target = {goal.pose.position.x, goal.pose.position.y};
                     },
                 .follow =
                     [this](const nav_msgs_msg_dds__Path_& path) {
                       frame = path.header.frame_id;
                       poses = static_cast<int>(path.poses._length);
                     },
                 .cancel = [this] { ++cancels; }}),
        navigate(user),
        follow(user) {
    wait_for([this] { return navigate.client.is_served() && follow.client.is_served(); });
  }

  // Serves and receives until something has happened.
  template <typename Happened>
  void wait_for(Happened&& happened) {
    const double begin = wall_time();
    while (!happened()) {
      ASSERT_LT(wall_time() - begin, kLongest) << "it has not happened";
      user.wait(0.005);
      actions.serve(wall_time());
      navigate.receive();
      follow.receive();
    }
  }

  std::int64_t send(const GoalId& id, double x = 3.0) {
    std::string map = "map";
    std::string none;
    NavigateToPose::Goal goal{};
    goal.pose.header = header(map, 12.5);
    goal.pose.pose.position = {.x = x, .y = -4.0, .z = 0.0};
    goal.pose.pose.orientation.w = 1.0;
    goal.behavior_tree = none.data();
    return navigate.client.send(id, goal);
  }

  // Sends a goal and waits until it was answered; returns whether it was accepted.
  bool accepts(const GoalId& id) {
    const std::int64_t number = send(id);
    wait_for([&] { return navigate.accepted.count(number) > 0; });
    return navigate.accepted[number];
  }

  ActionStatus result_of(const GoalId& id) {
    const std::int64_t number = navigate.client.request_result(id);
    wait_for([&] { return navigate.results.count(number) > 0; });
    return navigate.results[number];
  }

  int cancel(const GoalId& id) {
    const std::int64_t number = navigate.client.cancel(id);
    wait_for([&] { return navigate.canceled.count(number) > 0; });
    return navigate.canceled[number];
  }

  Participant robot;
  Participant user;
  GoalActions actions;
  Client<NavigateToPose> navigate;
  Client<FollowPath> follow;
  std::string frame;
  Eigen::Vector2d target = Eigen::Vector2d::Zero();
  int poses = 0;
  int cancels = 0;
};

}  // namespace fairway::dds
