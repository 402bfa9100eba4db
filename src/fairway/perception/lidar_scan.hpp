// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fairway/geometry/pose2.hpp"

namespace fairway {

/// One turn of a planar lidar: what ROS calls a LaserScan, with the poses it was taken from.
struct LidarScan {
  double time = 0.0;         ///< when the last beam was measured [s]
  Pose2 first_pose;          ///< of the sensor at the first beam, in the frame of the grid
  Pose2 last_pose;           ///< of the sensor at the last beam
  double first_angle = 0.0;  ///< of beam 0 against the sensor's heading [rad]
  double angle_step = 0.0;   ///< from beam to beam [rad]
  double min_range = 0.0;    ///< nearer returns are none [m]
  double max_range = 30.0;   ///< furthest that is seen [m]
  /// Distance per beam [m]; at least `max_range` or infinite: nothing stands there up to max_range;
  /// NaN or below `min_range`: the beam says nothing.
  std::span<const float> ranges;
};

/// What a beam tells about where it ends.
enum class BeamEnd : std::uint8_t {
  Hit,      ///< something is there
  Open,     ///< nothing up to there
  Nothing,  ///< the beam was lost
};

/// A beam in the frame of the grid.
struct Beam {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();  ///< where the sensor was [m]
  Eigen::Vector2d to = Eigen::Vector2d::Zero();    ///< where the beam ended [m]
  BeamEnd end = BeamEnd::Nothing;
  bool moving = false;  ///< hit something that moves
};

/// Lays the beams of a scan into the frame of the grid.
///
/// Motion-compensated: the sensor is taken to move evenly from `first_pose` to `last_pose`. Beams
/// longer than `reach` [m] are cut there and are Open.
/// @param beams  Filled with one beam per range; keeps its memory.
void lay_beams(const LidarScan& scan, double reach, std::vector<Beam>& beams);

}  // namespace fairway
