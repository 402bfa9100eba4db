// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/judges/zone_judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "fairway/zones/zone_polygon.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

// Points on the outline of the body that a zone is asked about, or its centre.
std::vector<Vector2d> outline(const Zone& zone, const BodyShape& body, const Pose2& pose) {
  if (zone.reference == ZoneReference::Centre) return {pose.position};
  constexpr int kAlongSide = 16;
  constexpr int kAround = 64;
  std::vector<Vector2d> points;
  for (const ConvexPart& part : body.parts()) {
    for (int i = 0; i < part.count; ++i) {
      const Vector2d corner = transform(pose, part.vertex(i));
      if (part.radius > 0.0) {
        for (int k = 0; k < kAround; ++k)
          points.push_back(corner + part.radius * direction(2.0 * std::numbers::pi * k / kAround));
        continue;
      }
      const Vector2d next = transform(pose, part.vertex((i + 1) % part.count));
      for (int k = 0; k < kAlongSide; ++k)
        points.emplace_back(corner + k * (next - corner) / kAlongSide);
    }
  }
  return points;
}

// How deep a point of the body's frame lies in a part of it; negative outside.
double depth_in(const ConvexPart& part, const Vector2d& point) {
  if (part.count == 1) return part.radius - (point - part.vertex(0)).norm();
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < part.count; ++i) {
    const Vector2d& a = part.vertex(i);
    const Vector2d along = (part.vertex((i + 1) % part.count) - a).normalized();
    const Vector2d to = point - a;
    least = std::min(least, along.x() * to.y() - along.y() * to.x());
  }
  return part.radius + least;
}

// How deep a body is in a polygon; negative outside.
double depth(const Zone& zone,
             const ZonePolygon& polygon,
             const BodyShape& body,
             const Pose2& pose) {
  double deepest = -std::numeric_limits<double>::infinity();
  for (const Vector2d& point : outline(zone, body, pose))
    deepest = std::max(deepest, -polygon.signed_distance(point));
  if (zone.reference == ZoneReference::Centre) return deepest;
  // A corner of the zone may be under the body: as far as the body would have to shrink.
  for (const Vector2d& corner : polygon.corners()) {
    const Vector2d local = inverse_transform(pose, corner);
    if (body.distance(local) > 0.0) continue;
    for (const ConvexPart& part : body.parts())
      deepest = std::max(deepest, depth_in(part, local));
  }
  return deepest;
}

// How far a point is out of all strips of a kind; infinite without any.
double outside(const Zones& zones,
               const std::vector<ZonePolygon>& polygons,
               ZoneReference reference,
               const Vector2d& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < zones.size(); ++i) {
    if (zones[i].kind == ZoneKind::Strip && zones[i].reference == reference)
      least = std::min(least, polygons[i].signed_distance(point));
  }
  return std::max(0.0, least);
}

double excursion(const Zones& zones,
                 const std::vector<ZonePolygon>& polygons,
                 const BodyShape& body,
                 const Pose2& pose) {
  double least = std::numeric_limits<double>::infinity();
  for (const ZoneReference reference : {ZoneReference::Contour, ZoneReference::Centre}) {
    double furthest = 0.0;
    for (const Vector2d& point : outline({.reference = reference}, body, pose))
      furthest = std::max(furthest, outside(zones, polygons, reference, point));
    least = std::min(least, furthest);
  }
  return std::isfinite(least) ? least : 0.0;
}

}  // namespace

void judge_zones(const Zones& zones,
                 const BodyShape& body,
                 const Pose2& before,
                 const Pose2& after,
                 double speed,
                 ZoneBreaches& breaches) {
  if (zones.empty()) return;
  std::vector<ZonePolygon> polygons;
  polygons.reserve(zones.size());
  for (const Zone& zone : zones)
    polygons.emplace_back(zone.polygon);
  for (std::size_t i = 0; i < zones.size(); ++i) {
    const Zone& zone = zones[i];
    if (zone.kind == ZoneKind::KeepOut) {
      breaches.intrusion = std::max(breaches.intrusion, depth(zone, polygons[i], body, after));
    } else if (zone.kind == ZoneKind::SpeedLimit && std::abs(speed) > zone.speed) {
      if (depth(zone, polygons[i], body, after) >= 0.0)
        breaches.excess = std::max(breaches.excess, std::abs(speed) - zone.speed);
    } else if (zone.kind == ZoneKind::OneWay) {
      const double along = (after.position - before.position).dot(direction(zone.direction));
      if (along < 0.0 && polygons[i].contains(after.position) &&
          polygons[i].contains(before.position)) {
        breaches.against_lanes -= along;
      }
    }
  }
  breaches.excursion = std::max(breaches.excursion, excursion(zones, polygons, body, after));
}

}  // namespace fairway
