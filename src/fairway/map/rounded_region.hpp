// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/map/free_space.hpp"

namespace fairway::internal {

// The right half of the outline of a rounded rectangle, as a function of the height y. A rounded
// rectangle is the set of all points within `radius` of a rectangle.
//
// The outline has five pieces: an arc about the bottom corner, a side, an arc about the outer
// corner, a side, and an arc about the top corner. The left half has the same form with x negated
// and the two sides swapped. The function is concave.
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

  // Bounds x over the closed strip low <= y <= high by the two sides and the limit. The bound is
  // exact for radius 0, and otherwise never too small.
  [[nodiscard]] double reach_of_sides(double low, double high) const noexcept {
    return std::min(limit_, std::min(rise_ + rise_slope_ * high, fall_ - fall_slope_ * low));
  }

  // Returns whether an arc may form the outline in the rows from `first` to `last`.
  [[nodiscard]] bool has_arc(double first, double last) const noexcept {
    return first < lower_start_ || last + 1.0 > upper_end_ ||
           (last + 1.0 > lower_end_ && first < upper_start_);
  }

  // The greatest x over the closed strip row <= y <= row + 1. By concavity it is at the height
  // nearest to the outer corner. @pre the region meets the strip.
  [[nodiscard]] double reach(double row) const noexcept {
    const double sides = reach_of_sides(row, row + 1.0);
    const double y = std::min(std::max(outer_.y(), row), row + 1.0);
    if (y < lower_start_) return std::min(sides, arc(bottom_, y));
    if (y > upper_end_) return std::min(sides, arc(top_, y));
    if (y > lower_end_ && y < upper_start_) return std::min(sides, arc(outer_, y));
    return sides;
  }

 private:
  // A side with a smaller slope counts as level and gives no bound. The corners then bound the
  // region, with an error far below the skin.
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
  // The sides are x = rise + rise_slope y below the outer corner and x = fall - fall_slope y above
  // it.
  double rise_slope_;
  double rise_;
  double fall_slope_;
  double fall_;
  // The outline is a side between these heights, and an arc elsewhere.
  double lower_start_;
  double lower_end_;
  double upper_start_;
  double upper_end_;
};

inline Eigen::Vector2d mirrored(const Eigen::Vector2d& p) noexcept { return {-p.x(), p.y()}; }

// All cells that meet the region {distance to the box <= radius}, row by row. The region is convex,
// so it meets a strip of rows in an interval of x.
class RoundedRegion {
 public:
  RoundedRegion(TurnedBox box, double radius) noexcept
      : RoundedRegion(turned_to_first_quadrant(box), radius, 0) {}

  [[nodiscard]] const Eigen::Vector2d& low() const noexcept { return low_; }
  [[nodiscard]] const Eigen::Vector2d& high() const noexcept { return high_; }

  // An interval that contains the region over the rows from `first` to `last`, and may be slightly
  // larger.
  // @pre the region meets each of these rows.
  struct Interval {
    double left;
    double right;
  };
  [[nodiscard]] Interval over_rows(int first, int last) const noexcept {
    return {.left = -left_.reach_of_sides(first, last + 1.0),
            .right = right_.reach_of_sides(first, last + 1.0)};
  }

  // Returns whether that interval may be too large even for a single row; over_row gives the exact
  // one.
  [[nodiscard]] bool has_arc(int first, int last) const noexcept {
    return left_.has_arc(first, last) || right_.has_arc(first, last);
  }
  [[nodiscard]] Interval over_row(int row, bool with_arc) const noexcept {
    if (!with_arc) return over_rows(row, row);
    return {.left = -left_.reach(row), .right = right_.reach(row)};
  }

 private:
  // Turns the box so that both coordinates of `along` are >= 0. The corners min, (max.x, min.y),
  // max and (min.x, max.y) are then the bottom, right, top and left one.
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
