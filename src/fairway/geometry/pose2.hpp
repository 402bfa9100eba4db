// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <Eigen/Core>

namespace fairway {

/// Position [m] and heading [rad], in the world frame unless the name says otherwise.
struct Pose2 {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  double heading = 0.0;
};

/// Linear speed along the heading [m/s] and angular speed, positive counter-clockwise [rad/s].
struct Twist2 {
  double linear = 0.0;
  double angular = 0.0;
};

/// Returns whether every number is finite.
[[nodiscard]] inline bool is_finite(const Eigen::Vector2d& point) noexcept {
  return std::isfinite(point.x()) && std::isfinite(point.y());
}

[[nodiscard]] inline bool is_finite(const Pose2& pose) noexcept {
  return is_finite(pose.position) && std::isfinite(pose.heading);
}

[[nodiscard]] inline bool is_finite(const Twist2& twist) noexcept {
  return std::isfinite(twist.linear) && std::isfinite(twist.angular);
}

/// Returns whether a position is plausible: finite, and so near to the origin that a double
/// resolves nanometres. Arithmetic on other positions overflows in the indices of a grid.
[[nodiscard]] inline bool is_plausible(const Eigen::Vector2d& point) noexcept {
  constexpr double kFurthest = 1e7;  // [m]
  return std::abs(point.x()) <= kFurthest && std::abs(point.y()) <= kFurthest;
}

/// Returns whether a pose is plausible. Its heading must not be more turns than a robot makes in a
/// drive, as headings in degrees are.
[[nodiscard]] inline bool is_plausible(const Pose2& pose) noexcept {
  constexpr double kMostHeading = 64.0;  // [rad]
  return is_plausible(pose.position) && std::abs(pose.heading) <= kMostHeading;
}

/// Unit vector in direction `heading`.
[[nodiscard]] inline Eigen::Vector2d direction(double heading) noexcept {
  return {std::cos(heading), std::sin(heading)};
}

/// Returns `vector` rotated counter-clockwise by `angle` [rad].
[[nodiscard]] inline Eigen::Vector2d rotated(const Eigen::Vector2d& vector, double angle) noexcept {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * vector.x() - s * vector.y(), s * vector.x() + c * vector.y()};
}

/// Transforms a point from the coordinates of `frame` to those that `frame` is given in.
[[nodiscard]] inline Eigen::Vector2d transform(const Pose2& frame,
                                               const Eigen::Vector2d& local) noexcept {
  return frame.position + rotated(local, frame.heading);
}

/// Transforms a point into the coordinates of `frame`: the inverse of `transform`.
[[nodiscard]] inline Eigen::Vector2d inverse_transform(const Pose2& frame,
                                                       const Eigen::Vector2d& point) noexcept {
  return rotated(point - frame.position, -frame.heading);
}

}  // namespace fairway
