// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "bridge/fleet_board.hpp"
#include "bridge/sensing/obstacle_board.hpp"
#include "bridge/sensing/pose_history.hpp"
#include "fairway/geometry/robot_model.hpp"
#include "fairway/navigation/navigation_step.hpp"
#include "fairway/perception/lidar_scan.hpp"

namespace fairway::bridge {

/// What is fixed about the sensors of a robot.
struct SensesOptions {
  bool use_map = true;                ///< the world frame is the map's, else the odometry's
  bool use_scan = true;               ///< scans are needed, and their age is checked
  double localisation_timeout = 2.0;  ///< largest age of the odometry frame's pose in the map [s]
  std::uint32_t robot = 0;            ///< number in the fleet, by which ties are decided
};

/// A scan with the poses of its sensor in both frames.
struct PlacedScan {
  LidarScan in_odometry;
  LidarScan in_world;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< of the robot at its last beam
};

/// What one robot has measured, in one frame: odometry, localisation, scans, detections, and the
/// other robots of its fleet. It makes the measurements of a control cycle from them.
class RobotSenses {
 public:
  explicit RobotSenses(const SensesOptions& options) : options_(options) {}

  void add_odometry(double time, const Pose2& pose, const PlanarTwist& twist);
  void set_localisation(const Pose2& odometry_in_map, double time);

  /// Computes the poses of the sensor at the first beam and the last; none unless they are known.
  /// The ranges still belong to the message. @param duration  between these beams [s].
  [[nodiscard]] std::optional<PlacedScan> place(const LidarScan& scan,
                                                double duration,
                                                const Pose2& sensor_on_robot) const;

  /// Notes that a scan was used: the age of scans is checked from now on.
  void note_scan() noexcept { scanned_ = true; }

  [[nodiscard]] ObstacleBoard& board() noexcept { return board_; }
  [[nodiscard]] FleetBoard& fleet() noexcept { return fleet_; }

  /// The measurements of a cycle at `time`, valid until the next call.
  [[nodiscard]] Measurements measure(double time);

  /// The robot's pose in the world by the newest odometry; none before odometry, or localisation,
  /// is known.
  [[nodiscard]] std::optional<Pose2> pose() const;

  [[nodiscard]] const PoseHistory& odometry() const noexcept { return odometry_; }
  [[nodiscard]] const PlanarTwist& twist() const noexcept { return twist_; }

  /// Whether the localisation is older than its timeout.
  [[nodiscard]] bool is_lost(double time) const noexcept {
    return options_.use_map && time - localisation_time_ > options_.localisation_timeout;
  }

 private:
  [[nodiscard]] Pose2 in_world(const Pose2& pose) const;

  SensesOptions options_;
  PoseHistory odometry_;
  PlanarTwist twist_{};  // by the newest odometry
  std::optional<Pose2> localisation_;
  double localisation_time_ = 0.0;
  ObstacleBoard board_;
  FleetBoard fleet_;
  SeenObstacles seen_;  // from detectors, in this cycle
  bool scanned_ = false;
};

}  // namespace fairway::bridge
