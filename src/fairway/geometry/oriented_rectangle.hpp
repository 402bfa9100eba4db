// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <Eigen/Core>

namespace fairway {

/// An oriented rectangle, as a closed set: its sides and corners belong to it.
///
/// Its own frame H has its origin at `seed` and is rotated by `orientation` relative to the world.
/// In H the rectangle is {p : min <= p <= max}, Eq. (9) with Delta_s = 0. Degenerate rectangles (a
/// segment, a point) are allowed. The rectangle is empty if min exceeds max in either coordinate.
struct OrientedRectangle {
  Eigen::Vector2d seed = Eigen::Vector2d::Zero();  ///< where it was grown from, world frame [m]
  double orientation = 0.0;                        ///< rotation of H relative to the world [rad]
  Eigen::Vector2d min = Eigen::Vector2d::Zero();   ///< lower-left corner in H [m]
  Eigen::Vector2d max = Eigen::Vector2d::Zero();   ///< upper-right corner in H [m]

  /// Returns whether the rectangle contains no point; true for a rectangle with NaN.
  [[nodiscard]] bool is_empty() const noexcept {
    return !(min.x() <= max.x() && min.y() <= max.y());
  }

  /// Area [m^2]; 0 for an empty rectangle.
  [[nodiscard]] double area() const noexcept {
    return is_empty() ? 0.0 : (max.x() - min.x()) * (max.y() - min.y());
  }

  /// Transforms a world point to H, Eq. (8).
  [[nodiscard]] Eigen::Vector2d to_local(const Eigen::Vector2d& point) const noexcept;

  /// Transforms a point in H to the world: the inverse of `to_local`, Eq. (5).
  [[nodiscard]] Eigen::Vector2d to_world(const Eigen::Vector2d& local) const noexcept;

  /// Returns whether `point` lies inside, or beyond a side by at most `tolerance` [m]. A negative
  /// tolerance demands that distance inside every side. The answer is false for an empty rectangle
  /// and for a non-finite point.
  [[nodiscard]] bool contains(const Eigen::Vector2d& point, double tolerance = 0.0) const noexcept;

  /// Centre in the world [m].
  [[nodiscard]] Eigen::Vector2d center() const noexcept { return to_world(0.5 * (min + max)); }

  /// Corners in the world [m], counter-clockwise, starting at `min`.
  [[nodiscard]] std::array<Eigen::Vector2d, 4> corners() const noexcept;

  /// Returns the rectangle with every side moved inward by `offset` [m], Eq. (10). The result is
  /// empty if the rectangle is narrower than 2 * offset. Seed and orientation stay; a negative
  /// offset grows the rectangle.
  [[nodiscard]] OrientedRectangle shrunk(double offset) const noexcept;

  /// Returns the point of the rectangle that is nearest to `point`. @pre not empty.
  [[nodiscard]] Eigen::Vector2d nearest(const Eigen::Vector2d& point) const noexcept;
};

/// Returns the smallest rectangle that contains the segment from `a` to `b`: the segment, with seed
/// `a`.
[[nodiscard]] OrientedRectangle segment_rectangle(const Eigen::Vector2d& a,
                                                  const Eigen::Vector2d& b) noexcept;

/// The intersection of two rectangles: a convex polygon with at most 8 corners.
struct OverlapPatch {
  std::array<Eigen::Vector2d, 8> corners;  ///< counter-clockwise; the first `count` are used
  int count = 0;                           ///< 0 if the rectangles do not intersect

  /// Area of the polygon [m^2]; 0 if the rectangles do not intersect.
  [[nodiscard]] double area() const noexcept;

  /// Centroid of the polygon, or mean of its corners if the area is 0. @pre count > 0.
  [[nodiscard]] Eigen::Vector2d centroid() const noexcept;
};

/// Computes the intersection of two rectangles, by the Sutherland-Hodgman algorithm.
[[nodiscard]] OverlapPatch overlap(const OrientedRectangle& a, const OrientedRectangle& b) noexcept;

}  // namespace fairway
