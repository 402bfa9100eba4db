// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

namespace fairway {

/// A circle fitted to points, and its residual.
struct CircleFit {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0.0;
  double deviation = 0.0;  ///< root mean square distance of the points from the circle [m]
};

/// Fits the circle of least algebraic error (Kasa): minimises sum (|p - c|^2 - r^2)^2, a linear
/// problem. The result is none for fewer than 4 points, or points on a line.
[[nodiscard]] std::optional<CircleFit> fit_circle(std::span<const Eigen::Vector2d> points) noexcept;

/// The centre of a circle of known radius, and its covariance.
struct CenterFit {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();
  double deviation = 0.0;  ///< root mean square distance of the points from the circle [m]
};

/// Fits the centre of a circle of known radius by least squares, sum (|p - c| - radius)^2.
///
/// Gauss-Newton steps start from `guess`. A weak weight on the guess determines what the points do
/// not (the shift along a short arc). The covariance assumes points with standard deviation
/// `point_sigma` [m] and a guess with `guess_sigma` [m].
[[nodiscard]] CenterFit fit_center(std::span<const Eigen::Vector2d> points,
                                   double radius,
                                   const Eigen::Vector2d& guess,
                                   double point_sigma,
                                   double guess_sigma) noexcept;

}  // namespace fairway
