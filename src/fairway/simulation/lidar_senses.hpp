// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <optional>

#include "fairway/perception/lidar_scan.hpp"
#include "fairway/perception/map_localization.hpp"
#include "fairway/simulation/scenario.hpp"
#include "fairway/simulation/world.hpp"

namespace fairway {

/// The lidar and the odometry of one robot in a world. They measure at their times, and a
/// measurement becomes available after the latency.
class LidarSenses {
 public:
  LidarSenses(const SensingModel& model, const World& world, std::size_t robot, std::uint64_t seed);

  /// When the next scan is due [s].
  [[nodiscard]] double next_scan() const noexcept { return next_scan_; }

  /// Measures the world now: updates the odometry, and takes a scan if one is due.
  void measure(const World& world);

  /// The robot's current pose by odometry.
  [[nodiscard]] const Pose2& pose() const noexcept { return odometry_.pose(); }

  /// Passes on the scans that became available since the last call, oldest first. Calls `take(scan,
  /// position)` for each, with the position at which it was taken.
  template <typename Take>
  void deliver(double time, Take&& take) {
    while (!pending_.empty() && pending_.front().known <= time + 1e-9) {
      const Pending& scan = pending_.front();
      take(LidarScan{.time = scan.taken,
                     .first_pose = scan.sensor,
                     .last_pose = scan.sensor,
                     .first_angle = -0.5 * model_.lidar.field_of_view,
                     .angle_step = model_.lidar.field_of_view / (model_.lidar.beams - 1),
                     .min_range = model_.lidar.min_range,
                     .max_range = model_.lidar.max_range,
                     .ranges = scan.ranges},
           scan.robot);
      pending_.pop_front();
    }
  }

 private:
  struct Pending {
    double taken = 0.0;
    double known = 0.0;
    Pose2 sensor;  // by odometry
    Eigen::Vector2d robot = Eigen::Vector2d::Zero();
    std::vector<float> ranges;
  };

  SensingModel model_;
  std::size_t robot_;
  Noise noise_;
  Odometry odometry_;
  double next_scan_;
  std::deque<Pending> pending_;
  std::vector<MovingObstacle> around_;
};

/// The pose of a robot that knows the map: the exact one, or the one that MapLocalization finds
/// from odometry and scans.
class MeasuredPose {
 public:
  /// @param scenario  Its map and models of sensors are used.
  MeasuredPose(const Scenario& scenario, const World& world, std::size_t robot);

  [[nodiscard]] bool by_scans() const noexcept { return senses_.has_value(); }

  /// When `measure` is due next [s]; infinite for never.
  [[nodiscard]] double next_measurement() const noexcept;

  /// Updates the odometry, and takes a scan if one is due.
  void measure(const World& world);

  /// Matches the scans that have become available. Call it once per cycle.
  void locate(double time);

  /// The robot's pose now.
  [[nodiscard]] Pose2 pose(const World& world) const noexcept;

 private:
  std::size_t robot_;
  std::optional<LidarSenses> senses_;  // none: the pose is exact
  std::optional<MapLocalization> localization_;
};

}  // namespace fairway
