// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/OccupancyGrid.h>

#include "bridge/cycle_clock.hpp"
#include "bridge/pilot.hpp"
#include "fairway_ros/goal_server.hpp"
#include "fairway_ros/node_outputs.hpp"
#include "fairway_ros/sensor_topics.hpp"
#include "fairway_ros/setting_parameters.hpp"

namespace fairway::ros1 {

/// Navigation of one robot as a ROS 1 node: converts messages and passes them to a Pilot. All
/// callbacks run in the thread that calls `tick`.
class NavigationNode {
 public:
  NavigationNode(const Settings& settings, const NodeOptions& options);

  /// Runs a control cycle if one is due.
  void tick();

  /// Brakes, sends zero commands, and returns after the robot was commanded to stop; at once when
  /// urged.
  void stop();

 private:
  void on_map(const nav_msgs::OccupancyGrid::ConstPtr& message);
  [[nodiscard]] std::string on_goal(const geometry_msgs::PoseStamped& message);
  void run_cycle(double now);

  NodeOptions options_;
  bridge::Pilot pilot_;
  ros::NodeHandle node_;
  ros::NodeHandle own_{"~"};
  NodeOutputs outputs_;
  SettingParameters parameters_;
  GoalServer goals_;
  SensorTopics sensors_;
  ros::Subscriber map_;
  std::optional<ScanTimes> new_scan_;  // no command has used it yet
  bool scan_came_ = false;             // since the last tick
  bridge::CycleClock clock_;
  double last_diagnostics_ = 0.0;
};

}  // namespace fairway::ros1
