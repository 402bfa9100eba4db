// SPDX-License-Identifier: Apache-2.0
#include "fairway/zones/zone_map.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "fairway/geometry/pose2.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr std::size_t kContour = static_cast<std::size_t>(ZoneReference::Contour);
constexpr std::size_t kCentre = static_cast<std::size_t>(ZoneReference::Centre);

}  // namespace

ZoneMap::ZoneMap(Zones zones, double radius) : zones_(std::move(zones)), radius_(radius) {
  for (std::size_t i = 0; i < zones_.size(); ++i)
    take(zones_[i], i);
  for (ZoneBoundary& boundary : keep_outs_)
    boundary.close();
  for (ZoneBoundary& boundary : strips_)
    boundary.close();
  double penalty = 0.0;
  for (const CostRegion& region : costs_) {
    double& greatest = region.preferred ? preferred_weight_ : penalty;
    greatest = std::max(greatest, region.weight);
  }
  greatest_cost_ = penalty + preferred_weight_;
  has_strips_ = !strips_[kContour].empty() || !strips_[kCentre].empty();
  forbids_ = has_strips_ || !keep_outs_[kContour].empty() || !keep_outs_[kCentre].empty();
  if (has_mixed_strips()) return;
  for (const auto* boundaries : {&keep_outs_, &strips_}) {
    for (const std::size_t kind : {kContour, kCentre}) {
      if (!(*boundaries)[kind].empty())
        fences_.push_back(
            {.boundary = &(*boundaries)[kind], .less = kind == kCentre ? radius_ : 0.0});
    }
  }
}

void ZoneMap::take(const Zone& zone, std::size_t index) {
  ZonePolygon polygon(zone.polygon);
  switch (zone.kind) {
    case ZoneKind::KeepOut:
      keep_outs_[static_cast<std::size_t>(zone.reference)].add(std::move(polygon), index);
      break;
    case ZoneKind::Strip:
      strips_[static_cast<std::size_t>(zone.reference)].add(std::move(polygon), index);
      break;
    case ZoneKind::SpeedLimit:
      speeds_.push_back({.polygon = std::move(polygon),
                         .speed = zone.speed,
                         .contour = zone.reference == ZoneReference::Contour,
                         .zone = index});
      break;
    case ZoneKind::Penalty:
    case ZoneKind::Preferred:
      costs_.push_back({.polygon = std::move(polygon),
                        .weight = zone.weight,
                        .preferred = zone.kind == ZoneKind::Preferred});
      break;
    case ZoneKind::OneWay:
      lanes_.push_back({.polygon = std::move(polygon),
                        .direction = fairway::direction(zone.direction),
                        .zone = index});
      break;
  }
}

// A region that keeps clear of the boundary lies wholly on one side of it.
std::optional<std::size_t> ZoneMap::leaving(const ZoneBoundary& strips,
                                            const OrientedRectangle& region,
                                            const Extent& extent,
                                            double clearance) const noexcept {
  if (const auto zone = strips.piece_near(region, extent, clearance)) return zone;
  if (strips.contains(region.center())) return std::nullopt;
  // Far outside of all strips, the first one represents them.
  return strips.pieces().empty() ? 0 : strips.pieces().front().zone;
}

std::optional<std::size_t> ZoneMap::forbidding(const OrientedRectangle& region,
                                               double clearance,
                                               ZoneSubject subject,
                                               double body_radius) const noexcept {
  if (!forbids_) return std::nullopt;
  const Extent extent = extent_of(region);
  const double centre_clearance =
      subject == ZoneSubject::Disc ? std::max(0.0, clearance - radius_) : clearance;
  const auto entering = [&](std::size_t kind, double keep) -> std::optional<std::size_t> {
    if (keep_outs_[kind].empty()) return std::nullopt;
    if (const auto zone = keep_outs_[kind].piece_near(region, extent, keep)) return zone;
    return keep_outs_[kind].polygon_at(region.center());
  };
  if (subject != ZoneSubject::Centre) {
    if (const auto zone = entering(kContour, clearance)) return zone;
  }
  if (subject != ZoneSubject::Body) {
    if (const auto zone = entering(kCentre, centre_clearance)) return zone;
  }
  if (!has_strips_) return std::nullopt;
  const bool mixed = has_mixed_strips();
  if (strips_[kCentre].empty()) {
    if (subject == ZoneSubject::Centre) return std::nullopt;
    return leaving(strips_[kContour], region, extent, clearance);
  }
  if (subject == ZoneSubject::Body) return std::nullopt;
  const auto centre = leaving(strips_[kCentre], region, extent, centre_clearance);
  if (!mixed || !centre) return centre;
  const double whole = subject == ZoneSubject::Centre ? clearance + body_radius : clearance;
  return leaving(strips_[kContour], region, extent, whole) ? centre : std::nullopt;
}

double ZoneMap::clearance_at(const Vector2d& point,
                             double limit,
                             ZoneSubject subject) const noexcept {
  if (!forbids_) return limit;
  const bool body = subject == ZoneSubject::Body;
  double least = limit;
  for (const std::size_t kind : {kContour, kCentre}) {
    const ZoneBoundary& keep_out = keep_outs_[kind];
    if (keep_out.empty() || (body && kind == kCentre)) continue;
    if (keep_out.contains(point)) return 0.0;
    const double more = kind == kCentre ? radius_ : 0.0;
    least = std::min(least, keep_out.distance_to(point, limit) + more);
  }
  if (!has_strips_ || (body && !strips_[kCentre].empty())) return least;
  double inside = 0.0;
  for (const std::size_t kind : {kContour, kCentre}) {
    if (strips_[kind].empty() || !strips_[kind].contains(point)) continue;
    const double more = kind == kCentre ? radius_ : 0.0;
    inside = std::max(inside, strips_[kind].distance_to(point, limit) + more);
  }
  return std::min(least, inside);
}

double ZoneMap::excursion(const Vector2d& point) const noexcept {
  const ZoneBoundary& strips = strips_[kCentre];
  if (strips.empty() || strips.contains(point)) return 0.0;
  return strips.distance_to(point, std::numeric_limits<double>::infinity());
}

double ZoneMap::cost_at(const Vector2d& point) const noexcept {
  double penalty = 0.0;
  bool preferred = false;
  for (const CostRegion& region : costs_) {
    if (region.preferred ? preferred : region.weight <= penalty) continue;
    if (!region.polygon.extent().near({.low = point, .high = point}, 0.0) ||
        !region.polygon.contains(point)) {
      continue;
    }
    if (region.preferred) {
      preferred = true;
    } else {
      penalty = region.weight;
    }
  }
  return penalty + (preferred ? 0.0 : preferred_weight_);
}

// Between two crossings with edges of regions the cost is constant.
double ZoneMap::cost_along(const Segment& line) const noexcept {
  if (costs_.empty()) return 0.0;
  const Vector2d along = line.b - line.a;
  constexpr std::size_t kMost = 126;     // crossings; more are left out, which only changes a cost
  std::array<double, kMost + 2> shares;  // NOLINT(*-member-init)
  std::size_t count = 0;
  shares[count++] = 0.0;
  const Extent extent = extent_of(line);
  for (const CostRegion& region : costs_) {
    if (!region.polygon.extent().near(extent, 0.0)) continue;
    for (std::size_t i = 0; i < region.polygon.size() && count <= kMost; ++i) {
      if (const std::optional<double> share = crossing(line, region.polygon.edge(i)))
        shares[count++] = *share;
    }
  }
  shares[count++] = 1.0;
  std::sort(shares.begin(), shares.begin() + static_cast<std::ptrdiff_t>(count));
  double sum = 0.0;
  for (std::size_t i = 1; i < count; ++i) {
    const double part = shares[i] - shares[i - 1];
    if (part > 0.0) sum += part * cost_at(line.a + 0.5 * (shares[i - 1] + shares[i]) * along);
  }
  return sum * along.norm();
}

std::optional<std::size_t> ZoneMap::against(const Segment& motion,
                                            double least_share,
                                            double beside) const noexcept {
  constexpr double kNothing = 1e-9;  // [m]; rounding
  const Vector2d along = motion.b - motion.a;
  const double least = least_share * along.norm() - kNothing;
  for (const Lane& lane : lanes_) {
    if (along.dot(lane.direction) >= least) continue;
    if (lane.polygon.extent().near(extent_of(motion), beside) &&
        lane.polygon.is_near(segment_rectangle(motion.a, motion.b), beside)) {
      return lane.zone;
    }
  }
  return std::nullopt;
}

ZoneSpeed ZoneMap::speed_in(const OrientedRectangle& region, double body_radius) const noexcept {
  ZoneSpeed least;
  for (const SpeedRegion& limit : speeds_) {
    if (limit.speed >= least.speed) continue;
    if (limit.polygon.is_near(region, limit.contour ? body_radius : 0.0))
      least = {.speed = limit.speed, .zone = limit.zone};
  }
  return least;
}

}  // namespace fairway
