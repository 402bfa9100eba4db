// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/object/moving_track.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace fairway {

using Eigen::Matrix2d;
using Eigen::Matrix4d;
using Eigen::Vector2d;

namespace {

constexpr double kSpeedSigma = 1.5;  // of a velocity of which nothing is known [m/s]

}  // namespace

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

void MovingTrack::resize(double new_radius, const Vector2d& sensor) noexcept {
  const Vector2d shift = (new_radius - radius) * (position() - sensor).normalized();
  state.head<2>() += shift;
  born_at += shift;
  born_radius += new_radius - radius;
  stayed_at += shift;
  counted_at += shift;
  radius = new_radius;
}

bool MovingTrack::is_surprised_by(const Vector2d& center,
                                  const Matrix2d& covariance_of_center) const noexcept {
  constexpr double kSurprise =
      9.2;  // 99 % of a chi-squared distribution with two degrees of freedom
  const Matrix2d innovation = covariance.topLeftCorner<2, 2>() + covariance_of_center;
  const Vector2d off = center - position();
  return off.dot(innovation.inverse() * off) > kSurprise;
}

void MovingTrack::allow_jump(double dt) noexcept {
  constexpr double kLongest = 0.2;  // [s]
  const double t = std::clamp(dt, 0.0, kLongest);
  const double variance = kSpeedSigma * kSpeedSigma;
  covariance.topLeftCorner<2, 2>() += t * t * variance * Matrix2d::Identity();
  covariance.topRightCorner<2, 2>() += t * variance * Matrix2d::Identity();
  covariance.bottomLeftCorner<2, 2>() += t * variance * Matrix2d::Identity();
  covariance.bottomRightCorner<2, 2>() += variance * Matrix2d::Identity();
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
  MovingTrack track;
  track.id = id;
  track.state.head<2>() = center;
  track.covariance.topLeftCorner<2, 2>() *= center_sigma * center_sigma;
  track.covariance.bottomRightCorner<2, 2>() *= kSpeedSigma * kSpeedSigma;
  track.radius = radius;
  track.born_at = center;
  track.stayed_at = center;
  track.stayed_since = time;
  track.born_time = time;
  track.born_radius = radius;
  track.sightings = 1;
  track.last_seen = time;
  return track;
}

}  // namespace fairway
