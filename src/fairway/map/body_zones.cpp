// SPDX-License-Identifier: Apache-2.0
#include "fairway/map/body_zones.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/zones/zone_map.hpp"

namespace fairway::internal {

namespace {

using Eigen::Vector2d;

// A convex part in the world; its vertices are counter-clockwise.
ConvexPart placed_at(const ConvexPart& part, const Pose2& pose) noexcept {
  ConvexPart placed;
  placed.count = part.count;
  placed.radius = part.radius;
  for (int i = 0; i < part.count; ++i)
    placed.vertices[static_cast<std::size_t>(i)] = transform(pose, part.vertex(i));
  return placed;
}

bool holds(const ConvexPart& part, const Vector2d& point) noexcept {
  if (part.count < 3) return false;
  for (int i = 0; i < part.count; ++i) {
    const Vector2d& a = part.vertex(i);
    const Vector2d along = part.vertex((i + 1) % part.count) - a;
    const Vector2d to = point - a;
    if (along.x() * to.y() - along.y() * to.x() < 0.0) return false;
  }
  return true;
}

// Whether a boundary lies wholly inside a part: no edge of the part then comes near it.
bool encloses(const ConvexPart& part, const ZoneBoundary& boundary) noexcept {
  return std::any_of(boundary.pieces().begin(), boundary.pieces().end(),
                     [&](const ZoneBoundary::Piece& piece) { return holds(part, piece.line.a); });
}

}  // namespace

std::optional<std::size_t> forbidding_zone(const ZoneMap& zones,
                                           const BodyShape& body,
                                           const Pose2& pose,
                                           double clearance) noexcept {
  if (!zones.forbids()) return std::nullopt;
  const auto zone_of = [](const ZoneBoundary& boundary) { return boundary.pieces().front().zone; };
  double whole = 0.0;
  for (const ConvexPart& local : body.parts()) {
    const ConvexPart part = placed_at(local, pose);
    for (int i = 0; i < part.count; ++i) {
      const Vector2d& a = part.vertex(i);
      const Vector2d& b = part.vertex((i + 1) % part.count);
      whole = std::max(whole, (a - pose.position).norm() + part.radius);
      if (const auto zone =
              zones.forbidding(segment_rectangle(a, b), part.radius + clearance, ZoneSubject::Body))
        return zone;
    }
    const ZoneBoundary& keep_outs = zones.keep_outs(ZoneReference::Contour);
    if (encloses(part, keep_outs)) return zone_of(keep_outs);
    const ZoneBoundary& strips = zones.strips(ZoneReference::Contour);
    if (!zones.has_mixed_strips() && encloses(part, strips)) return zone_of(strips);
  }
  const OrientedRectangle here = segment_rectangle(pose.position, pose.position);
  return zones.forbidding(here, clearance, ZoneSubject::Centre, whole);
}

namespace {

bool touches(const ZoneMap::SpeedRegion& region,
             const BodyShape& body,
             const Pose2& pose,
             double slack) noexcept {
  const OrientedRectangle here = segment_rectangle(pose.position, pose.position);
  const double reach = (region.contour ? body.circumscribed_radius() : 0.0) + slack;
  if (!region.polygon.is_near(here, reach)) return false;
  if (!region.contour) return true;
  return std::any_of(body.parts().begin(), body.parts().end(), [&](const ConvexPart& local) {
    const ConvexPart part = placed_at(local, pose);
    for (int i = 0; i < part.count; ++i) {
      const Vector2d& b = part.vertex((i + 1) % part.count);
      if (region.polygon.is_near(segment_rectangle(part.vertex(i), b), part.radius + slack))
        return true;
    }
    return holds(part, region.polygon.corners().front());
  });
}

}  // namespace

double zone_speed(const ZoneMap& zones,
                  const BodyShape& body,
                  const Pose2& pose,
                  double slack) noexcept {
  double least = std::numeric_limits<double>::infinity();
  for (const ZoneMap::SpeedRegion& region : zones.speed_regions()) {
    if (region.speed < least && touches(region, body, pose, slack)) least = region.speed;
  }
  return least;
}

bool goes_against_lane(const ZoneMap& zones,
                       const Pose2& start,
                       const PlanarTwist& twist,
                       double duration,
                       const LaneReserve& reserve) noexcept {
  if (!zones.has_lanes()) return false;
  const double length = duration * std::hypot(twist.linear, twist.lateral);
  constexpr double kNothing = 1e-9;  // [m]
  if (!(length > kNothing)) return false;
  constexpr double kLongest = 0.25;   // of a piece [m]
  constexpr double kMostTurn = 0.05;  // in a piece [rad]
  constexpr double kMostPieces = 256.0;
  const double turn = std::abs(twist.angular) * duration;
  const int pieces = static_cast<int>(
      std::clamp(std::ceil(std::max(length / kLongest, turn / kMostTurn)), 1.0, kMostPieces));
  const double step = duration / pieces;
  const Vector2d velocity(twist.linear, twist.lateral);
  const auto against = [&](const Vector2d& a, const Vector2d& b) {
    return zones.against({.a = a, .b = b}, reserve.share, reserve.beside).has_value();
  };
  Pose2 from = start;
  for (int i = 1; i <= pieces; ++i) {
    const Pose2 to = moved(start, twist, i * step);
    // The direction turns evenly, so its extremes are at the ends of the piece.
    const Vector2d first = step * rotated(velocity, from.heading);
    const Vector2d last = step * rotated(velocity, to.heading);
    if (against(from.position, from.position + first) || against(to.position - last, to.position))
      return true;
    from = to;
  }
  return false;
}

}  // namespace fairway::internal
