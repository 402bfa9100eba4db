// SPDX-License-Identifier: Apache-2.0
// Not Nav2: the interface of humble, by hand.
#pragma once

#include "ros2_double.hpp"

namespace nav2_core {
class Controller {
 public:
  virtual ~Controller() = default;
  virtual void configure(const rclcpp_lifecycle::LifecycleNode::WeakPtr&,
                         std::string name,
                         std::shared_ptr<tf2_ros::Buffer>,
                         std::shared_ptr<nav2_costmap_2d::Costmap2DROS>) = 0;
  virtual void cleanup() = 0;
  virtual void activate() = 0;
  virtual void deactivate() = 0;
  virtual void setPlan(const nav_msgs::msg::Path& path) = 0;
  virtual geometry_msgs::msg::TwistStamped computeVelocityCommands(
      const geometry_msgs::msg::PoseStamped& pose,
      const geometry_msgs::msg::Twist& velocity,
      nav2_core::GoalChecker* goal_checker) = 0;
  virtual void setSpeedLimit(const double& speed_limit, const bool& percentage) = 0;
};
}  // namespace nav2_core
