// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/geometry/pose2.hpp"

namespace fairway {

/// What a base can do, whatever it is told.
struct UnicycleLimits {
  double linear_acceleration = 2.0;   ///< [m/s^2]
  double angular_acceleration = 4.0;  ///< [rad/s^2]
};

/// The plant: a unicycle, Eq. (1), whose twist follows the command no faster than its accelerations
/// allow.
struct UnicycleRobot {
  Pose2 pose;
  Twist2 twist;  ///< actual
  UnicycleLimits limits;

  /// Moves for `dt` [s] under `command`: the twist ramps linearly, the pose follows its mean.
  void advance(const Twist2& command, double dt) noexcept;
};

}  // namespace fairway
