// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <Eigen/Core>

#include "fairway/map/occupancy_grid.hpp"
#include "fairway/perception/lidar_scan.hpp"
#include "fairway/perception/perception_settings.hpp"

namespace fairway {

/// The pose of a robot in a map, as estimated from odometry and scans.
struct MapPose {
  Pose2 pose;
  /// Covariance of (x, y) [m^2], the heading [rad^2] and both, in the frame of the map.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  bool matched = false;  ///< whether the last scan fitted the map; if not, odometry alone was used
  double share = 0.0;    ///< part of the last scan that lies on surfaces of the map []
  /// Whether the last scan says nothing about the position in one direction, as in a long corridor.
  bool degenerate = false;
  Eigen::Vector2d weak_direction = Eigen::Vector2d::Zero();  ///< that direction
};

/// Tracks the pose of a robot in a known map from odometry and lidar scans, for robots without
/// another localisation.
///
/// It follows a pose that is known at the start to about 0.1 m and 0.05 rad; it finds no robot that
/// is lost. Hits on things that are not in the map count little. Allocates in the constructor only,
/// about 5 kB per square metre of the map. Deterministic.
class MapLocalization {
 public:
  /// @param map       The walls that a lidar sees; unknown cells have no surfaces.
  /// @param settings  `reach` and `max_beams` are used.
  explicit MapLocalization(const OccupancyGrid& map, const PerceptionSettings& settings = {});
  MapLocalization(MapLocalization&&) noexcept;
  MapLocalization& operator=(MapLocalization&&) noexcept;
  ~MapLocalization();

  /// Sets the robot's pose in the map, for a pose by odometry, and its standard deviations.
  void set_pose(const Pose2& odometry,
                const Pose2& pose,
                double position_sigma = 0.05,
                double heading_sigma = 0.02) noexcept;

  /// Matches a scan whose poses are by odometry.
  /// @return whether the scan is plausible; if not, nothing changes.
  bool observe(const LidarScan& scan) noexcept;

  /// Returns the pose in the map for a pose by odometry.
  [[nodiscard]] MapPose locate(const Pose2& odometry) const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace fairway
