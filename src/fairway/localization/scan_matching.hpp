// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include <Eigen/Core>

#include "fairway/localization/surface_points.hpp"

namespace fairway {

/// A small motion of a scan about a centre. It shifts by (x, y) [m], and turns by the third number
/// [rad].
using ScanMotion = Eigen::Vector3d;

/// Moves a point by `motion` about `center`.
[[nodiscard]] Eigen::Vector2d moved(const Eigen::Vector2d& point,
                                    const Eigen::Vector2d& center,
                                    const ScanMotion& motion) noexcept;

/// Moves many points by the same motion about the same centre.
class MotionAbout {
 public:
  MotionAbout(const Eigen::Vector2d& center, const ScanMotion& motion) noexcept;
  [[nodiscard]] Eigen::Vector2d operator()(const Eigen::Vector2d& point) const noexcept {
    return moved_center_ + turned(point - center_);
  }
  /// Turns a vector that has no place, such as a normal.
  [[nodiscard]] Eigen::Vector2d turned(const Eigen::Vector2d& v) const noexcept {
    return {turn_.x() * v.x() - turn_.y() * v.y(), turn_.y() * v.x() + turn_.x() * v.y()};
  }
  [[nodiscard]] const Eigen::Vector2d& moved_center() const noexcept { return moved_center_; }

 private:
  Eigen::Vector2d center_;
  Eigen::Vector2d moved_center_;
  Eigen::Vector2d turn_;
};

/// The distance of a moved point from a line, and its derivative by the motion.
struct LineResidual {
  double value = 0.0;                                        ///< [m]
  Eigen::RowVector3d jacobian = Eigen::RowVector3d::Zero();  ///< exact
};

/// Returns n . (p - q) for a moved point p and the line through q with normal n.
/// @param position  The moved point p.
/// @param arm       From the moved centre of the motion to p.
[[nodiscard]] LineResidual line_residual(const Eigen::Vector2d& position,
                                         const Eigen::Vector2d& arm,
                                         const SurfacePoint& line) noexcept;

/// The motion that moves a scan onto a map, and its certainty.
struct ScanMatch {
  ScanMotion motion = ScanMotion::Zero();
  /// Information of the points about the motion, without that of the prior.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  int used = 0;            ///< number of points of the scan that were tried
  int matched = 0;         ///< number of points that lie on the map's surfaces
  double deviation = 0.0;  ///< root mean square distance of the matched points [m]
};

/// Finds the motion about `center` that moves the points of a scan onto the surfaces of a map.
///
/// The method is Gauss-Newton on the weighted distances from the lines through the nearest points.
/// The weights are Cauchy weights whose scale becomes smaller, and there is a prior of mean zero.
/// The normal of a line is the mean of those of both points, or that of the map if it is exact.
/// @param prior  Information about the motion before the match, positive definite.
/// @param start  A motion close to the result, if one is known; it saves steps.
[[nodiscard]] ScanMatch match_scan(const SurfacePoints& map,
                                   std::span<const SurfacePoint> scan,
                                   const Eigen::Vector2d& center,
                                   const Eigen::Matrix3d& prior,
                                   const ScanMotion& start = ScanMotion::Zero()) noexcept;

}  // namespace fairway
