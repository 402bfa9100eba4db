// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/object/circle_fit.hpp"

#include <cmath>

#include <Eigen/LU>

namespace fairway {

using Eigen::Matrix2d;
using Eigen::Vector2d;

std::optional<CircleFit> fit_circle(std::span<const Vector2d> points) noexcept {
  constexpr std::size_t kLeast = 4;
  constexpr double kFlat = 1e-4;  // ratio of the variances below which the points form a line
  if (points.size() < kLeast) return std::nullopt;
  const auto count = static_cast<double>(points.size());
  Vector2d mean = Vector2d::Zero();
  for (const Vector2d& p : points)
    mean += p / count;
  // Relative to the mean: [Sxx Sxy; Sxy Syy] c = 1/2 [Sxxx + Sxyy; Syyy + Sxxy].
  Matrix2d spread = Matrix2d::Zero();
  Vector2d third = Vector2d::Zero();
  double square = 0.0;
  for (const Vector2d& p : points) {
    const Vector2d d = p - mean;
    spread += d * d.transpose();
    third += d * d.squaredNorm();
    square += d.squaredNorm();
  }
  if (!(spread.determinant() > kFlat * square * square)) return std::nullopt;
  const Vector2d center = 0.5 * spread.inverse() * third;
  CircleFit fit{.center = mean + center,
                .radius = std::sqrt(center.squaredNorm() + square / count),
                .deviation = 0.0};
  for (const Vector2d& p : points) {
    const double off = (p - fit.center).norm() - fit.radius;
    fit.deviation += off * off / count;
  }
  fit.deviation = std::sqrt(fit.deviation);
  return fit;
}

CenterFit fit_center(std::span<const Vector2d> points,
                     double radius,
                     const Vector2d& guess,
                     double point_sigma,
                     double guess_sigma) noexcept {
  constexpr int kSteps = 6;
  const double point_weight = 1.0 / (point_sigma * point_sigma);
  const double guess_weight = 1.0 / (guess_sigma * guess_sigma);
  CenterFit fit{.center = guess, .covariance = {}, .deviation = 0.0};
  Matrix2d information = Matrix2d::Identity() * guess_weight;
  for (int n = 0; n < kSteps; ++n) {
    // The residual |p - c| - r has the gradient -(p - c) / |p - c| by c.
    information = Matrix2d::Identity() * guess_weight;
    Vector2d pull = guess_weight * (guess - fit.center);
    for (const Vector2d& p : points) {
      const Vector2d away = p - fit.center;
      const double distance = away.norm();
      if (distance < 1e-6) continue;
      const Vector2d toward = away / distance;
      information += point_weight * toward * toward.transpose();
      pull += point_weight * (distance - radius) * toward;
    }
    fit.center += information.inverse() * pull;
  }
  fit.covariance = information.inverse();
  double square = 0.0;
  for (const Vector2d& p : points) {
    const double off = (p - fit.center).norm() - radius;
    square += off * off;
  }
  fit.deviation = points.empty() ? 0.0 : std::sqrt(square / static_cast<double>(points.size()));
  return fit;
}

}  // namespace fairway
