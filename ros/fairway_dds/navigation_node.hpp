// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "bridge/cycle_clock.hpp"
#include "bridge/pilot.hpp"
#include "fairway_dds/actions/goal_actions.hpp"
#include "fairway_dds/actions/path_drive.hpp"
#include "fairway_dds/dds_topics.hpp"
#include "fairway_dds/fleet_topic.hpp"
#include "fairway_dds/sensor_topics.hpp"

namespace fairway::dds {

/// The options of the node from its command line.
struct NodeOptions {
  std::uint32_t domain = 0;  ///< ROS_DOMAIN_ID
  std::string space;         ///< the robot's namespace; empty for none
  std::string name;          ///< of the robot in its fleet; empty: no fleet
  std::string map_frame = "map";
  std::string base_frame = "base_link";
  bool stamped = false;        ///< commands as TwistStamped, Nav2's default since Kilted
  bool sim_time = false;       ///< the time is that of the topic /clock
  double max_deviation = 0.0;  ///< greatest distance from a path of FollowPath [m]; 0: no bound
  bridge::PilotOptions pilot;
};

/// The current time of ROS 2's system clock [s].
[[nodiscard]] double wall_time();

/// Navigation of one robot beside ROS 2 nodes, without ROS 2: converts messages and passes them to
/// a Pilot.
class NavigationNode {
 public:
  NavigationNode(const Settings& settings, const NodeOptions& options);

  /// Waits for messages, handles them, and runs a control cycle if one is due.
  void tick();

  /// Brakes, sends zero commands, and announces to the fleet that the robot leaves. Returns after
  /// the robot was commanded to stop, or when `urgent` returns true.
  void stop(bool (*urgent)());

 private:
  void receive();
  void take_goal(const geometry_msgs_msg_dds__PoseStamped_& message, bool from_action);
  void take_path(const nav_msgs_msg_dds__Path_& message);
  void drop_goal();
  void cancel_goal();
  void place_goal();
  [[nodiscard]] std::string start_goal(const Pose2& frame);
  void follow_piece();
  [[nodiscard]] bool ends_piece(const bridge::PilotStep& step, double now);
  void report_goal(const bridge::PilotStep& step, double now);
  [[nodiscard]] bool is_outside_map() const;
  [[nodiscard]] double remaining_length(const Eigen::Vector2d& position) const;
  void run_cycle(double now);
  void send(const bridge::PilotStep& step);
  void tell_status(const std::string& text);
  void tell_fleet(double now, bool leaving);
  [[nodiscard]] double now() const;
  [[nodiscard]] std::string world_frame() const { return sensors_.world_frame(); }
  [[nodiscard]] std::optional<Pose2> find_frame(const std::string& frame) const {
    return sensors_.find_frame(frame);
  }

  struct WaitingGoal {
    std::string frame;
    Pose2 pose;
    std::vector<Pose2> path{};  // to the pose, if it was given; headings may be not finite
    bool from_action = false;
    double since = 0.0;  // [s]
  };

  NodeOptions options_;
  bridge::Pilot pilot_;
  bridge::CycleClock clock_;
  Participant participant_;
  Reader<nav_msgs_msg_dds__OccupancyGrid_> map_{participant_, "map", kLatched};
  SensorTopics sensors_;
  Reader<geometry_msgs_msg_dds__PoseStamped_> goal_{participant_, "goal_pose", {}};
  Reader<std_msgs_msg_dds__Empty_> cancel_{participant_, "cancel_goal", {}};
  FleetTopic fleet_;
  std::optional<Reader<rosgraph_msgs_msg_dds__Clock_>> simulated_clock_;
  double simulated_time_ = 0.0;                                                  // 0: not known
  std::optional<Writer<geometry_msgs_msg_dds__Twist_>> command_;                 // one of these
  std::optional<Writer<geometry_msgs_msg_dds__TwistStamped_>> stamped_command_;  // two
  std::optional<Writer<std_msgs_msg_dds__Float64_>> steering_;  // of a car or tricycle
  Writer<nav_msgs_msg_dds__Path_> plan_{participant_, "plan", kLatched};
  Writer<visualization_msgs_msg_dds__MarkerArray_> corridor_{participant_, "corridor", kLatched};
  Writer<std_msgs_msg_dds__String_> status_{participant_, "fairway_status", {}};
  Writer<visualization_msgs_msg_dds__MarkerArray_> status_marker_{participant_, "status_marker",
                                                                  kLatched};
  GoalActions actions_;
  std::optional<WaitingGoal> waiting_goal_;
  std::optional<PathDrive> drive_;                           // along the path of an action
  Eigen::Vector2d goal_position_ = Eigen::Vector2d::Zero();  // of the last goal without a path
  bridge::DriveProgress progress_;
  std::string told_;
  bool scan_came_ = false;  // since the last tick
};

}  // namespace fairway::dds
