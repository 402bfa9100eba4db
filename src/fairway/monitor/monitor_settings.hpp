// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

#include "fairway/base/error.hpp"

namespace fairway {

using Polygon = std::vector<Eigen::Vector2d>;  ///< simple, in the robot's frame [m]

/// What the monitor knows about the robot, and what it guards.
struct MonitorSettings {
  std::vector<Polygon> footprint{};   ///< the body is their union
  Polygon stop_zone{};                ///< a point in here stops the robot; empty: none
  Polygon slow_zone{};                ///< a point in here slows it down; empty: none
  double slow_speed = 0.3;            ///< greatest linear speed then [m/s], 0.01 to 10
  double linear_acceleration = 1.0;   ///< with which the base changes its speed [m/s^2], 0.2 to 20
  double angular_acceleration = 2.0;  ///< [rad/s^2], 0.2 to 100
  double delay = 0.0;                 ///< until the base follows a command [s], 0 to 1
  double hold = 0.15;                 ///< longest time between two commands [s], 0.01 to 1
  double margin = 0.01;               ///< least distance to a point [m], 0 to 1
  double max_age = 0.5;               ///< oldest points to drive on [s], 0.01 to 10
};

/// Whether all numbers are in their ranges, and all polygons can be one.
[[nodiscard]] Expected<void> validate(const MonitorSettings& settings);

}  // namespace fairway
