// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/perception/map_localization.hpp"
#include "fairway/simulation/lidar_senses.hpp"
#include "fairway/simulation/scenario.hpp"
#include "fairway/simulation/world.hpp"

namespace fairway {

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
