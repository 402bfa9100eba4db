// SPDX-License-Identifier: Apache-2.0
#include "fairway/map/free_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fairway/map/rounded_region.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;
using internal::RoundedRegion;

// Returns whether the region lies in the interior of the grid.
bool inside(const GridFrame& frame, const RoundedRegion& region) noexcept {
  return region.low().x() > 0.0 && region.low().y() > 0.0 && region.high().x() < frame.width &&
         region.high().y() < frame.height;
}

TurnedBox to_grid(const GridFrame& frame, const OrientedRectangle& r) noexcept {
  return {.origin = frame.to_grid(r.seed),
          .along = direction(r.orientation - frame.origin.heading),
          .min = r.min / frame.resolution,
          .max = r.max / frame.resolution};
}

// Whether the zones of the map forbid a box in grid coordinates, for the centre of a disc.
bool in_zone(const BitGrid& obstacles, const TurnedBox& box, double radius) noexcept {
  const ZoneMap* zones = obstacles.zones();
  if (zones == nullptr || !zones->forbids()) return false;
  const GridFrame& frame = obstacles.frame();
  const OrientedRectangle world{
      .seed = frame.to_world(box.origin),
      .orientation = frame.origin.heading + std::atan2(box.along.y(), box.along.x()),
      .min = box.min * frame.resolution,
      .max = box.max * frame.resolution};
  return zones->forbidding(world, radius * frame.resolution, ZoneSubject::Disc).has_value();
}

constexpr int kBandRows = BitGrid::kBandRows;

// Returns the first blocked cell of a region inside the grid, or {-1, -1} if there is none. Bands
// are tested first: a free band has only free rows.
CellIndex scan(const BitGrid& obstacles, const RoundedRegion& region) noexcept {
  const int first = static_cast<int>(region.low().y());
  const int last = static_cast<int>(region.high().y());
  for (int b = first / kBandRows; b <= last / kBandRows; ++b) {
    const int bottom = std::max(first, b * kBandRows);
    const int top = std::min(last, (b + 1) * kBandRows - 1);
    const RoundedRegion::Interval band = region.over_rows(bottom, top);
    if (!obstacles.any_blocked_in_band(b, static_cast<int>(band.left),
                                       static_cast<int>(band.right)))
      continue;
    const bool with_arc = region.has_arc(bottom, top);
    for (int y = bottom; y <= top; ++y) {
      const RoundedRegion::Interval row = region.over_row(y, with_arc);
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
            const RoundedRegion& region,
            CellIndex towards,
            std::span<CellIndex> found) noexcept
      : obstacles_(obstacles),
        region_(region),
        last_column_(obstacles.frame().width - 1),
        towards_(towards),
        found_(found) {}

  // Searches the rows from `bottom` to `top`, all of one band.
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
  // The columns of an interval, clipped to the grid; first > last if the interval lies outside.
  struct Columns {
    int first;
    int last;
  };
  [[nodiscard]] Columns columns(const RoundedRegion::Interval& interval) const noexcept {
    const double end = last_column_ + 1.0;
    const auto clipped = [&](double x) {
      return static_cast<int>(std::min(std::max(x, 0.0), end));
    };
    return {.first = clipped(interval.left), .last = clipped(interval.right + 1.0) - 1};
  }

  const BitGrid& obstacles_;
  const RoundedRegion& region_;
  int last_column_;
  CellIndex towards_;
  std::span<CellIndex> found_;
  std::size_t count_ = 0;
};

}  // namespace

std::optional<CellIndex> find_blocked_cell(const BitGrid& obstacles,
                                           const OrientedRectangle& rectangle,
                                           double clearance,
                                           ZoneSubject subject) noexcept {
  constexpr CellIndex kBelow{.x = -1, .y = -1};
  // This form also catches every non-finite number.
  if (rectangle.is_empty() || !(clearance >= 0.0)) return kBelow;
  const GridFrame& frame = obstacles.frame();
  const RoundedRegion region(to_grid(frame, rectangle),
                             (clearance + kFreeSpaceSkin) / frame.resolution);
  if (!(region.low().x() > 0.0 && region.low().y() > 0.0)) return kBelow;
  if (!inside(frame, region)) return CellIndex{.x = frame.width, .y = frame.height};
  const CellIndex cell = scan(obstacles, region);
  if (!(cell == kBelow)) return cell;
  const ZoneMap* zones = obstacles.zones();
  if (zones != nullptr && zones->forbidding(rectangle, clearance + kFreeSpaceSkin, subject))
    return kBelow;
  return std::nullopt;
}

bool is_free(const BitGrid& obstacles, const TurnedBox& box, double radius) noexcept {
  const RoundedRegion region(box, radius);
  return inside(obstacles.frame(), region) &&
         scan(obstacles, region) == CellIndex{.x = -1, .y = -1} && !in_zone(obstacles, box, radius);
}

BlockedCells find_blocked_cells(const BitGrid& obstacles,
                                const TurnedBox& box,
                                double radius,
                                const Vector2d& towards,
                                std::span<CellIndex> found) noexcept {
  const GridFrame& frame = obstacles.frame();
  const RoundedRegion region(box, radius);
  BlockedCells result{.count = 0,
                      .outside_map = !inside(frame, region),
                      .in_zone = in_zone(obstacles, box, radius)};
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
                           double limit,
                           ZoneSubject subject) noexcept {
  const GridFrame& frame = obstacles.frame();
  const Vector2d g = frame.to_grid(point);
  const Vector2d size(frame.width, frame.height);
  // This form also catches a non-finite point.
  if (!((g.array() > 0.0).all() && (g.array() < size.array()).all())) return 0.0;
  if (const ZoneMap* zones = obstacles.zones(); zones != nullptr)
    limit = zones->clearance_at(point, limit, subject);
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
