// SPDX-License-Identifier: Apache-2.0
#include "fairway/fleet/roundabout.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fairway/geometry/angle.hpp"
#include "fairway/geometry/oriented_rectangle.hpp"
#include "fairway/geometry/pose2.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;
using std::numbers::pi;

constexpr double kArcStep = 0.35;  // [rad] between the points of the arc
constexpr double kSpiral = 1.0;    // [rad] over which a start inside the circle spirals out to it
constexpr double kMostTurn = 1.4;  // [half turns]

void append(ReferencePath& path, const Vector2d& point) noexcept {
  if (path.count == ReferencePath::kMaxPoints) return;
  const auto i = static_cast<std::size_t>(path.count++);
  path.points[i] = point;
  path.arc[i] = i == 0 ? 0.0 : path.arc[i - 1] + (point - path.points[i - 1]).norm();
}

double angle_of(const Vector2d& v) noexcept { return std::atan2(v.y(), v.x()); }

// Returns the angle at the centre between a point at `distance` and its tangent's touching point.
// It is 0 for a point inside.
double tangent_angle(double radius, double distance) noexcept {
  return distance > radius ? std::acos(radius / distance) : 0.0;
}

std::size_t nearest_piece(const ReferencePath& path, const Vector2d& point) noexcept {
  std::size_t nearest = 1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < static_cast<std::size_t>(path.count); ++i) {
    const Vector2d on = segment_rectangle(path.points[i - 1], path.points[i]).nearest(point);
    const double distance = (on - point).norm();
    if (distance < least) {
      least = distance;
      nearest = i;
    }
  }
  return nearest;
}

}  // namespace

bool bend_around(const ReferencePath& path,
                 const Roundabout& roundabout,
                 ReferencePath& bent) noexcept {
  const double radius = roundabout.radius;
  const std::size_t piece = nearest_piece(path, roundabout.center);
  const Vector2d from = path.points[piece - 1] - roundabout.center;
  const Vector2d to = path.points[piece] - roundabout.center;
  double turn = angle_of(to) - angle_of(from);
  if (turn < 0.0) turn += 2.0 * pi;
  if (turn > kMostTurn * pi) return false;
  const double entry = tangent_angle(radius, from.norm());
  const double arc = turn - entry - tangent_angle(radius, to.norm());
  if (arc <= 0.0) return false;
  if (turn > pi && 2.0 * pi - turn <= entry + tangent_angle(radius, to.norm())) return false;

  bent.count = 0;
  for (std::size_t i = 0; i < piece; ++i)
    append(bent, path.points[i]);
  const bool inside = from.norm() < radius;
  const int steps = 1 + static_cast<int>(arc / kArcStep);
  for (int i = inside ? 1 : 0; i <= steps; ++i) {
    const double along = arc * i / steps;
    const double out = inside ? std::min(1.0, along / kSpiral) : 1.0;
    const double distance = from.norm() + (radius - from.norm()) * out;
    append(bent, roundabout.center +
                     (inside ? distance : radius) * direction(angle_of(from) + entry + along));
  }
  for (std::size_t i = piece; i < static_cast<std::size_t>(path.count); ++i)
    append(bent, path.points[i]);
  const bool whole = (bent.points[static_cast<std::size_t>(bent.count - 1)] -
                      path.points[static_cast<std::size_t>(path.count - 1)])
                         .isZero(0.0);
  bent.ends_at_goal = path.ends_at_goal && whole;
  return true;
}

}  // namespace fairway
