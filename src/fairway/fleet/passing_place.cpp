// SPDX-License-Identifier: Apache-2.0
#include "fairway/fleet/passing_place.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fairway/geometry/pose2.hpp"
#include "fairway/map/free_space.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kFurthest = 6.0;           // [m] along the path
constexpr double kPlaceSpacing = 0.25;      // [m] between the points that are tested
constexpr double kPassingClearance = 0.05;  // [m] between bodies that pass
constexpr double kAside = 0.15;             // [m] between a waiting and a passing body
constexpr double kWall = 0.02;              // [m] between a waiting body and static obstacles
constexpr double kReach = 4.0;              // [m] to the furthest place
constexpr int kRings = 10;
constexpr int kDirections = 16;

struct NearestPoint {
  double distance = std::numeric_limits<double>::infinity();
  Vector2d direction = Vector2d::Zero();
  double length = 0.0;  // arc length up to there
};

NearestPoint nearest_on_path(const SharedMotion& other, const Vector2d& point) noexcept {
  NearestPoint nearest;
  Vector2d from = other.position;
  double length = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(other.way.count); ++i) {
    const Vector2d& to = other.way.points[i];
    const Vector2d on = segment_rectangle(from, to).nearest(point);
    const double distance = (on - point).norm();
    if (distance < nearest.distance) {
      nearest = {
          .distance = distance, .direction = to - from, .length = length + (on - from).norm()};
    }
    length += (to - from).norm();
    from = to;
  }
  return nearest;
}

// Returns the goal of a robot; infinitely far away if it is unknown.
Vector2d goal_of(const SharedMotion& other) noexcept {
  const bool known = other.way.count > 0 && other.way.count < UpcomingWaypoints::kMaxPoints;
  return known ? other.way.points[static_cast<std::size_t>(other.way.count - 1)]
               : Vector2d::Constant(std::numeric_limits<double>::infinity());
}

}  // namespace

NarrowPlaces::NarrowPlaces(const ReferencePath& path,
                           double radius,
                           const BitGrid& obstacles) noexcept {
  const double both = 2.0 * radius + kPassingClearance;
  const double end = std::min(kFurthest, path.length());
  for (double s = 0.0; s < end && !places.full(); s += kPlaceSpacing) {
    const Vector2d here = path.at(s);
    const Vector2d along = path.at(std::min(s + kPlaceSpacing, path.length())) - here;
    const double length = along.norm();
    if (length < 1e-3 || is_free(obstacles, here, here, both + radius)) continue;
    const Vector2d over = both / length * Vector2d(-along.y(), along.x());
    if (is_free(obstacles, here, here + over, radius) ||
        is_free(obstacles, here, here - over, radius)) {
      continue;
    }
    places.push_back({.length = s, .position = here, .along = along});
  }
}

double NarrowPlaces::length_to_meeting(const SharedMotion& other, double radius) const noexcept {
  for (const Place& place : places) {
    const NearestPoint near = nearest_on_path(other, place.position);
    if (near.distance <= radius + other.radius + kPassingClearance &&
        place.along.dot(near.direction) < 0.0) {
      return place.length;
    }
  }
  return std::numeric_limits<double>::infinity();
}

bool NarrowPlaces::contain_goal_of(const SharedMotion& other, double radius) const noexcept {
  return std::any_of(places.begin(), places.end(), [&](const Place& place) {
    return (place.position - goal_of(other)).norm() <= radius + other.radius + kPassingClearance;
  });
}

double NarrowPlaces::length_to_merging(const SharedMotion& other, double radius) const noexcept {
  constexpr double kNear = 2.5;    // [m]
  constexpr double kInside = 0.1;  // [m]
  const double none = std::numeric_limits<double>::infinity();
  const double gap = radius + other.radius + kAside;
  if (places.empty() || places[0].length < kInside || places[0].length > kNear) return none;
  const NearestPoint near = nearest_on_path(other, places[0].position);
  const bool enters = near.distance <= radius + other.radius + kPassingClearance &&
                      near.length > kInside && near.length < kNear &&
                      places[0].along.dot(near.direction) > 0.0;
  return enters && std::abs(near.length - places[0].length) < gap ? places[0].length : none;
}

bool passes_goal_of(const SharedMotion& other,
                    const Vector2d& from,
                    const Vector2d& to,
                    double radius) noexcept {
  const Vector2d goal = goal_of(other);
  if (!goal.allFinite()) return false;
  const double least = (segment_rectangle(from, to).nearest(goal) - goal).norm();
  const double keep = radius + other.radius + kPassingClearance;
  return least < std::min(keep, (from - goal).norm() - 1e-6);
}

bool lets_pass(const Vector2d& place,
               const SharedMotion& other,
               double radius,
               double more) noexcept {
  const double keep = radius + other.radius + kAside + more;
  return (other.position - place).norm() >= keep && nearest_on_path(other, place).distance >= keep;
}

std::optional<Vector2d> passing_place(const Vector2d& position,
                                      const PassingEnvironment& around) noexcept {
  const auto suits = [&](const Vector2d& place) {
    return std::all_of(around.passing.begin(), around.passing.end(),
                       [&](const SharedMotion* other) {
                         return other == nullptr || lets_pass(place, *other, around.radius);
                       });
  };
  const auto clear = [&](const Vector2d& place) {
    for (const SharedMotion* other : around.passing) {
      if (other != nullptr && passes_goal_of(*other, position, place, around.radius)) return false;
    }
    const OrientedRectangle line = segment_rectangle(position, place);
    for (const FleetMember& member : around.fleet) {
      const Vector2d& other = member.motion->position;
      const double now = (other - position).norm();
      const double keep = std::min(around.radius + member.motion->radius + kAside, now - 1e-6);
      if ((line.nearest(other) - other).norm() < keep) return false;
    }
    return is_free(*around.obstacles, position, place, around.radius + kWall);
  };
  if (suits(position)) return position;
  for (int ring = 1; ring <= kRings; ++ring) {
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kDirections;
      const Vector2d place = position + kReach * ring / kRings * direction(angle);
      if (suits(place) && clear(place)) return place;
    }
  }
  return std::nullopt;
}

}  // namespace fairway
