// SPDX-License-Identifier: Apache-2.0
// The controller plugin with doubles of the node, tf and the costmap of Nav2's jazzy, and a robot
// in a true world. The costmap's frame "odom" is that of the world.
#pragma once

#include <gtest/gtest.h>

#include "fairway/simulation/world.hpp"
#include "nav2_fairway_controller/controller.hpp"
#include "nav2_fairway_controller/costmap_conversion.hpp"

namespace fairway::nav2 {

/// A goal checker with the tolerances of StoppedGoalChecker.
struct StoppedGoal : nav2_core::GoalChecker {
  bool getTolerances(geometry_msgs::msg::Pose& pose, geometry_msgs::msg::Twist& velocity) override {
    pose.position.x = pose.position.y = 0.15;
    bridge::set_heading(0.2, pose.orientation);
    velocity.linear.x = 0.02;
    return true;
  }
};

inline std_msgs::msg::Header header_at(const std::string& frame, double time) {
  const rclcpp::Time stamp(std::llround(time * 1e9));
  return {.stamp = stamp, .frame_id = frame};
}

struct PluginRig {
  static constexpr double kPeriod = 0.1;  // [s]

  explicit PluginRig(const std::map<std::string, rclcpp::ParameterValue>& parameters = {},
                     const Eigen::Vector2d& start = {1.0, 3.0})
      : world(hall(start)) {
    node->declare_parameter("controller_frequency", rclcpp::ParameterValue(1.0 / kPeriod));
    auto& given = node->get_node_parameters_interface()->overrides;
    given = parameters;
    given.emplace("FollowPath.robot.linear_max", rclcpp::ParameterValue(0.5));
    set_frame("map", {});
    set_frame("base_scan", {});
    nav2_costmap_2d::Costmap2D& costmap = *ros->getCostmap();
    costmap.width = 240;
    costmap.height = 120;
    for (int y = 0; y < 120; ++y) {
      for (int x = 0; x < 240; ++x)
        costmap.cells.push_back(world.obstacles().blocked({.x = x, .y = y}) ? 254 : 0);
    }
    update_clock();
  }

  static Scenario hall(const Eigen::Vector2d& start) {
    Scenario scenario;
    scenario.map = OccupancyGrid({.width = 240, .height = 120, .resolution = 0.05, .origin = {}});
    scenario.robots = {{.name = "robot", .start = {.position = start, .heading = 0.0}, .goal = {}}};
    return scenario;
  }

  void configure() { plugin->configure(node, "FollowPath", transforms, ros); }

  void set_frame(const std::string& frame, const Pose2& pose) {
    bridge::set_transform(pose, transforms->transforms[{"odom", frame}].transform);
  }

  void set_path(const std::vector<Eigen::Vector2d>& corners) {
    nav_msgs::msg::Path path;
    path.header = header_at("map", now());
    fill_path({.waypoints = corners}, {}, 0.05, path);
    plugin->setPlan(path);
  }

  double now() const { return 100.0 + world.time(); }
  void update_clock() const { node->set_time(now()); }
  const UnicycleRobot& robot() const { return world.robots()[0]; }

  /// One cycle of the server. An exception stops the robot, as in the server.
  Twist2 step() {
    update_clock();
    geometry_msgs::msg::PoseStamped pose;
    pose.header = header_at("odom", now());
    bridge::set_pose(robot().pose, pose.pose);
    geometry_msgs::msg::Twist twist;
    bridge::set_twist(robot().twist, twist);
    Twist2 command;
    try {
      command = bridge::to_twist(plugin->computeVelocityCommands(pose, twist, &checker).twist);
    } catch (const nav2_core::ControllerException& error) {
      fault = error.what();
      ++faults;
    }
    world.advance({command}, kPeriod);
    return command;
  }

  /// Drives until the checker would accept the goal. Returns whether it did.
  bool drive_to(const Eigen::Vector2d& goal, double seconds) {
    for (const double until = world.time() + seconds; world.time() < until;) {
      step();
      const bool stopped = std::abs(robot().twist.linear) < 0.02;
      if (stopped && (robot().pose.position - goal).norm() < 0.15) return true;
    }
    return false;
  }

  World world;
  std::shared_ptr<rclcpp_lifecycle::LifecycleNode> node =
      std::make_shared<rclcpp_lifecycle::LifecycleNode>();
  std::shared_ptr<tf2_ros::Buffer> transforms = std::make_shared<tf2_ros::Buffer>();
  std::shared_ptr<nav2_costmap_2d::Costmap2DROS> ros =
      std::make_shared<nav2_costmap_2d::Costmap2DROS>();
  std::unique_ptr<FairwayController> plugin = std::make_unique<FairwayController>();
  StoppedGoal checker;
  std::string fault;
  int faults = 0;
};

}  // namespace fairway::nav2
