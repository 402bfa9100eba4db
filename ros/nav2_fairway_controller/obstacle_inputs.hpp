// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <nav2_costmap_2d/costmap_2d_ros.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <sensor_msgs/msg/point_cloud2.hpp>

#include "bridge/sensing/obstacle_board.hpp"
#include "fairway/navigation/facade/mapless_navigator.hpp"
#include "nav2_fairway_controller/nav2_versions.hpp"
#include "nav2_fairway_controller/scan_queue.hpp"

namespace fairway::nav2 {

/// The moving obstacles of two topics, in the costmap's frame. No callback waits for a transform:
/// a scan is kept until it has arrived.
class ObstacleInputs {
 public:
  /// Subscribes; an empty topic means none. @param obstacles_type  `cloud`, `people`,
  /// `costmap_converter` or `objects`.
  /// @throws ControllerSetupError for another type, or one whose messages were not installed when
  /// the plugin was built.
  ObstacleInputs(std::shared_ptr<LifecycleNode> node,
                 TransformBuffer transforms,
                 std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap,
                 const Settings& settings,
                 const std::string& scan_topic,
                 const std::string& obstacles_topic,
                 const std::string& obstacles_type);

  /// Uses other settings. The tracker starts again if those of perception differ.
  void set_settings(const Settings& settings);

  /// The obstacles as known now. Uses the scans whose transforms have arrived.
  [[nodiscard]] bridge::ObstacleBoard collect();

 private:
  void take_scan(const sensor_msgs::msg::LaserScan& message);
  void subscribe_obstacles(const std::string& topic, const std::string& type);
  void take_cloud(const sensor_msgs::msg::PointCloud2& message);
  void take_obstacles(std::vector<MovingObstacle> obstacles,
                      const std::string& frame_id,
                      double time);
  void use_scans();  // with the lock
  [[nodiscard]] bool use_scan(const sensor_msgs::msg::LaserScan& message);
  void warn(const char* reason) const;

  std::shared_ptr<LifecycleNode> node_;
  TransformBuffer transforms_;
  std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_;
  std::mutex mutex_;  // callbacks come from the executor's threads
  Settings settings_;
  ScanQueue<sensor_msgs::msg::LaserScan> queue_;
  std::size_t reported_ = 0;  // dropped scans in the last warning
  bridge::ObstacleBoard board_;
  std::unique_ptr<MaplessNavigator> tracker_;
  std::shared_ptr<void> scans_;      // the subscriptions, whose types differ between
  std::shared_ptr<void> obstacles_;  // distributions; they end before the rest
};

/// The pose of `frame` in the costmap's frame, from the newest transform.
/// @throws ControllerTransformError without one.
[[nodiscard]] Pose2 frame_in_costmap(const tf2_ros::Buffer& transforms,
                                     nav2_costmap_2d::Costmap2DROS& costmap,
                                     const std::string& frame);

}  // namespace fairway::nav2
