// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>

#include <rclcpp/create_publisher.hpp>
#include <rclcpp/rclcpp.hpp>
#include <visualization_msgs/msg/marker_array.hpp>

#include "bridge/plan_markers.hpp"
#include "nav2_fairway_controller/nav2_versions.hpp"
#include "nav2_fairway_controller/path_follower.hpp"

namespace fairway::nav2 {

/// The text above the robot: status, limiting factor, and the progress along the path.
[[nodiscard]] inline std::string display_text(const FollowerStep& step) {
  std::string text = to_text(step.status);
  if (step.limit != LimitingFactor::None) text += std::string(": ") + to_text(step.limit);
  if (step.driven + step.remaining <= 0.0) return text;
  char progress[96];
  std::snprintf(static_cast<char*>(progress), sizeof(progress),
                "\n%.1f m of %.1f m, %.2f m from the path", step.driven,
                step.driven + step.remaining, step.deviation);
  return text + static_cast<const char*>(progress);
}

/// Publishes the corridor and the limiting factor for rviz, on the topic `PLUGIN/markers`.
class PlanDisplay {
 public:
  PlanDisplay(std::shared_ptr<LifecycleNode> node, const std::string& plugin)
      : publisher_(rclcpp::create_publisher<visualization_msgs::msg::MarkerArray>(
            node, plugin + "/markers", rclcpp::QoS(1))) {}

  /// Publishes twice a second, if there is a subscriber. @param header  Of the costmap's frame.
  template <typename Header>
  void show(const FollowerStep& step,
            const Plan& plan,
            const Header& header,
            const std::string& base_frame,
            double time) {
    constexpr double kPeriod = 0.5;  // [s]
    if (std::abs(time - last_) < kPeriod || publisher_->get_subscription_count() == 0) return;
    last_ = time;
    visualization_msgs::msg::MarkerArray markers;
    bridge::add_clearing(header, markers);
    bridge::add_corridor(plan.corridor, step.rectangle, header, markers);
    Header robot = header;
    robot.frame_id = base_frame;
    bridge::add_text(display_text(step), robot, markers);
    publisher_->publish(markers);
  }

 private:
  std::shared_ptr<rclcpp::Publisher<visualization_msgs::msg::MarkerArray>> publisher_;
  double last_ = -1e9;  // [s]
};

}  // namespace fairway::nav2
