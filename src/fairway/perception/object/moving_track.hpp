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
  Eigen::Vector2d born_at = Eigen::Vector2d::Zero();     ///< position at the first sighting [m]
  Eigen::Vector2d stayed_at = Eigen::Vector2d::Zero();   ///< centre of the place where it is [m]
  double stayed_since = 0.0;                             ///< time since when it is there [s]
  double born_time = 0.0;                                ///< time of that sighting [s]
  double born_radius = 0.0;                              ///< radius at the first sighting [m]
  Eigen::Vector2d counted_at = Eigen::Vector2d::Zero();  ///< where it began to count as moving [m]
  double counted_since = 0.0;  ///< time since when it counts as moving [s]
  double first_pace = 0.0;     ///< mean speed until then [m/s]
  /// Whether it was there when it came into view, as a post is, and has not moved since.
  bool may_be_post = false;
  bool stood = false;          ///< whether it stood at `born_at` until `born_time`
  int sightings = 0;           ///< number of scans in which it was seen
  double last_seen = 0.0;      ///< time of the last sighting [s]
  double changed_share = 0.0;  ///< part of its hits at which the grid changes, a running mean []
  int moving_scans = 0;        ///< scans in a row in which it seemed to move, before it counts
  double moving_for = 0.0;     ///< time for which it was seen while it counted as moving [s]
  double seen_through = 0.0;   ///< time for which beams have passed through its position [s]
  double slow_for = 0.0;       ///< time for which it has been too slow to count as moving [s]
  bool moving = false;         ///< whether it counts as a moving obstacle

  [[nodiscard]] Eigen::Vector2d position() const noexcept { return state.head<2>(); }
  [[nodiscard]] Eigen::Vector2d velocity() const noexcept { return state.tail<2>(); }

  /// Returns the standard deviation of the position [m], bounded by the trace of its covariance.
  [[nodiscard]] double position_sigma() const noexcept;
  [[nodiscard]] double velocity_sigma() const noexcept;

  /// Predicts the state `dt` [s] ahead.
  void predict(double dt, double acceleration_noise) noexcept;

  /// Changes the radius, and moves the centre along the line of sight so that the side that the
  /// sensor sees stays in its place. This is no motion of the object.
  void resize(double new_radius, const Eigen::Vector2d& sensor) noexcept;

  /// Whether a measured centre is improbable, by a test that 99 % of the centres pass.
  [[nodiscard]] bool is_surprised_by(const Eigen::Vector2d& center,
                                     const Eigen::Matrix2d& covariance_of_center) const noexcept;

  /// Allows for a velocity that jumped to any other, `dt` [s] ago.
  void allow_jump(double dt) noexcept;

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
