// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace fairway {

/// What is known about one thing that may move: a Kalman filter of constant velocity for its
/// centre, and its size.
///
/// State (x, y, vx, vy); the velocity drifts like white noise in acceleration.
struct MovingTrack {
  int id = 0;  ///< never used twice
  Eigen::Vector4d state = Eigen::Vector4d::Zero();
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Identity();
  double radius = 0.0;         ///< of the disc that it is taken for [m]
  double radius_weight = 0.0;  ///< how much measurement the radius rests on, in scans
  Eigen::Vector2d born_at = Eigen::Vector2d::Zero();  ///< where it was seen first [m]
  int sightings = 0;                                  ///< scans that saw it
  double last_seen = 0.0;                             ///< [s]
  double seen_through = 0.0;  ///< for how long beams have passed where it should be [s]
  double slow_for = 0.0;      ///< for how long it has been too slow to count [s]
  bool moving = false;        ///< whether it counts as a moving obstacle

  [[nodiscard]] Eigen::Vector2d position() const noexcept { return state.head<2>(); }
  [[nodiscard]] Eigen::Vector2d velocity() const noexcept { return state.tail<2>(); }

  /// Standard deviation of the position, in its worst direction bounded by the trace [m].
  [[nodiscard]] double position_sigma() const noexcept;
  [[nodiscard]] double velocity_sigma() const noexcept;

  /// Moves the belief on by `dt` [s].
  void predict(double dt, double acceleration_noise) noexcept;

  /// Takes in a measured centre.
  void correct(const Eigen::Vector2d& center, const Eigen::Matrix2d& covariance_of_center) noexcept;
};

/// A track that begins: at rest until seen otherwise.
[[nodiscard]] MovingTrack new_track(int id,
                                    double time,
                                    const Eigen::Vector2d& center,
                                    double center_sigma,
                                    double radius) noexcept;

}  // namespace fairway
