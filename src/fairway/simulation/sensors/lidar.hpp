// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <span>
#include <vector>

#include "fairway/map/bit_grid.hpp"
#include "fairway/prediction/moving_obstacle.hpp"
#include "fairway/simulation/sensors/noise.hpp"

namespace fairway {

/// A mounted planar lidar. The defaults are BARN's sensor, without errors.
struct LidarModel {
  double field_of_view = 1.5 * std::numbers::pi;  ///< symmetric about the robot's heading [rad]
  int beams = 720;                                ///< at least 2
  double min_range = 0.1;                         ///< [m]
  double max_range = 30.0;                        ///< [m]
  Eigen::Vector2d mount{-0.065, 0.0};             ///< of the sensor, in the robot's frame [m]
  double rate = 20.0;                             ///< scans per second [1/s]
  double latency = 0.0;                           ///< from the scan to its availability [s]
  double range_sigma = 0.0;                       ///< standard deviation of the normal error of
                                                  ///< each range [m]
  double dropout = 0.0;                           ///< share of beams that are lost []
};

/// Returns the exact distance from `from` in direction `angle` to the first obstacle, at most
/// `max_range`. Obstacles are blocked cells, the grid's border and discs. It is 0 from inside an
/// obstacle.
[[nodiscard]] double cast_ray(const BitGrid& obstacles,
                              MovingObstacles discs,
                              const Eigen::Vector2d& from,
                              double angle,
                              double max_range);

/// Takes one scan from `sensor`, all beams at once: beam 0 points field_of_view / 2 to the right.
/// Lost beams are NaN, beams without a hit infinite.
/// @param ranges  Filled with one range per beam; keeps its memory.
void scan_surroundings(const LidarModel& lidar,
                       const BitGrid& obstacles,
                       MovingObstacles discs,
                       const Pose2& sensor,
                       Noise& noise,
                       std::vector<float>& ranges);

}  // namespace fairway
