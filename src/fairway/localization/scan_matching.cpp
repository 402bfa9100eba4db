// SPDX-License-Identifier: Apache-2.0
#include "fairway/localization/scan_matching.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>

#include "fairway/geometry/pose2.hpp"

namespace fairway {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t kMostPoints = 240;  // of a scan; more add little
constexpr double kSigma = 0.02;           // [m], of a residual
// The errors of neighbouring points are correlated: the points count as fewer.
constexpr double kIndependent = 0.1;  // share
constexpr double kMatched = 0.05;     // [m]; nearer points lie on the surface

// Reach of the nearest point and scale of the weights, step by step [m].
constexpr std::array kMatchReach = {0.15, 0.15, 0.12, 0.1, 0.1, 0.1};
constexpr std::array kScale = {0.10, 0.06, 0.04, 0.03, 0.03, 0.03};

}  // namespace

Vector2d moved(const Vector2d& point, const Vector2d& center, const ScanMotion& motion) noexcept {
  return rotated(point - center, motion.z()) + center + motion.head<2>();
}

MotionAbout::MotionAbout(const Vector2d& center, const ScanMotion& motion) noexcept
    : center_(center),
      moved_center_(center + motion.head<2>()),
      turn_(direction(motion.z())) {}

LineResidual line_residual(const Vector2d& position,
                           const Vector2d& arm,
                           const SurfacePoint& line) noexcept {
  const Vector2d& normal = line.normal;
  // d/da R(a) v = J R(a) v, where J turns by 90 degrees.
  return {.value = normal.dot(position - line.position),
          .jacobian = {normal.x(), normal.y(), normal.y() * arm.x() - normal.x() * arm.y()}};
}

ScanMatch match_scan(const SurfacePoints& map,
                     std::span<const SurfacePoint> scan,
                     const Vector2d& center,
                     const Matrix3d& prior,
                     const ScanMotion& start) noexcept {
  constexpr double kSmallStep = 1e-5;  // [m], [rad]; then the motion has converged
  constexpr std::size_t kFewest = 2;   // steps before the last one
  ScanMatch match;
  match.motion = start;
  const std::size_t stride = std::max<std::size_t>(1, scan.size() / kMostPoints);
  // Nearly converged motions begin with the narrower reach.
  const std::size_t first = start.isZero(0.0) ? 0 : kFewest;
  for (std::size_t step = first; step < kMatchReach.size(); ++step) {
    Matrix3d points = Matrix3d::Zero();
    Vector3d pull = Vector3d::Zero();
    double square = 0.0;
    match.used = 0;
    match.matched = 0;
    const MotionAbout move(center, match.motion);
    const double inverse_scale = 1.0 / kScale[step];
    for (std::size_t i = 0; i < scan.size(); i += stride) {
      ++match.used;
      const Vector2d arm = move.turned(scan[i].position - center);
      const SurfacePoint now{.position = move.moved_center() + arm,
                             .normal = move.turned(scan[i].normal)};
      const SurfacePoint* const near = map.nearest(now, kMatchReach[step]);
      if (near == nullptr) continue;
      // Errors of the normals look like information along a corridor.
      const SurfacePoint line{
          .position = near->position,
          .normal = map.exact_normals() ? near->normal : (near->normal + now.normal).normalized()};
      const LineResidual residual = line_residual(now.position, arm, line);
      const double share = residual.value * inverse_scale;
      const double weight = kIndependent / (kSigma * kSigma * (1.0 + share * share));
      points.noalias() += weight * residual.jacobian.transpose() * residual.jacobian;
      pull -= weight * residual.value * residual.jacobian.transpose();
      if (std::abs(residual.value) > kMatched) continue;
      ++match.matched;
      square += residual.value * residual.value;
    }
    match.information = points;
    match.deviation = match.matched > 0 ? std::sqrt(square / match.matched) : 0.0;
    const Vector3d change = (points + prior).ldlt().solve(Vector3d(pull - prior * match.motion));
    if (!change.allFinite()) return {};
    match.motion += change;
    if (step >= kFewest && change.cwiseAbs().maxCoeff() < kSmallStep) break;
  }
  return match;
}

}  // namespace fairway
