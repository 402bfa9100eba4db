// SPDX-License-Identifier: Apache-2.0
#include "fairway/map/free_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fairway {

namespace {

using Eigen::Vector2d;

// The right half of the outline of a rectangle with round corners (all points within `radius` of
// it), as a function of the height y: an arc about the bottom corner, a side, an arc about the
// outer corner, a side, an arc about the top corner. The left half is the same with x negated and
// the two turns swapped. The function is concave.
class Flank {
 public:
  // (c, s) is the direction of the side from bottom to outer, both >= 0. Sides may have length 0.
  Flank(const Vector2d& bottom,
        const Vector2d& outer,
        const Vector2d& top,
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

  [[nodiscard]] double arc(const Vector2d& center, double y) const noexcept {
    const double dy = y - center.y();
    return center.x() + std::sqrt(std::max(0.0, square_ - dy * dy));
  }

  Vector2d bottom_;
  Vector2d outer_;
  Vector2d top_;
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

Vector2d mirrored(const Vector2d& p) noexcept { return {-p.x(), p.y()}; }

// All cells that meet the region {distance to the box <= radius}, row by row. As a convex set it
// meets a strip of rows in an interval of x.
class Region {
 public:
  Region(TurnedBox box, double radius) noexcept
      : Region(turned_to_first_quadrant(box), radius, 0) {}

  [[nodiscard]] const Vector2d& low() const noexcept { return low_; }
  [[nodiscard]] const Vector2d& high() const noexcept { return high_; }

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

  Flank right_;
  Flank left_;
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

constexpr int kBandRows = BitGrid::kBandRows;

// First blocked cell of a region that lies in the grid; {-1, -1} when there is none. Bands first:
// where a band has none, none of its rows has.
CellIndex scan(const BitGrid& obstacles, const Region& region) noexcept {
  const int first = static_cast<int>(region.low().y());
  const int last = static_cast<int>(region.high().y());
  for (int b = first / kBandRows; b <= last / kBandRows; ++b) {
    const int bottom = std::max(first, b * kBandRows);
    const int top = std::min(last, (b + 1) * kBandRows - 1);
    const Region::Interval band = region.over_rows(bottom, top);
    if (!obstacles.any_blocked_in_band(b, static_cast<int>(band.left),
                                       static_cast<int>(band.right)))
      continue;
    const bool with_arc = region.has_arc(bottom, top);
    for (int y = bottom; y <= top; ++y) {
      const Region::Interval row = region.over_row(y, with_arc);
      const int x =
          obstacles.first_blocked(y, static_cast<int>(row.left), static_cast<int>(row.right));
      if (x >= 0) return {.x = x, .y = y};
    }
  }
  return {.x = -1, .y = -1};
}

// Collects blocked cells band by band; see find_blocked_cells.
class Collector {
 public:
  Collector(const BitGrid& obstacles,
            const Region& region,
            CellIndex towards,
            std::span<CellIndex> found) noexcept
      : obstacles_(obstacles),
        region_(region),
        last_column_(obstacles.frame().width - 1),
        towards_(towards),
        found_(found) {}

  // Looks at the rows from `bottom` to `top`, all of one band.
  void look(int bottom, int top) noexcept {
    const Columns band = columns(region_.over_rows(bottom, top));
    if (!obstacles_.any_blocked_in_band(bottom / kBandRows, band.first, band.last)) return;
    const bool with_arc = region_.has_arc(bottom, top);
    const bool upwards = top > towards_.y;
    for (int k = 0; k <= top - bottom && !full(); ++k) {
      const int y = upwards ? bottom + k : top - k;
      const Columns row = columns(region_.over_row(y, with_arc));
      if (!obstacles_.any_blocked(y, row.first, row.last)) continue;
      found_[count_++] = {.x = obstacles_.nearest_blocked(y, row.first, row.last, towards_.x),
                          .y = y};
    }
  }

  [[nodiscard]] std::size_t count() const noexcept { return count_; }
  [[nodiscard]] bool full() const noexcept { return count_ == found_.size(); }

 private:
  // The columns of an interval, clipped to the grid; none where it lies outside.
  struct Columns {
    int first;
    int last;
  };
  [[nodiscard]] Columns columns(const Region::Interval& interval) const noexcept {
    const double end = last_column_ + 1.0;
    const auto clipped = [&](double x) {
      return static_cast<int>(std::min(std::max(x, 0.0), end));
    };
    return {.first = clipped(interval.left), .last = clipped(interval.right + 1.0) - 1};
  }

  const BitGrid& obstacles_;
  const Region& region_;
  int last_column_;
  CellIndex towards_;
  std::span<CellIndex> found_;
  std::size_t count_ = 0;
};

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
  if (region.high().y() < 0.0 || region.low().y() > frame.height || region.high().x() < 0.0 ||
      region.low().x() > frame.width)
    return result;
  const int first = bounded(region.low().y(), frame.height);
  const int last = bounded(region.high().y(), frame.height);
  const CellIndex middle{.x = bounded(towards.x(), frame.width),
                         .y = std::clamp(bounded(towards.y(), frame.height), first, last)};
  Collector collector(obstacles, region, middle, found);
  const auto look = [&](int b) {
    collector.look(std::max(first, b * kBandRows), std::min(last, (b + 1) * kBandRows - 1));
  };
  const int lowest = first / kBandRows;
  const int highest = last / kBandRows;
  int up = middle.y / kBandRows;
  int down = up - 1;
  while ((up <= highest || down >= lowest) && !collector.full()) {
    if (up <= highest) look(up++);
    if (down >= lowest) look(down--);
  }
  result.count = collector.count();
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
