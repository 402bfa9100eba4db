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

LineResidual line_residual(const Vector2d& point,
                           const Vector2d& center,
                           const SurfacePoint& line,
                           const ScanMotion& motion) noexcept {
  const Vector2d arm = rotated(point - center, motion.z());
  const Vector2d off = arm + center + motion.head<2>() - line.position;
  // d/da R(a) v = J R(a) v, where J turns by 90 degrees.
  return {.value = line.normal.dot(off),
          .jacobian = {line.normal.x(), line.normal.y(),
                       line.normal.y() * arm.x() - line.normal.x() * arm.y()}};
}

ScanMatch match_scan(const SurfacePoints& map,
                     std::span<const SurfacePoint> scan,
                     const Vector2d& center,
                     const Matrix3d& prior) noexcept {
  constexpr double kSmallStep = 1e-5;  // [m], [rad]; then the motion has converged
  ScanMatch match;
  const std::size_t stride = std::max<std::size_t>(1, scan.size() / kMostPoints);
  for (std::size_t step = 0; step < kMatchReach.size(); ++step) {
    Matrix3d points = Matrix3d::Zero();
    Vector3d pull = Vector3d::Zero();
    double square = 0.0;
    match.used = 0;
    match.matched = 0;
    for (std::size_t i = 0; i < scan.size(); i += stride) {
      ++match.used;
      const SurfacePoint now{.position = moved(scan[i].position, center, match.motion),
                             .normal = rotated(scan[i].normal, match.motion.z())};
      const SurfacePoint* const near = map.nearest(now, kMatchReach[step]);
      if (near == nullptr) continue;
      const SurfacePoint line{.position = near->position,
                              .normal = (near->normal + now.normal).normalized()};
      const LineResidual residual = line_residual(scan[i].position, center, line, match.motion);
      const double share = residual.value / kScale[step];
      const double weight = kIndependent / (kSigma * kSigma * (1.0 + share * share));
      points += weight * residual.jacobian.transpose() * residual.jacobian;
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
    if (step >= 2 && change.cwiseAbs().maxCoeff() < kSmallStep) break;
  }
  return match;
}

}  // namespace fairway
