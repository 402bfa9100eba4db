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

  // The column, rounded towards zero, of the outermost x over each closed strip row <= y <= row + 1
  // for `count` rows from `first` on; of minus x when `kMirrored`. @pre the set meets each row.
  //
  // By concavity the outermost x of a strip is at the height nearest to widest(): at the strip's
  // top below it, at its bottom above. So each run of rows lies on one arc or one side.
  template <bool kMirrored>
  void columns(int first, int count, int* out) const noexcept {
    const int end = first + count;
    const auto row_of = [&](double y) {
      return static_cast<int>(std::clamp(y, static_cast<double>(first), static_cast<double>(end)));
    };
    const auto column = [](double x) { return static_cast<int>(kMirrored ? -x : x); };
    const auto along_arc = [&](const Vector2d& center, int from, int to, double height) {
      for (int row = from; row < to; ++row)
        out[row - first] = column(arc(center, static_cast<double>(row) + height));
    };
    const auto along_side = [&](const Vector2d& start, double slope, int from, int to,
                                double height) {
      const double x = start.x() + (from + height - start.y()) * slope;
      int* const target = out + (from - first);
      for (int k = 0; k < to - from; ++k)
        target[k] = column(std::min(limit_, x + k * slope));
    };
    const int widest_row = row_of(std::floor(widest()));
    const int below = std::min(widest_row, end);
    const int side_from = std::min(below, row_of(std::ceil(lower_start_.y() - 1.0)));
    const int side_to = std::clamp(row_of(std::ceil(lower_end_ - 1.0)), side_from, below);
    along_arc(bottom_, first, side_from, 1.0);
    along_side(lower_start_, lower_slope_, side_from, side_to, 1.0);
    along_arc(right_, side_to, below, 1.0);
    const bool widest_inside = widest() >= first && widest() < end;
    if (widest_inside) out[widest_row - first] = column(limit_);
    const int above = std::min(end, widest() < first ? first : widest_row + 1);
    const int upper_from = std::max(above, row_of(std::floor(upper_start_.y()) + 1.0));
    const int upper_to = std::max(upper_from, row_of(std::floor(upper_end_) + 1.0));
    along_arc(right_, above, upper_from, 0.0);
    along_side(upper_start_, upper_slope_, upper_from, upper_to, 0.0);
    along_arc(top_, upper_to, end, 0.0);
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

  // The first and last column of each row, for `count` rows from `first` on. @pre the region meets
  // each of these rows.
  void columns(int first, int count, int* left, int* right) const noexcept {
    left_.columns<true>(first, count, left);
    right_.columns<false>(first, count, right);
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

// Rows whose columns are worked out at once.
constexpr int kRows = 64;

struct Columns {
  std::array<int, kRows> left;
  std::array<int, kRows> right;
};

// First blocked cell of a region that lies in the grid; {-1, -1} when there is none.
CellIndex scan(const BitGrid& obstacles, const Region& region) noexcept {
  Columns columns;  // NOLINT(*-member-init): filled as far as it is read
  const int end = static_cast<int>(region.high().y()) + 1;
  for (int first = static_cast<int>(region.low().y()); first < end; first += kRows) {
    const int count = std::min(kRows, end - first);
    region.columns(first, count, columns.left.data(), columns.right.data());
    for (int k = 0; k < count; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const int column = obstacles.first_blocked(first + k, columns.left[i], columns.right[i]);
      if (column >= 0) return {.x = column, .y = first + k};
    }
  }
  return {.x = -1, .y = -1};
}

// Collects blocked cells row by row; see find_blocked_cells.
class Collector {
 public:
  Collector(const BitGrid& obstacles,
            const Region& region,
            int towards,
            std::span<CellIndex> found) noexcept
      : obstacles_(obstacles),
        region_(region),
        last_column_(obstacles.frame().width - 1),
        towards_(towards),
        found_(found) {}

  // Looks at `count` rows from `first` on, upwards, or at as many from `first` on downwards.
  void up(int first, int count) noexcept {
    region_.columns(first, count, columns_.left.data(), columns_.right.data());
    for (int k = 0; k < count && count_ < found_.size(); ++k)
      look(first + k, static_cast<std::size_t>(k));
  }

  void down(int first, int count) noexcept {
    region_.columns(first - count + 1, count, columns_.left.data(), columns_.right.data());
    for (int k = count; k-- > 0 && count_ < found_.size();)
      look(first - count + 1 + k, static_cast<std::size_t>(k));
  }

  [[nodiscard]] std::size_t count() const noexcept { return count_; }

 private:
  void look(int row, std::size_t i) noexcept {
    const int left = std::max(columns_.left[i], 0);
    const int right = std::min(columns_.right[i], last_column_);
    if (obstacles_.first_blocked(row, left, right) < 0) return;
    found_[count_++] = {.x = obstacles_.nearest_blocked(row, left, right, towards_), .y = row};
  }

  const BitGrid& obstacles_;
  const Region& region_;
  int last_column_;
  int towards_;
  std::span<CellIndex> found_;
  std::size_t count_ = 0;
  Columns columns_;  // NOLINT(*-member-init): filled as far as it is read
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
  if (region.high().y() < 0.0 || region.low().y() > frame.height) return result;
  const auto bounded = [](double v, int size) {
    return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(size) - 1.0));
  };
  const int first_row = bounded(region.low().y(), frame.height);
  const int last_row = bounded(region.high().y(), frame.height);
  const int middle = std::clamp(bounded(towards.y(), frame.height), first_row, last_row);
  Collector collector(obstacles, region, bounded(towards.x(), frame.width), found);
  int up = middle;
  int down = middle - 1;
  while ((up <= last_row || down >= first_row) && collector.count() < found.size()) {
    if (up <= last_row) collector.up(up, std::min(kRows, last_row - up + 1));
    if (down >= first_row) collector.down(down, std::min(kRows, down - first_row + 1));
    up += kRows;
    down -= kRows;
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
