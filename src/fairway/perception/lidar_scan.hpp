// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fairway/geometry/pose2.hpp"

namespace fairway {

/// One revolution of a planar lidar (a LaserScan in ROS), with the poses from which it was taken.
struct LidarScan {
  double time = 0.0;  ///< time of the last beam [s]
  Pose2 first_pose;   ///< of the sensor at the first beam, in the frame of the grid
  Pose2 last_pose;    ///< of the sensor at the last beam
  /// Mean rate of turn since the scan before, from a gyroscope [rad/s]; none without one. It takes
  /// the place of the turn by odometry where scans are matched.
  std::optional<double> yaw_rate{};
  double first_angle = 0.0;  ///< of beam 0, relative to the sensor's heading [rad]
  double angle_step = 0.0;   ///< angle between consecutive beams [rad]
  double min_range = 0.0;    ///< smaller ranges are invalid [m]
  double max_range = 30.0;   ///< greatest range that the sensor measures [m]
  /// Range of each beam [m]. A range of at least `max_range`, or an infinite one, means that the
  /// beam is free up to max_range. NaN, or a range below `min_range`, means that the beam is
  /// invalid.
  std::span<const float> ranges;
};

/// Whether a scan can be one: times, angles, distances and poses are finite and not absurd. Single
/// ranges may be anything; they only lose their beam.
/// @param position  Of the robot that carries the sensor, in the frame of the poses [m].
[[nodiscard]] bool is_plausible(const LidarScan& scan, const Eigen::Vector2d& position) noexcept;

/// What a beam measures at its end.
enum class BeamEnd : std::uint8_t {
  Hit,      ///< there is an obstacle
  Open,     ///< the beam is free up to there
  Nothing,  ///< the beam is invalid
};

/// A beam in the frame of the grid.
struct Beam {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();  ///< position of the sensor [m]
  Eigen::Vector2d to = Eigen::Vector2d::Zero();    ///< end of the beam [m]
  BeamEnd end = BeamEnd::Nothing;
  bool moving = false;  ///< whether the beam hit a moving object
};

/// Transforms the beams of a scan into the frame of the grid.
///
/// The motion of the sensor is compensated: it is assumed to move evenly from `first_pose` to
/// `last_pose`. Beams longer than `reach` [m] are cut there and become Open.
/// @param beams  Filled with one beam per range; keeps its memory.
void lay_beams(const LidarScan& scan, double reach, std::vector<Beam>& beams);

}  // namespace fairway
