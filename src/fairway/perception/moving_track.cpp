// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/moving_track.hpp"

#include <cmath>

#include <Eigen/LU>

namespace fairway {

using Eigen::Matrix2d;
using Eigen::Matrix4d;
using Eigen::Vector2d;

double MovingTrack::position_sigma() const noexcept {
  return std::sqrt(0.5 * covariance.topLeftCorner<2, 2>().trace());
}

double MovingTrack::velocity_sigma() const noexcept {
  return std::sqrt(0.5 * covariance.bottomRightCorner<2, 2>().trace());
}

void MovingTrack::predict(double dt, double acceleration_noise) noexcept {
  Matrix4d transition = Matrix4d::Identity();
  transition.topRightCorner<2, 2>() = dt * Matrix2d::Identity();
  state = transition * state;
  // White noise in acceleration with density q: q [dt^3/3, dt^2/2; dt^2/2, dt] per axis.
  const double q = acceleration_noise * acceleration_noise;
  Matrix4d noise = Matrix4d::Zero();
  noise.topLeftCorner<2, 2>() = q * dt * dt * dt / 3.0 * Matrix2d::Identity();
  noise.topRightCorner<2, 2>() = q * dt * dt / 2.0 * Matrix2d::Identity();
  noise.bottomLeftCorner<2, 2>() = q * dt * dt / 2.0 * Matrix2d::Identity();
  noise.bottomRightCorner<2, 2>() = q * dt * Matrix2d::Identity();
  covariance = (transition * covariance * transition.transpose() + noise).eval();
}

void MovingTrack::correct(const Vector2d& center, const Matrix2d& covariance_of_center) noexcept {
  const Matrix2d innovation = covariance.topLeftCorner<2, 2>() + covariance_of_center;
  const Eigen::Matrix<double, 4, 2> gain = covariance.leftCols<2>() * innovation.inverse();
  state += gain * (center - position());
  // Joseph's form keeps the covariance symmetric and positive.
  Matrix4d keep = Matrix4d::Identity();
  keep.leftCols<2>() -= gain;
  covariance =
      (keep * covariance * keep.transpose() + gain * covariance_of_center * gain.transpose())
          .eval();
}

MovingTrack new_track(
    int id, double time, const Vector2d& center, double center_sigma, double radius) noexcept {
  constexpr double kFirstSpeedSigma = 1.5;  // [m/s]
  MovingTrack track;
  track.id = id;
  track.state.head<2>() = center;
  track.covariance.topLeftCorner<2, 2>() *= center_sigma * center_sigma;
  track.covariance.bottomRightCorner<2, 2>() *= kFirstSpeedSigma * kFirstSpeedSigma;
  track.radius = radius;
  track.born_at = center;
  track.born_time = time;
  track.sightings = 1;
  track.last_seen = time;
  return track;
}

}  // namespace fairway
