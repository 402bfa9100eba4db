// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/passing_place.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/map/free_space.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kFurthest = 6.0;  // [m] along the way
constexpr double kStep = 0.25;     // [m] between the points that are looked at
constexpr double kRoom = 0.05;     // [m] between bodies that pass
constexpr double kAside = 0.15;    // [m] between a body that waits and one that passes
constexpr double kReach = 4.0;     // [m] to the furthest place
constexpr int kPlaces = 15;        // along each side of the grid

struct NearWay {
  double distance = std::numeric_limits<double>::infinity();
  Vector2d direction = Vector2d::Zero();
};

NearWay nearest_on_way(const SharedMotion& other, const Vector2d& point) noexcept {
  NearWay nearest;
  Vector2d from = other.position;
  for (std::size_t i = 0; i < static_cast<std::size_t>(other.way.count); ++i) {
    const Vector2d& to = other.way.points[i];
    const double distance = (segment_rectangle(from, to).nearest(point) - point).norm();
    if (distance < nearest.distance) nearest = {.distance = distance, .direction = to - from};
    from = to;
  }
  return nearest;
}

}  // namespace

double length_to_narrow_meeting(const StringAhead& string,
                                const SharedMotion& other,
                                double radius,
                                const BitGrid& obstacles) noexcept {
  const double both = radius + other.radius + kRoom;
  const double end = std::min(kFurthest, string.length());
  for (double s = 0.0; s < end; s += kStep) {
    const Vector2d here = string.at(s);
    const Vector2d along = string.at(std::min(s + kStep, string.length())) - here;
    const double length = along.norm();
    if (length < 1e-3) continue;
    const NearWay way = nearest_on_way(other, here);
    if (way.distance > both || along.dot(way.direction) >= 0.0) continue;
    const Vector2d over = both / length * Vector2d(-along.y(), along.x());
    if (!is_free(obstacles, here, here + over, radius) &&
        !is_free(obstacles, here, here - over, radius)) {
      return s;
    }
  }
  return std::numeric_limits<double>::infinity();
}

bool lets_pass(const Vector2d& place, const SharedMotion& other, double radius) noexcept {
  const double keep = radius + other.radius + kAside;
  return (other.position - place).norm() >= keep && nearest_on_way(other, place).distance >= keep;
}

std::optional<Vector2d> passing_place(const OrientedRectangle& room,
                                      const Vector2d& position,
                                      std::span<const SharedMotion* const> others,
                                      double radius) noexcept {
  const auto suits = [&](const Vector2d& place) {
    return std::all_of(others.begin(), others.end(), [&](const SharedMotion* other) {
      return other == nullptr || lets_pass(place, *other, radius);
    });
  };
  if (suits(position)) return position;
  const Vector2d here = room.to_local(room.nearest(position));
  const Vector2d low = room.min.cwiseMax(Vector2d(here - Vector2d::Constant(kReach)));
  const Vector2d high = room.max.cwiseMin(Vector2d(here + Vector2d::Constant(kReach)));
  std::optional<Vector2d> best;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kPlaces; ++i) {
    for (int j = 0; j < kPlaces; ++j) {
      const Vector2d share(i / (kPlaces - 1.0), j / (kPlaces - 1.0));
      const Vector2d place = room.to_world(low + share.cwiseProduct(high - low));
      const double distance = (place - position).norm();
      if (distance >= least || !suits(place)) continue;
      least = distance;
      best = place;
    }
  }
  return best;
}

}  // namespace fairway
