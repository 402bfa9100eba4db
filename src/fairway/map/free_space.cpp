// SPDX-License-Identifier: Apache-2.0
#include "fairway/map/free_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fairway {

namespace {

using Eigen::Vector2d;

// The right half of the outline of a rectangle with round corners (all points within `radius` of
// it), as a function of the height y: an arc about the bottom corner, a side, an arc about the
// right corner, a side, an arc about the top corner. The left half is the same with x negated and
// the two turns swapped. The function is concave.
class Outline {
 public:
  // Corners bottom, right, top; (c, s) is the direction of the side from bottom to right, both
  // >= 0. Sides may have length 0.
  Outline(const Vector2d& bottom,
          const Vector2d& right,
          const Vector2d& top,
          double c,
          double s,
          double radius) noexcept
      : bottom_(bottom),
        right_(right),
        top_(top),
        square_(radius * radius),
        limit_(right.x() + radius),
        // A level side spans no height and is never asked for its slope.
        lower_slope_(s > 0.0 ? c / s : 0.0),
        upper_slope_(c > 0.0 ? -s / c : 0.0),
        lower_start_(bottom.x() + radius * s, bottom.y() - radius * c),
        lower_end_(right.y() - radius * c),
        upper_start_(right.x() + radius * c, right.y() + radius * s),
        upper_end_(top.y() + radius * s) {}

  // The height of the rightmost point.
  [[nodiscard]] double widest() const noexcept { return right_.y(); }

  // The largest x of the set at height y. @pre the set has a point at this height.
  [[nodiscard]] double reach(double y) const noexcept {
    if (y < lower_end_) {
      if (y < lower_start_.y()) return arc(bottom_, y);
      return std::min(limit_, lower_start_.x() + (y - lower_start_.y()) * lower_slope_);
    }
    if (y > upper_start_.y()) {
      if (y > upper_end_) return arc(top_, y);
      return upper_start_.x() + (y - upper_start_.y()) * upper_slope_;
    }
    return arc(right_, y);
  }

 private:
  [[nodiscard]] double arc(const Vector2d& center, double y) const noexcept {
    const double dy = y - center.y();
    return center.x() + std::sqrt(std::max(0.0, square_ - dy * dy));
  }

  Vector2d bottom_;
  Vector2d right_;
  Vector2d top_;
  double square_;
  double limit_;
  double lower_slope_;
  double upper_slope_;
  Vector2d lower_start_;
  double lower_end_;
  Vector2d upper_start_;
  double upper_end_;
};

Vector2d mirrored(const Vector2d& p) noexcept { return {-p.x(), p.y()}; }

// All cells that meet the region {distance to the box <= radius}, row by row. As a convex set it
// meets a row, a closed strip, in an interval of x.
class Region {
 public:
  Region(TurnedBox box, double radius) noexcept
      : Region(turned_to_first_quadrant(box), radius, 0) {}

  [[nodiscard]] const Vector2d& low() const noexcept { return low_; }
  [[nodiscard]] const Vector2d& high() const noexcept { return high_; }

  struct Interval {
    double left;
    double right;
  };

  // The region's extent over the closed strip row <= y <= row + 1. @pre they meet.
  // The outline's reach to a side is concave in y: over the strip it is greatest at the height
  // nearest to that of the outermost corner.
  [[nodiscard]] Interval over_row(int row) const noexcept {
    const double bottom = std::max(static_cast<double>(row), low_.y());
    const double top = std::min(static_cast<double>(row) + 1.0, high_.y());
    return {.left = -left_.reach(std::max(bottom, std::min(left_.widest(), top))),
            .right = right_.reach(std::max(bottom, std::min(right_.widest(), top)))};
  }

 private:
  // The same box with both coordinates of `along` >= 0, so that the corners min, (max.x, min.y),
  // max, (min.x, max.y) are the bottom, right, top and left one.
  static TurnedBox turned_to_first_quadrant(TurnedBox box) noexcept {
    for (int i = 0; i < 3 && (box.along.x() < 0.0 || box.along.y() < 0.0); ++i) {
      box.along = Vector2d(-box.along.y(), box.along.x());
      const Vector2d min = box.min;
      const Vector2d max = box.max;
      box.min = Vector2d(min.y(), -max.x());
      box.max = Vector2d(max.y(), -min.x());
    }
    return box;
  }

  static Vector2d corner(const TurnedBox& box, double x, double y) noexcept {
    return {box.origin.x() + x * box.along.x() - y * box.along.y(),
            box.origin.y() + x * box.along.y() + y * box.along.x()};
  }

  Region(const TurnedBox& box, double radius, int) noexcept
      : Region(corner(box, box.min.x(), box.min.y()),
               corner(box, box.max.x(), box.min.y()),
               corner(box, box.max.x(), box.max.y()),
               corner(box, box.min.x(), box.max.y()),
               box.along,
               radius) {}

  Region(const Vector2d& bottom,
         const Vector2d& right,
         const Vector2d& top,
         const Vector2d& left,
         const Vector2d& along,
         double radius) noexcept
      : right_(bottom, right, top, along.x(), along.y(), radius),
        left_(mirrored(bottom), mirrored(left), mirrored(top), along.y(), along.x(), radius),
        low_(left.x() - radius, bottom.y() - radius),
        high_(right.x() + radius, top.y() + radius) {}

  Outline right_;
  Outline left_;
  Vector2d low_;
  Vector2d high_;
};

// Whether the region lies in the open grid.
bool inside(const GridFrame& frame, const Region& region) noexcept {
  return region.low().x() > 0.0 && region.low().y() > 0.0 && region.high().x() < frame.width &&
         region.high().y() < frame.height;
}

TurnedBox to_grid(const GridFrame& frame, const OrientedRectangle& r) noexcept {
  return {.origin = frame.to_grid(r.seed),
          .along = direction(r.orientation - frame.origin.heading),
          .min = r.min / frame.resolution,
          .max = r.max / frame.resolution};
}

// First blocked cell of a region that lies in the grid; {-1, -1} when there is none.
CellIndex scan(const BitGrid& obstacles, const Region& region) noexcept {
  const int last_row = static_cast<int>(region.high().y());
  for (int row = static_cast<int>(region.low().y()); row <= last_row; ++row) {
    const Region::Interval interval = region.over_row(row);
    const int column = obstacles.first_blocked(row, static_cast<int>(interval.left),
                                               static_cast<int>(interval.right));
    if (column >= 0) return {.x = column, .y = row};
  }
  return {.x = -1, .y = -1};
}

}  // namespace

std::optional<CellIndex> find_blocked_cell(const BitGrid& obstacles,
                                           const OrientedRectangle& rectangle,
                                           double clearance) noexcept {
  constexpr CellIndex kBelow{.x = -1, .y = -1};
  // Written so that every non-finite number lands here too.
  if (rectangle.is_empty() || !(clearance >= 0.0)) return kBelow;
  const GridFrame& frame = obstacles.frame();
  const Region region(to_grid(frame, rectangle), (clearance + kFreeSpaceSkin) / frame.resolution);
  if (!(region.low().x() > 0.0 && region.low().y() > 0.0)) return kBelow;
  if (!inside(frame, region)) return CellIndex{.x = frame.width, .y = frame.height};
  const CellIndex cell = scan(obstacles, region);
  if (cell == kBelow) return std::nullopt;
  return cell;
}

bool is_free(const BitGrid& obstacles, const TurnedBox& box, double radius) noexcept {
  const Region region(box, radius);
  return inside(obstacles.frame(), region) &&
         scan(obstacles, region) == CellIndex{.x = -1, .y = -1};
}

BlockedCells find_blocked_cells(const BitGrid& obstacles,
                                const TurnedBox& box,
                                double radius,
                                const Vector2d& towards,
                                std::span<CellIndex> found) noexcept {
  const GridFrame& frame = obstacles.frame();
  const Region region(box, radius);
  BlockedCells result{.count = 0, .outside_map = !inside(frame, region)};
  const auto bounded = [](double v, int size) {
    return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(size) - 1.0));
  };
  const int first_row = bounded(region.low().y(), frame.height);
  const int last_row = bounded(region.high().y(), frame.height);
  if (region.high().y() < 0.0 || region.low().y() > frame.height) return result;
  const auto look = [&](int row) {
    const Region::Interval interval = region.over_row(row);
    if (interval.right < 0.0 || interval.left >= frame.width) return;
    const int column = obstacles.nearest_blocked(row, bounded(interval.left, frame.width),
                                                 bounded(interval.right, frame.width),
                                                 bounded(towards.x(), frame.width));
    if (column >= 0) found[result.count++] = {.x = column, .y = row};
  };
  const int middle = std::clamp(bounded(towards.y(), frame.height), first_row, last_row);
  for (int k = 0; result.count < found.size(); ++k) {
    const int up = middle + k;
    const int down = middle - 1 - k;
    if (up > last_row && down < first_row) break;
    if (up <= last_row) look(up);
    if (down >= first_row && result.count < found.size()) look(down);
  }
  return result;
}

double distance_to_blocked(const BitGrid& obstacles,
                           const Eigen::Vector2d& point,
                           double limit) noexcept {
  const GridFrame& frame = obstacles.frame();
  const Vector2d g = frame.to_grid(point);
  const Vector2d size(frame.width, frame.height);
  // Written so that a point that is not finite lands here too.
  if (!((g.array() > 0.0).all() && (g.array() < size.array()).all())) return 0.0;
  double best = std::min({limit / frame.resolution, g.minCoeff(), (size - g).minCoeff()});
  const auto outside = [](double v, int cell) { return std::max({cell - v, v - cell - 1, 0.0}); };
  const auto nearest_in_row = [&](int y) {
    const double dy = outside(g.y(), y);
    if (dy >= best) return;
    const double reach = std::sqrt(best * best - dy * dy);
    const int last = std::min(frame.width - 1, static_cast<int>(g.x() + reach));
    int x = std::max(0, static_cast<int>(g.x() - reach) - 1);
    while ((x = obstacles.first_blocked(y, x, last)) >= 0) {
      best = std::min(best, std::hypot(outside(g.x(), x), dy));
      ++x;
    }
  };
  const int row = static_cast<int>(g.y());
  for (int away = 0; away - 1 < best; ++away) {
    if (row - away >= 0) nearest_in_row(row - away);
    if (away > 0 && row + away < frame.height) nearest_in_row(row + away);
  }
  return best * frame.resolution;
}

}  // namespace fairway
