// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tf2_ros/transform_listener.h>

#include <functional>
#include <optional>
#include <string>

#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Odometry.h>
#include <ros/node_handle.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>

#include "bridge/sensing/sensor_receiver.hpp"

namespace fairway::ros1 {

/// The frames of a robot, and which of its sensors count.
struct SensorOptions {
  std::string map_frame = "map";
  std::string base_frame = "base_link";
  bool use_map = true;   ///< the world frame is the map's, else the odometry's
  bool use_scan = true;  ///< false: scans are not subscribed
};

/// Times of the newest scan's measurement, its reception, and its command, all on one clock [s].
struct ScanTimes {
  double taken = 0.0;
  double received = 0.0;
};

/// The topics from which a robot's measurements come: `odom`, `scan`, `obstacles` and tf. All
/// callbacks run in the thread that calls ROS's queue.
class SensorTopics {
 public:
  /// @param robot  Must outlive this. @param on_scan  Called for each scan that was used.
  SensorTopics(ros::NodeHandle node,
               const SensorOptions& options,
               bridge::SensorReceiver& robot,
               std::function<void(const ScanTimes&)> on_scan);

  /// Passes on the newest pose of the odometry's frame in the map.
  void update_localisation();

  /// The frame in which the robot drives; empty before the first odometry without a map.
  [[nodiscard]] std::string world_frame() const;

  /// The newest transform between two frames; none, with a warning, where it is not known.
  [[nodiscard]] std::optional<geometry_msgs::TransformStamped> find_transform(
      const std::string& to, const std::string& from) const;

 private:
  void on_odometry(const nav_msgs::Odometry::ConstPtr& message);
  void take_scan(const sensor_msgs::LaserScan::ConstPtr& message);
  void on_obstacles(const sensor_msgs::PointCloud2::ConstPtr& message);

  SensorOptions options_;
  bridge::SensorReceiver& robot_;
  std::function<void(const ScanTimes&)> on_scan_;
  tf2_ros::Buffer transforms_;
  tf2_ros::TransformListener listener_{transforms_};
  ros::Subscriber odometry_;
  ros::Subscriber scan_;
  ros::Subscriber obstacles_;
  std::string odometry_frame_;
};

}  // namespace fairway::ros1
