// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/map/free_space.hpp"

namespace fairway::internal {

// The right half of the outline of a rectangle with round corners (all points within `radius` of
// it), as a function of the height y: an arc about the bottom corner, a side, an arc about the
// outer corner, a side, an arc about the top corner. The left half is the same with x negated and
// the two turns swapped. The function is concave.
class Flank {
 public:
  // (c, s) is the direction of the side from bottom to outer, both >= 0. Sides may have length 0.
  Flank(const Eigen::Vector2d& bottom,
        const Eigen::Vector2d& outer,
        const Eigen::Vector2d& top,
        double c,
        double s,
        double radius) noexcept
      : bottom_(bottom),
        outer_(outer),
        top_(top),
        square_(radius * radius),
        limit_(outer.x() + radius),
        rise_slope_(s > kLevel ? c / s : 0.0),
        rise_(s > kLevel ? bottom.x() + radius * s - (bottom.y() - radius * c) * rise_slope_
                         : kInfinity),
        fall_slope_(c > kLevel ? s / c : 0.0),
        fall_(c > kLevel ? outer.x() + radius * c + (outer.y() + radius * s) * fall_slope_
                         : kInfinity),
        lower_start_(bottom.y() - radius * c),
        lower_end_(outer.y() - radius * c),
        upper_start_(outer.y() + radius * s),
        upper_end_(top.y() + radius * s) {}

  // The outermost x over the closed strip low <= y <= high if the two sides went on to where they
  // meet each other and the limits: exact for radius 0, otherwise never too little.
  [[nodiscard]] double reach_of_sides(double low, double high) const noexcept {
    return std::min(limit_, std::min(rise_ + rise_slope_ * high, fall_ - fall_slope_ * low));
  }

  // Whether an arc may be the outline in the rows from `first` to `last`.
  [[nodiscard]] bool has_arc(double first, double last) const noexcept {
    return first < lower_start_ || last + 1.0 > upper_end_ ||
           (last + 1.0 > lower_end_ && first < upper_start_);
  }

  // The outermost x over the closed strip row <= y <= row + 1. By concavity it is at the height
  // nearest to that of the outer corner. @pre the set meets the strip.
  [[nodiscard]] double reach(double row) const noexcept {
    const double sides = reach_of_sides(row, row + 1.0);
    const double y = std::min(std::max(outer_.y(), row), row + 1.0);
    if (y < lower_start_) return std::min(sides, arc(bottom_, y));
    if (y > upper_end_) return std::min(sides, arc(top_, y));
    if (y > lower_end_ && y < upper_start_) return std::min(sides, arc(outer_, y));
    return sides;
  }

 private:
  // A side that rises less than this along its length counts as level, and so does not bound: the
  // corners do, to far less than the skin.
  static constexpr double kLevel = 1e-9;
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  [[nodiscard]] double arc(const Eigen::Vector2d& center, double y) const noexcept {
    const double dy = y - center.y();
    return center.x() + std::sqrt(std::max(0.0, square_ - dy * dy));
  }

  Eigen::Vector2d bottom_;
  Eigen::Vector2d outer_;
  Eigen::Vector2d top_;
  double square_;
  double limit_;
  // The sides: x = rise + rise_slope y below the outer corner, x = fall - fall_slope y above it.
  double rise_slope_;
  double rise_;
  double fall_slope_;
  double fall_;
  // Between which heights the outline is a side; elsewhere it is an arc.
  double lower_start_;
  double lower_end_;
  double upper_start_;
  double upper_end_;
};

inline Eigen::Vector2d mirrored(const Eigen::Vector2d& p) noexcept { return {-p.x(), p.y()}; }

// All cells that meet the region {distance to the box <= radius}, row by row. As a convex set it
// meets a strip of rows in an interval of x.
class RoundedRegion {
 public:
  RoundedRegion(TurnedBox box, double radius) noexcept
      : RoundedRegion(turned_to_first_quadrant(box), radius, 0) {}

  [[nodiscard]] const Eigen::Vector2d& low() const noexcept { return low_; }
  [[nodiscard]] const Eigen::Vector2d& high() const noexcept { return high_; }

  // The interval over the rows from `first` to `last`, or a little more.
  // @pre the region meets each of these rows.
  struct Interval {
    double left;
    double right;
  };
  [[nodiscard]] Interval over_rows(int first, int last) const noexcept {
    return {.left = -left_.reach_of_sides(first, last + 1.0),
            .right = right_.reach_of_sides(first, last + 1.0)};
  }

  // Whether that may be too much even for one of them alone; and the exact interval of a row.
  [[nodiscard]] bool has_arc(int first, int last) const noexcept {
    return left_.has_arc(first, last) || right_.has_arc(first, last);
  }
  [[nodiscard]] Interval over_row(int row, bool with_arc) const noexcept {
    if (!with_arc) return over_rows(row, row);
    return {.left = -left_.reach(row), .right = right_.reach(row)};
  }

 private:
  // The same box with both coordinates of `along` >= 0, so that the corners min, (max.x, min.y),
  // max, (min.x, max.y) are the bottom, right, top and left one.
  static TurnedBox turned_to_first_quadrant(TurnedBox box) noexcept {
    for (int i = 0; i < 3 && (box.along.x() < 0.0 || box.along.y() < 0.0); ++i) {
      box.along = Eigen::Vector2d(-box.along.y(), box.along.x());
      const Eigen::Vector2d min = box.min;
      const Eigen::Vector2d max = box.max;
      box.min = Eigen::Vector2d(min.y(), -max.x());
      box.max = Eigen::Vector2d(max.y(), -min.x());
    }
    return box;
  }

  static Eigen::Vector2d corner(const TurnedBox& box, double x, double y) noexcept {
    return {box.origin.x() + x * box.along.x() - y * box.along.y(),
            box.origin.y() + x * box.along.y() + y * box.along.x()};
  }

  RoundedRegion(const TurnedBox& box, double radius, int) noexcept
      : RoundedRegion(corner(box, box.min.x(), box.min.y()),
                      corner(box, box.max.x(), box.min.y()),
                      corner(box, box.max.x(), box.max.y()),
                      corner(box, box.min.x(), box.max.y()),
                      box.along,
                      radius) {}

  RoundedRegion(const Eigen::Vector2d& bottom,
                const Eigen::Vector2d& right,
                const Eigen::Vector2d& top,
                const Eigen::Vector2d& left,
                const Eigen::Vector2d& along,
                double radius) noexcept
      : right_(bottom, right, top, along.x(), along.y(), radius),
        left_(mirrored(bottom), mirrored(left), mirrored(top), along.y(), along.x(), radius),
        low_(left.x() - radius, bottom.y() - radius),
        high_(right.x() + radius, top.y() + radius) {}

  Flank right_;
  Flank left_;
  Eigen::Vector2d low_;
  Eigen::Vector2d high_;
};

}  // namespace fairway::internal
