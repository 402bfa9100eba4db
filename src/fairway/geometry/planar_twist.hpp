// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "fairway/geometry/pose2.hpp"

namespace fairway {

/// Velocity in the plane, in the frame of the body: along the heading, to the left of it, and
/// angular, counter-clockwise positive.
struct PlanarTwist {
  double linear = 0.0;   ///< along the heading [m/s]
  double lateral = 0.0;  ///< to the left [m/s]; 0 for every base but an omnidirectional one
  double angular = 0.0;  ///< [rad/s]
};

[[nodiscard]] inline bool is_finite(const PlanarTwist& twist) noexcept {
  return std::isfinite(twist.linear) && std::isfinite(twist.lateral) &&
         std::isfinite(twist.angular);
}

[[nodiscard]] inline PlanarTwist operator*(double factor, const PlanarTwist& twist) noexcept {
  return {factor * twist.linear, factor * twist.lateral, factor * twist.angular};
}

/// The pose after `duration` [s] of constant `twist` from `pose`, exact: an arc, a line, or a turn.
/// The heading is not wrapped.
[[nodiscard]] inline Pose2 moved(const Pose2& pose,
                                 const PlanarTwist& twist,
                                 double duration) noexcept {
  const double turn = twist.angular * duration;
  // sin(turn) / turn and (1 - cos(turn)) / turn; below 1e-4 the series is exact to 1e-17.
  const bool small = std::abs(turn) < 1e-4;
  const double a = small ? 1.0 - turn * turn / 6.0 : std::sin(turn) / turn;
  const double b = small ? 0.5 * turn : (1.0 - std::cos(turn)) / turn;
  const Eigen::Vector2d way(duration * (a * twist.linear - b * twist.lateral),
                            duration * (b * twist.linear + a * twist.lateral));
  return {.position = transform(pose, way), .heading = pose.heading + turn};
}

/// The constant twist that leads from `from` to `to` in one second, turning by at most pi: the
/// inverse of `moved`.
[[nodiscard]] PlanarTwist twist_between(const Pose2& from, const Pose2& to) noexcept;

}  // namespace fairway
