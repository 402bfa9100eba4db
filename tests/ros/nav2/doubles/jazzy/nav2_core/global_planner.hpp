// SPDX-License-Identifier: Apache-2.0
// Not Nav2: the interface of jazzy and kilted, by hand.
#pragma once

#include "ros2_double.hpp"

namespace nav2_core {
class GlobalPlanner {
 public:
  virtual ~GlobalPlanner() = default;
  virtual void configure(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent,
                         std::string name,
                         std::shared_ptr<tf2_ros::Buffer> tf,
                         std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap) = 0;
  virtual void cleanup() = 0;
  virtual void activate() = 0;
  virtual void deactivate() = 0;
  virtual nav_msgs::msg::Path createPlan(const geometry_msgs::msg::PoseStamped& start,
                                         const geometry_msgs::msg::PoseStamped& goal,
                                         std::function<bool()> cancel_checker) = 0;
};
}  // namespace nav2_core
