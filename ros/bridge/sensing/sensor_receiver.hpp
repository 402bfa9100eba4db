// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bridge/sensing/obstacle_board.hpp"
#include "fairway/geometry/robot_model.hpp"
#include "fairway/perception/lidar_scan.hpp"

namespace fairway::bridge {

/// Takes what the sensors of one robot measure, from any middleware.
class SensorReceiver {
 public:
  virtual ~SensorReceiver() = default;

  virtual void add_odometry(double time, const Pose2& pose, const PlanarTwist& twist) = 0;

  /// The pose of the odometry's frame in the map at `time`; infinite for a static one.
  virtual void set_localisation(const Pose2& odometry_in_map, double time) = 0;

  /// Adds a scan in the sensor's frame. `scan.time` is the time of the last beam; `scan.first_pose`
  /// and `.last_pose` are computed by the receiver.
  /// @param duration  from the first beam to the last [s].
  /// @return whether the scan was used: the poses at these times are known, and it is plausible.
  virtual bool add_scan(LidarScan scan, double duration, const Pose2& sensor_on_robot) = 0;

  /// Moving obstacles from detectors; positions in the world's frame.
  [[nodiscard]] virtual ObstacleBoard& board() noexcept = 0;
};

}  // namespace fairway::bridge
