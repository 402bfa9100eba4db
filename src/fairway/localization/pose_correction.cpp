// SPDX-License-Identifier: Apache-2.0
#include "fairway/localization/pose_correction.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "fairway/geometry/angle.hpp"
#include "fairway/localization/shift_search.hpp"

namespace fairway {

namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

// Errors of the odometry, as standard deviations.
constexpr double kPerMetre = 0.03;          // [m/m]
constexpr double kTurnPerMetre = 0.012;     // [rad/m]
constexpr double kPerTurn = 0.02;           // [rad/rad]
constexpr double kPerMeasuredTurn = 0.005;  // [rad/rad], of a gyroscope
constexpr double kLeastShift = 5e-4;        // [m]
constexpr double kLeastTurn = 3e-4;         // [rad]

// Returns the direction in which the points of a match say little about the position, or none. The
// information of a point across its surface is compared with what is left of it along the weakest
// direction, after the turn was estimated from the same points.
bool find_weak_direction(const ScanMatch& match, Vector2d& weak) noexcept {
  constexpr double kWeak = 0.02;  // share of the greatest information
  const Matrix3d& all = match.information;
  if (!(all(2, 2) > 0.0)) return false;
  const Vector2d mixed = all.topRightCorner<2, 1>();
  const Matrix2d left = all.topLeftCorner<2, 2>() - mixed * mixed.transpose() / all(2, 2);
  const Eigen::SelfAdjointEigenSolver<Matrix2d> eigen(left);
  weak = eigen.eigenvectors().col(0);
  return eigen.eigenvalues()[0] < kWeak * eigen.eigenvalues()[1];
}

}  // namespace

PoseCorrection::PoseCorrection(double window, std::size_t max_beams) : surfaces_(window) {
  scan_.reserve(max_beams);
  beams_.reserve(max_beams);
}

void PoseCorrection::use_map(const BitGrid& map) {
  add_surface_of_map(map, surfaces_);
  known_map_ = true;
}

void PoseCorrection::set_pose(const Pose2& odometry,
                              const Pose2& pose,
                              const Matrix3d& covariance) noexcept {
  correction_.heading = wrap_to_pi(pose.heading - odometry.heading);
  correction_.position = pose.position - rotated(odometry.position, correction_.heading);
  certainty_.covariance = covariance;
}

Pose2 PoseCorrection::corrected(const Pose2& odometry) const noexcept {
  return {.position = transform(correction_, odometry.position),
          .heading = wrap_to_pi(odometry.heading + correction_.heading)};
}

void PoseCorrection::use_turn(const Pose2& odometry, double turn) noexcept {
  if (!started_) return;
  const double more = turn - shortest_turn(last_odometry_.heading, odometry.heading);
  const Vector2d center = corrected(odometry).position;
  correction_.position = moved(correction_.position, center, {0.0, 0.0, more});
  correction_.heading = wrap_to_pi(correction_.heading + more);
  turned_ = turn;
}

void PoseCorrection::predict(const Pose2& odometry) noexcept {
  const double driven = (odometry.position - last_odometry_.position).norm();
  const double turned = std::abs(shortest_turn(last_odometry_.heading, odometry.heading));
  const std::optional<double> measured = std::exchange(turned_, std::nullopt);
  last_odometry_ = odometry;
  if (!started_) return;
  driven_ = driven;
  const double shift = kPerMetre * driven + kLeastShift;
  const double turn = measured ? kPerMeasuredTurn * std::abs(*measured) + kLeastTurn
                               : kTurnPerMetre * driven + kPerTurn * turned + kLeastTurn;
  certainty_.covariance.diagonal() += Vector3d(shift * shift, shift * shift, turn * turn);
}

ScanMotion PoseCorrection::match(std::span<const Vector2d> ends, const Pose2& odometry) {
  constexpr int kFewest = 30;          // matched points
  constexpr double kLeastShare = 0.4;  // of the points
  constexpr double kNewPlace = 0.1;    // with fewer points on known surfaces the place is new
  predict(odometry);
  const Vector2d center = corrected(odometry).position;
  surface_of_scan(ends, center, scan_, beams_);
  certainty_.matched = false;
  certainty_.degenerate = false;
  certainty_.share = 0.0;
  started_ = true;
  remembers_ = true;
  if (surfaces_.added() == 0) return ScanMotion::Zero();
  constexpr double kLeastVariance = 1e-8;  // [m^2], [rad^2]
  const Matrix3d covariance = certainty_.covariance + kLeastVariance * Matrix3d::Identity();
  Matrix3d prior = covariance.inverse();
  ScanMatch match = match_scan(surfaces_, scan_, center, prior);
  if (match.used > 0) certainty_.share = static_cast<double>(match.matched) / match.used;
  const bool good = match.matched >= kFewest && certainty_.share >= kLeastShare;
  remembers_ = good || certainty_.share < kNewPlace;
  if (!good) return ScanMotion::Zero();
  Vector2d weak = Vector2d::Zero();
  certainty_.degenerate = find_weak_direction(match, weak);
  if (certainty_.degenerate && known_map_) {
    const std::optional<double> shift = search_along(weak, match, center);
    if (shift) {
      ScanMotion start = match.motion;
      start.head<2>() += *shift * weak;
      prior = (certainty_.covariance + kLeastVariance * Matrix3d::Identity()).inverse();
      match = match_scan(surfaces_, scan_, center, prior, start);
      certainty_.degenerate = find_weak_direction(match, weak);
    }
  }
  if (!certainty_.degenerate) weak_driven_ = 0.0;
  if (certainty_.degenerate) {
    // The position in this direction must not follow the noise of the points.
    constexpr double kFixed = 1e10;  // [1/m^2]
    certainty_.weak_direction = weak;
    prior.topLeftCorner<2, 2>() += kFixed * weak * weak.transpose();
    ScanMotion across_weak = match.motion;
    across_weak.head<2>() -= weak * weak.dot(match.motion.head<2>());
    match = match_scan(surfaces_, scan_, center, prior, across_weak);
    // Neither does it become more certain.
    Matrix3d across = Matrix3d::Identity();
    across.topLeftCorner<2, 2>() -= weak * weak.transpose();
    match.information = (across * match.information * across).eval();
  }
  correct(match, center);
  return match.motion;
}

// Along a corridor the errors of the wheels add up in one direction, unlike the noise of steps. The
// covariance allows for that, and what comes into view is searched as far away as they may reach.
std::optional<double> PoseCorrection::search_along(const Vector2d& weak,
                                                   const ScanMatch& match,
                                                   const Vector2d& center) noexcept {
  constexpr double kNear = 0.1;      // [m]; matching finds nearer surfaces by itself
  constexpr double kFurthest = 2.0;  // [m]
  const double before = kPerMetre * weak_driven_;
  weak_driven_ += driven_;
  const double now = kPerMetre * weak_driven_;
  certainty_.covariance.topLeftCorner<2, 2>() +=
      (now * now - before * before) * weak * weak.transpose();
  const double reach = std::min(kFurthest, kNear + now);
  if (now < kNear) return std::nullopt;
  return find_shift(surfaces_, scan_, center, match.motion, weak, reach);
}

void PoseCorrection::correct(const ScanMatch& match, const Vector2d& center) noexcept {
  constexpr double kLeastVariance = 1e-8;
  certainty_.matched = true;
  correction_.position = moved(correction_.position, center, match.motion);
  correction_.heading = wrap_to_pi(correction_.heading + match.motion.z());
  const Matrix3d prior = (certainty_.covariance + kLeastVariance * Matrix3d::Identity()).inverse();
  certainty_.covariance = (prior + match.information).inverse();
  const MotionAbout move(center, match.motion);
  for (SurfacePoint& point : scan_) {
    point.position = move(point.position);
    point.normal = move.turned(point.normal);
  }
}

}  // namespace fairway
