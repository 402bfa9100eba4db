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
std::vector<Vector2d> outline(const Zone& zone, const Footprint& footprint, const Pose2& pose) {
  if (zone.reference == ZoneReference::Centre) return {pose.position};
  std::vector<Vector2d> points;
  if (footprint.is_rectangle()) {
    constexpr int kAlongSide = 16;
    const auto corners = footprint.rectangle_at(pose).corners();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vector2d& next = corners[(i + 1) % corners.size()];
      for (int k = 0; k < kAlongSide; ++k)
        points.emplace_back(corners[i] + k * (next - corners[i]) / kAlongSide);
    }
    return points;
  }
  constexpr int kAround = 64;
  for (int i = 0; i < footprint.num_discs(); ++i) {
    const Footprint::Disc& disc = footprint.disc_at(i);
    for (int k = 0; k < kAround; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / kAround;
      points.push_back(transform(pose, disc.center) + disc.radius * direction(angle));
    }
  }
  return points;
}

// How deep a body is in a polygon; negative outside.
double depth(const Zone& zone,
             const ZonePolygon& polygon,
             const Footprint& footprint,
             const Pose2& pose) {
  double deepest = -std::numeric_limits<double>::infinity();
  for (const Vector2d& point : outline(zone, footprint, pose))
    deepest = std::max(deepest, -polygon.signed_distance(point));
  if (zone.reference == ZoneReference::Centre) return deepest;
  for (const Vector2d& corner : polygon.corners()) {
    if (footprint.distance(inverse_transform(pose, corner)) > 0.0) continue;
    // The corner of the zone is under the body: as far as the body would have to shrink.
    double in = 0.0;
    double out = footprint.circumscribed_radius();
    while (out - in > 1e-6) {
      const double middle = 0.5 * (in + out);
      const bool covers = footprint.shrunk(middle).distance(inverse_transform(pose, corner)) <= 0.0;
      (covers ? in : out) = middle;
    }
    deepest = std::max(deepest, in);
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
                 const Footprint& footprint,
                 const Pose2& pose) {
  double least = std::numeric_limits<double>::infinity();
  for (const ZoneReference reference : {ZoneReference::Contour, ZoneReference::Centre}) {
    double furthest = 0.0;
    for (const Vector2d& point : outline({.reference = reference}, footprint, pose))
      furthest = std::max(furthest, outside(zones, polygons, reference, point));
    least = std::min(least, furthest);
  }
  return std::isfinite(least) ? least : 0.0;
}

}  // namespace

void judge_zones(const Zones& zones,
                 const Footprint& footprint,
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
      breaches.intrusion = std::max(breaches.intrusion, depth(zone, polygons[i], footprint, after));
    } else if (zone.kind == ZoneKind::SpeedLimit && std::abs(speed) > zone.speed) {
      if (depth(zone, polygons[i], footprint, after) >= 0.0)
        breaches.excess = std::max(breaches.excess, std::abs(speed) - zone.speed);
    } else if (zone.kind == ZoneKind::OneWay) {
      const double along = (after.position - before.position).dot(direction(zone.direction));
      if (along < 0.0 && polygons[i].contains(after.position) &&
          polygons[i].contains(before.position)) {
        breaches.against_lanes -= along;
      }
    }
  }
  breaches.excursion = std::max(breaches.excursion, excursion(zones, polygons, footprint, after));
}

}  // namespace fairway
