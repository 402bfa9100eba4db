// SPDX-License-Identifier: Apache-2.0
#include "fairway/map/body_clearance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fairway/map/body_zones.hpp"
#include "fairway/map/free_space.hpp"
#include "fairway/map/polygon_separation.hpp"
#include "fairway/zones/zone_map.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;
using internal::Columns;

// A lower and an upper bound of the distance from a point to obstacles, from the field's cell.
struct Bounds {
  double low;
  double high;
};

Bounds bounds_at(const DistanceField& distances, const Vector2d& local) noexcept {
  const GridFrame& frame = distances.frame();
  const Vector2d g = local / frame.resolution;
  // Written so that a point that is not finite counts as outside.
  if (!(g.x() > 0.0 && g.y() > 0.0 && g.x() < frame.width && g.y() < frame.height))
    return {0.0, 0.0};
  const CellIndex cell{.x = static_cast<int>(g.x()), .y = static_cast<int>(g.y())};
  const double off = frame.resolution * (g - Vector2d(cell.x + 0.5, cell.y + 0.5)).norm();
  const double there = distances.at(cell);
  constexpr double kFieldError = 2e-7;  // relative, of a distance stored as float
  return {there * (1.0 - kFieldError) - off, there * (1.0 + kFieldError) + off};
}

}  // namespace

BodyClearance::BodyClearance(const BitGrid& obstacles,
                             const DistanceField& distances,
                             BodyShape body)
    : obstacles_(&obstacles),
      distances_(&distances),
      body_(std::move(body)),
      origin_direction_(direction(obstacles.frame().origin.heading)) {}

Pose2 BodyClearance::in_grid_frame(const Pose2& pose) const noexcept {
  const Pose2& origin = obstacles_->frame().origin;
  const Vector2d way = pose.position - origin.position;
  const Vector2d& d = origin_direction_;
  return {.position = {d.x() * way.x() + d.y() * way.y(), d.x() * way.y() - d.y() * way.x()},
          .heading = pose.heading - origin.heading};
}

BodyClearance::Guess BodyClearance::guess(const Pose2& local, double clearance) const noexcept {
  const Vector2d d = direction(local.heading);
  const auto place = [&](const Vector2d& q) {
    return Vector2d(local.position.x() + d.x() * q.x() - d.y() * q.y(),
                    local.position.y() + d.y() * q.x() + d.x() * q.y());
  };
  bool all_free = true;
  for (const Footprint::Disc& disc : body_.cover()) {
    if (bounds_at(*distances_, place(disc.center)).low <=
        disc.radius + clearance + kFreeSpaceSkin) {
      all_free = false;
      break;
    }
  }
  if (all_free) return Guess::Free;
  for (const Footprint::Disc& disc : body_.core()) {
    if (bounds_at(*distances_, place(disc.center)).high <= disc.radius + clearance)
      return Guess::Blocked;
  }
  return Guess::Near;
}

ConvexPart BodyClearance::part_in_grid(const ConvexPart& part, const Pose2& local) const noexcept {
  const double scale = 1.0 / obstacles_->frame().resolution;
  const Vector2d d = scale * direction(local.heading);
  const Vector2d position = scale * local.position;
  ConvexPart placed;
  placed.count = part.count;
  placed.radius = scale * part.radius;
  for (int i = 0; i < part.count; ++i) {
    const Vector2d& q = part.vertex(i);
    placed.vertices[static_cast<std::size_t>(i)] = {position.x() + d.x() * q.x() - d.y() * q.y(),
                                                    position.y() + d.y() * q.x() + d.x() * q.y()};
  }
  return placed;
}

// `part` in grid coordinates, `clearance` in cells.
bool BodyClearance::is_free_part(const ConvexPart& part, double clearance) const noexcept {
  const GridFrame& frame = obstacles_->frame();
  const double reach = part.radius + clearance;
  Vector2d low = part.vertex(0);
  Vector2d high = part.vertex(0);
  for (int i = 1; i < part.count; ++i) {
    low = low.cwiseMin(part.vertex(i));
    high = high.cwiseMax(part.vertex(i));
  }
  if (!(low.x() - reach > 0.0 && low.y() - reach > 0.0 && high.x() + reach < frame.width &&
        high.y() + reach < frame.height))
    return false;
  const int last = static_cast<int>(high.y() + reach);
  for (int y = static_cast<int>(low.y() - reach); y <= last; ++y) {
    // What touches the row, grown by the reach, lies in these columns; each candidate is measured.
    const Columns near = internal::columns_between(part, y - reach, y + 1.0 + reach);
    if (near.left > near.right) continue;
    const int right = std::min(frame.width - 1, static_cast<int>(near.right + reach));
    int x = obstacles_->first_blocked(y, std::max(0, static_cast<int>(near.left - reach)), right);
    for (; x >= 0; x = obstacles_->first_blocked(y, x + 1, right)) {
      if (internal::separation(part, {.x = x, .y = y}).distance <= reach) return false;
      if (x == right) break;
    }
  }
  return true;
}

bool BodyClearance::is_free_exactly(const Pose2& local, double clearance) const noexcept {
  const double cells = 1.0 / obstacles_->frame().resolution;
  const double radius = (clearance + kFreeSpaceSkin) * cells;
  if (body_.is_rectangle()) {
    const TurnedBox box{.origin = local.position * cells,
                        .along = direction(local.heading),
                        .min = body_.low() * cells,
                        .max = body_.high() * cells};
    if (obstacles_->zones() == nullptr) return fairway::is_free(*obstacles_, box, radius);
    std::array<CellIndex, 1> found;  // NOLINT(*-member-init); zones were tested before
    const BlockedCells blocked = find_blocked_cells(*obstacles_, box, radius, box.origin, found);
    return blocked.count == 0 && !blocked.outside_map;
  }
  return std::all_of(body_.parts().begin(), body_.parts().end(), [&](const ConvexPart& part) {
    return is_free_part(part_in_grid(part, local), radius);
  });
}

bool BodyClearance::is_free(const Pose2& pose, double clearance) const noexcept {
  if (!is_finite(pose)) return false;
  const Pose2 local = in_grid_frame(pose);
  const Guess first = guess(local, clearance);
  const ZoneMap* zones = obstacles_->zones();
  if (zones != nullptr && first != Guess::Blocked &&
      !internal::zones_allow(*zones, body_, pose, clearance + kFreeSpaceSkin)) {
    return false;
  }
  return first == Guess::Free || (first == Guess::Near && is_free_exactly(local, clearance));
}

bool BodyClearance::is_free(const Pose2& start,
                            const PlanarTwist& twist,
                            double duration,
                            double clearance) const noexcept {
  // Every point of the body keeps its speed along a constant twist.
  const double speed = body_.greatest_speed(twist.linear, twist.lateral, twist.angular);
  if (!std::isfinite(speed * duration) || !is_finite(start)) return false;
  // Intervals still to be proven, last first; halving needs one more entry per level.
  struct Interval {
    double begin;
    double end;
  };
  constexpr std::size_t kDeepest = 48;
  std::array<Interval, kDeepest> waiting{};
  std::size_t count = 0;
  waiting[count++] = {0.0, duration};
  while (count > 0) {
    const Interval now = waiting[--count];
    const double middle = 0.5 * (now.begin + now.end);
    const double half_way = 0.5 * speed * (now.end - now.begin);
    const Pose2 pose = moved(start, twist, middle);
    if (is_free(pose, clearance + half_way)) continue;
    if (half_way <= kMotionTolerance || count + 2 > kDeepest || !is_free(pose, clearance))
      return false;
    waiting[count++] = {now.begin, middle};
    waiting[count++] = {middle, now.end};
  }
  return true;
}

double BodyClearance::distance(const Pose2& pose, double limit) const noexcept {
  constexpr double kResolution = 1e-4;
  if (!is_free(pose, 0.0)) return 0.0;
  if (is_free(pose, limit)) return limit;
  double low = std::min(limit, distance_bound(pose));
  double high = limit;
  while (high - low > kResolution) {
    const double middle = 0.5 * (low + high);
    (is_free(pose, middle) ? low : high) = middle;
  }
  return low;
}

double BodyClearance::distance_bound(const Pose2& pose) const noexcept {
  if (!is_finite(pose)) return 0.0;
  const Pose2 local = in_grid_frame(pose);
  double least = std::numeric_limits<double>::infinity();
  for (const Footprint::Disc& disc : body_.cover()) {
    const double there = bounds_at(*distances_, transform(local, disc.center)).low;
    least = std::min(least, there - disc.radius - kFreeSpaceSkin);
  }
  return std::max(0.0, least);
}

}  // namespace fairway
