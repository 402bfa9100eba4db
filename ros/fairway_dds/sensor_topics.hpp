// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "bridge/frame_tree.hpp"
#include "bridge/sensing/sensor_receiver.hpp"
#include "fairway_dds/dds_topics.hpp"

namespace fairway::dds {

/// The frames of a robot, and which of its sensors count.
struct SensorOptions {
  std::string map_frame = "map";
  std::string base_frame = "base_link";
  bool use_map = true;   ///< the world frame is the map's, else the odometry's
  bool use_scan = true;  ///< false: scans are ignored
};

/// The topics from which a robot's measurements come: `odom`, `scan`, `obstacles`, `/tf` and
/// `/tf_static`.
class SensorTopics {
 public:
  SensorTopics(Participant& participant, const SensorOptions& options);

  /// Passes on what has arrived. @return whether a scan was used.
  bool take(bridge::SensorReceiver& robot);

  /// The frame in which the robot drives; empty before the first odometry without a map.
  [[nodiscard]] std::string world_frame() const;

  /// The pose of a frame in the world frame, where it is known.
  [[nodiscard]] std::optional<Pose2> find_frame(const std::string& frame) const;

 private:
  void take_transform(const tf2_msgs_msg_dds__TFMessage_& message, bool is_static);
  bool take_scan(const sensor_msgs_msg_dds__LaserScan_& message, bridge::SensorReceiver& robot);
  void take_obstacles(const sensor_msgs_msg_dds__PointCloud2_& message,
                      bridge::SensorReceiver& robot);
  void update_localisation(bridge::SensorReceiver& robot) const;

  SensorOptions options_;
  bridge::FrameTree frames_;
  std::string odometry_frame_;
  Reader<nav_msgs_msg_dds__Odometry_> odometry_;
  Reader<sensor_msgs_msg_dds__LaserScan_> scan_;
  Reader<sensor_msgs_msg_dds__PointCloud2_> obstacles_;
  Reader<tf2_msgs_msg_dds__TFMessage_> transforms_;
  Reader<tf2_msgs_msg_dds__TFMessage_> static_transforms_;
};

}  // namespace fairway::dds
