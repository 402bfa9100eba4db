// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "fairway/geometry/oriented_rectangle.hpp"

namespace fairway {

/// An axis-parallel box in the world, for quick tests.
struct Extent {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1e300);
  Eigen::Vector2d high = Eigen::Vector2d::Constant(-1e300);

  void include(const Eigen::Vector2d& point) noexcept {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  /// Returns whether the two come within `distance` [m] of each other along both axes.
  [[nodiscard]] bool near(const Extent& other, double distance) const noexcept {
    return other.low.x() <= high.x() + distance && other.high.x() >= low.x() - distance &&
           other.low.y() <= high.y() + distance && other.high.y() >= low.y() - distance;
  }
};

/// Returns the extent of a rectangle's corners.
[[nodiscard]] Extent extent_of(const OrientedRectangle& rectangle) noexcept;

/// A straight piece of a boundary, in the world [m].
struct Segment {
  Eigen::Vector2d a = Eigen::Vector2d::Zero();
  Eigen::Vector2d b = Eigen::Vector2d::Zero();
};

[[nodiscard]] Extent extent_of(const Segment& segment) noexcept;

/// Distance between a segment and a point [m].
[[nodiscard]] double distance(const Segment& segment, const Eigen::Vector2d& point) noexcept;

/// Distance between a segment and a rectangle [m]; 0 if they meet. @pre the rectangle is not empty.
[[nodiscard]] double distance(const Segment& segment, const OrientedRectangle& rectangle) noexcept;

/// A simple polygon as a closed set, with the queries that zones need. All are exact up to
/// rounding.
class ZonePolygon {
 public:
  ZonePolygon() = default;
  /// @pre `corners` has at least three entries, and all are finite.
  explicit ZonePolygon(std::vector<Eigen::Vector2d> corners);

  [[nodiscard]] std::span<const Eigen::Vector2d> corners() const noexcept { return corners_; }
  [[nodiscard]] const Extent& extent() const noexcept { return extent_; }
  [[nodiscard]] std::size_t size() const noexcept { return corners_.size(); }
  [[nodiscard]] Segment edge(std::size_t i) const noexcept {
    return {.a = corners_[i], .b = corners_[i + 1 < corners_.size() ? i + 1 : 0]};
  }

  /// Returns whether a point lies inside, by the number of crossings of a ray. On an edge the
  /// answer may be either.
  [[nodiscard]] bool contains(const Eigen::Vector2d& point) const noexcept;

  /// Distance to the boundary [m], negative inside.
  [[nodiscard]] double signed_distance(const Eigen::Vector2d& point) const noexcept;

  /// Returns whether a rectangle comes within `clearance` [m], or lies inside.
  [[nodiscard]] bool is_near(const OrientedRectangle& rectangle, double clearance) const noexcept;

  /// Area [m^2], positive in either direction.
  [[nodiscard]] double area() const noexcept;

  /// Returns whether no two edges meet, except neighbours at their common corner.
  [[nodiscard]] bool is_simple() const noexcept;

 private:
  std::vector<Eigen::Vector2d> corners_;
  Extent extent_;
};

/// The share of `line` at which it crosses `other` between its ends, if it does and they are not
/// parallel.
[[nodiscard]] std::optional<double> crossing(const Segment& line, const Segment& other) noexcept;

/// Adds the shares of `line` at which it crosses `other` (0 at `line.a`, 1 at `line.b`). For
/// collinear segments these are the shares at which they begin and end to overlap.
void add_crossings(const Segment& line, const Segment& other, std::vector<double>& shares);

}  // namespace fairway
