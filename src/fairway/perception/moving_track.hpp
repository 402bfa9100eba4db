// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace fairway {

/// The estimate of one object that may move: a Kalman filter of constant velocity for its centre,
/// and its size.
///
/// The state is (x, y, vx, vy); the velocity changes by white noise in acceleration.
struct MovingTrack {
  int id = 0;  ///< never used twice
  Eigen::Vector4d state = Eigen::Vector4d::Zero();
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Identity();
  double radius = 0.0;         ///< radius of the disc that represents it [m]
  double radius_weight = 0.0;  ///< number of scans from which the radius was estimated
  Eigen::Vector2d born_at = Eigen::Vector2d::Zero();  ///< position at the first sighting [m]
  double born_time = 0.0;                             ///< time of that sighting [s]
  int sightings = 0;                                  ///< number of scans in which it was seen
  double last_seen = 0.0;                             ///< time of the last sighting [s]
  double seen_through = 0.0;  ///< time for which beams have passed through its position [s]
  double slow_for = 0.0;      ///< time for which it has been too slow to count as moving [s]
  bool moving = false;        ///< whether it counts as a moving obstacle

  [[nodiscard]] Eigen::Vector2d position() const noexcept { return state.head<2>(); }
  [[nodiscard]] Eigen::Vector2d velocity() const noexcept { return state.tail<2>(); }

  /// Returns the standard deviation of the position [m], bounded by the trace of its covariance.
  [[nodiscard]] double position_sigma() const noexcept;
  [[nodiscard]] double velocity_sigma() const noexcept;

  /// Predicts the state `dt` [s] ahead.
  void predict(double dt, double acceleration_noise) noexcept;

  /// Corrects the state by a measured centre.
  void correct(const Eigen::Vector2d& center, const Eigen::Matrix2d& covariance_of_center) noexcept;
};

/// Starts a track, initially at rest.
[[nodiscard]] MovingTrack new_track(int id,
                                    double time,
                                    const Eigen::Vector2d& center,
                                    double center_sigma,
                                    double radius) noexcept;

}  // namespace fairway
