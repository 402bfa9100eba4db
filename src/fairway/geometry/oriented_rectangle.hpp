// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <Eigen/Core>

namespace fairway {

/// A turned rectangle, as a closed set: its sides and corners belong to it.
///
/// Its own frame H has its origin at `seed` and is turned by `orientation` against the world; in H
/// it is {p : min <= p <= max}, Eq. (9) with Delta_s = 0. Degenerate rectangles (a segment, a
/// point) are allowed; the rectangle is empty when min exceeds max in either coordinate.
struct OrientedRectangle {
  Eigen::Vector2d seed = Eigen::Vector2d::Zero();  ///< where it was grown from, world frame [m]
  double orientation = 0.0;                        ///< turn of H against the world [rad]
  Eigen::Vector2d min = Eigen::Vector2d::Zero();   ///< lower-left corner in H [m]
  Eigen::Vector2d max = Eigen::Vector2d::Zero();   ///< upper-right corner in H [m]

  [[nodiscard]] bool is_empty() const noexcept {
    return !(min.x() <= max.x() && min.y() <= max.y());
  }

  /// Area [m^2]; 0 when empty.
  [[nodiscard]] double area() const noexcept {
    return is_empty() ? 0.0 : (max.x() - min.x()) * (max.y() - min.y());
  }

  /// The world point in H, Eq. (8).
  [[nodiscard]] Eigen::Vector2d to_local(const Eigen::Vector2d& point) const noexcept;

  /// Inverse of `to_local`, Eq. (5).
  [[nodiscard]] Eigen::Vector2d to_world(const Eigen::Vector2d& local) const noexcept;

  /// Whether `point` lies in it or at most `tolerance` [m] beyond each side (negative: inside by as
  /// much). Always false for an empty rectangle or a non-finite point.
  [[nodiscard]] bool contains(const Eigen::Vector2d& point, double tolerance = 0.0) const noexcept;

  [[nodiscard]] Eigen::Vector2d center() const noexcept { return to_world(0.5 * (min + max)); }

  /// Corners counter-clockwise in the world, from `min`.
  [[nodiscard]] std::array<Eigen::Vector2d, 4> corners() const noexcept;

  /// Every side moved inward by `offset` [m], Eq. (10); empty when it is narrower than 2 * offset.
  /// Keeps seed and orientation; a negative offset grows it.
  [[nodiscard]] OrientedRectangle shrunk(double offset) const noexcept;

  /// The point of the rectangle nearest to `point`. @pre not empty.
  [[nodiscard]] Eigen::Vector2d nearest(const Eigen::Vector2d& point) const noexcept;
};

/// Smallest rectangle that holds the segment from `a` to `b`: the segment itself, seed at `a`.
[[nodiscard]] OrientedRectangle segment_rectangle(const Eigen::Vector2d& a,
                                                  const Eigen::Vector2d& b) noexcept;

/// The intersection of two rectangles: a convex polygon with at most 8 corners.
struct OverlapPatch {
  std::array<Eigen::Vector2d, 8> corners;  ///< counter-clockwise; the first `count` are used
  int count = 0;                           ///< 0 when they do not meet

  [[nodiscard]] double area() const noexcept;

  /// Centroid of the patch; of its corners where the area is 0. @pre count > 0.
  [[nodiscard]] Eigen::Vector2d centroid() const noexcept;
};

[[nodiscard]] OverlapPatch overlap(const OrientedRectangle& a, const OrientedRectangle& b) noexcept;

}  // namespace fairway
