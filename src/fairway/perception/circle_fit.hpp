// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

namespace fairway {

/// A circle through points, and how far the points are from it.
struct CircleFit {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0.0;
  double deviation = 0.0;  ///< root mean square distance of the points from the circle [m]
};

/// The circle of least algebraic error (Kasa): minimises sum (|p - c|^2 - r^2)^2, a linear problem.
/// None for fewer than 4 points or points on a line.
[[nodiscard]] std::optional<CircleFit> fit_circle(std::span<const Eigen::Vector2d> points) noexcept;

/// The centre of a circle of known radius, and its covariance.
struct CenterFit {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();
  double deviation = 0.0;  ///< as above [m]
};

/// The centre of least squared distance, sum (|p - c| - radius)^2, by Gauss-Newton steps from
/// `guess`; a weak pull to the guess decides what the points leave open (the shift along a short
/// arc). The covariance is that of points with standard deviation `point_sigma` [m] and a guess
/// with `guess_sigma` [m].
[[nodiscard]] CenterFit fit_center(std::span<const Eigen::Vector2d> points,
                                   double radius,
                                   const Eigen::Vector2d& guess,
                                   double point_sigma,
                                   double guess_sigma) noexcept;

}  // namespace fairway
