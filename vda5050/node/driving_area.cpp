// SPDX-License-Identifier: Apache-2.0
#include "node/driving_area.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fairway/geometry/pose2.hpp"

namespace fairway::vda5050 {

namespace {

using Point = Eigen::Vector2d;

constexpr double kFastest = 100.0;  // that a zone can have [m/s]

Point left_of(const Point& direction) { return {-direction.y(), direction.x()}; }

// How far a strip extends behind the end at which a robot stops: enough for its tolerance.
double end_extension(const NodeDeviation& deviation) {
  constexpr double kMost = 0.3;  // [m]
  return std::min(reach_of(used_deviation(deviation)), kMost);
}

// The speed limit of a leg, as wide as its strip and a little longer than its line.
void add_speed(const RouteLeg& leg, Zones& area) {
  if (!leg.speed_max) return;
  constexpr double kFreeWidth = 3.0;  // beside a leg without a strip [m]
  constexpr double kLonger = 0.15;    // [m]
  RouteLeg wide = leg;
  wide.strip = leg.strip ? *leg.strip : Strip{.left = kFreeWidth, .right = kFreeWidth};
  wide.strip->contour = false;
  const std::size_t first = area.size();
  add_strip(wide, kLonger, kLonger, area);
  for (std::size_t i = first; i < area.size(); ++i) {
    area[i].kind = ZoneKind::SpeedLimit;
    area[i].speed = std::min(*leg.speed_max, kFastest);
  }
}

bool meets(const vda5050::Zone& zone, const std::vector<Point>& line) {
  constexpr double kNear = 0.3;  // [m]
  for (const Point& point : line) {
    if (distance_to(zone.vertices, point) < kNear) return true;
  }
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point chord = line[i] - line[i - 1];
    const int pieces = static_cast<int>(std::ceil(chord.norm() / kNear));
    for (int k = 1; k < pieces; ++k) {
      if (distance_to(zone.vertices, line[i - 1] + static_cast<double>(k) / pieces * chord) < kNear)
        return true;
    }
  }
  return false;
}

// Zones further away than a robot drives on these legs do not matter to it.
bool is_near(const vda5050::Zone& zone, std::span<const RouteLeg> legs) {
  constexpr double kFar = 15.0;  // [m]
  Point low = Point::Constant(1e9);
  Point high = Point::Constant(-1e9);
  for (const RouteLeg& leg : legs) {
    for (const Point& point : leg.line) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
  }
  Point first = Point::Constant(1e9);
  Point last = Point::Constant(-1e9);
  for (const Point& vertex : zone.vertices) {
    first = first.cwiseMin(vertex);
    last = last.cwiseMax(vertex);
  }
  return (first.array() <= high.array() + kFar).all() && (last.array() >= low.array() - kFar).all();
}

// A line-guided zone is open only to a leg whose trajectory leads through it.
bool closes_line_guided(const vda5050::Zone& zone, std::span<const RouteLeg> legs) {
  if (zone.type != ZoneType::LineGuided) return false;
  bool guided = false;
  for (const RouteLeg& leg : legs) {
    if (!meets(zone, leg.line)) continue;
    if (!leg.line_is_given) return true;
    guided = true;
  }
  return !guided;
}

// The extra cost of a metre for a factor from 0 to 1, which the standard leaves open; at 1 the
// greatest that the search knows.
double weight_of(double factor) {
  constexpr double kMost = 20.0;
  return factor < 1.0 ? std::min(kMost, factor / (1.0 - factor)) : kMost;
}

void add_zone(const vda5050::Zone& zone, bool line_guided_is_closed, Zones& area) {
  fairway::Zone added{.polygon = zone.vertices, .name = zone.id};
  switch (zone.type) {
    case ZoneType::Blocked:
      added.kind = ZoneKind::KeepOut;
      break;
    case ZoneType::LineGuided:
      if (!line_guided_is_closed) return;
      added.kind = ZoneKind::KeepOut;
      break;
    case ZoneType::SpeedLimit:
      added.kind = ZoneKind::SpeedLimit;
      added.speed = std::min(zone.speed_max, kFastest);
      break;
    case ZoneType::Penalty:
      added.kind = ZoneKind::Penalty;
      added.weight = weight_of(zone.factor);
      break;
    case ZoneType::Priority:
      added.kind = ZoneKind::Preferred;
      added.weight = weight_of(zone.factor);
      break;
    case ZoneType::Release:
    case ZoneType::CoordinatedReplanning:
    case ZoneType::Action:
    case ZoneType::Directed:
    case ZoneType::Bidirected:
      return;
  }
  area.push_back(std::move(added));
}

}  // namespace

void add_strip(const RouteLeg& leg, double before, double after, Zones& area) {
  if (!leg.strip) return;
  constexpr double kNarrowest = 0.005;  // of a side that is a polygon at all [m]
  Strip strip = *leg.strip;
  strip.left = std::max(strip.left, kNarrowest);
  strip.right = std::max(strip.right, kNarrowest);
  const auto add = [&](std::vector<Point> polygon) {
    area.push_back({.kind = ZoneKind::Strip,
                    .polygon = std::move(polygon),
                    .reference = strip.contour ? ZoneReference::Contour : ZoneReference::Centre,
                    .name = leg.edge_id});
  };
  const std::vector<Point>& line = leg.line;
  std::optional<Point> previous;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point chord = line[i] - line[i - 1];
    const double length = chord.norm();
    if (!(length > 0.0)) continue;
    const Point along = chord / length;
    const Point left = left_of(along);
    const Point from = line[i - 1] - (previous ? 0.0 : before) * along;
    const Point to = line[i] + (i + 1 == line.size() ? after : 0.0) * along;
    add({from - strip.right * left, to - strip.right * left, to + strip.left * left,
         from + strip.left * left});
    if (previous) {
      // The wedge between two chords, on the outside of the bend.
      const double turn = previous->x() * along.y() - previous->y() * along.x();
      const double width = turn > 0.0 ? -strip.right : strip.left;
      // Without the wedge of a slighter bend the gap is below 1e-6 m.
      constexpr double kLeastArea = 1e-7;  // [m^2]
      if (0.5 * width * width * std::abs(turn) > kLeastArea)
        add({line[i - 1], line[i - 1] + width * left_of(*previous), line[i - 1] + width * left});
    }
    previous = along;
  }
  if (previous) return;
  // A turn on the spot.
  const double half = std::max({strip.left, strip.right, before, after});
  const Point& here = line.front();
  add({here + Point(-half, -half), here + Point(half, -half), here + Point(half, half),
       here + Point(-half, half)});
}

void add_gate(const RouteLeg& leg, const RouteLeg& next, double reach, Zones& area) {
  const std::optional<Point> in = last_direction(leg.line);
  const std::optional<Point> out = first_direction(next.line);
  if (!in || !out) return;
  constexpr double kTurnsBack = 0.5;
  const Point sum = *in + *out;
  if (sum.norm() < kTurnsBack) return;
  const Point along = sum.normalized();
  const Point side = left_of(along);
  const NodeDeviation used = used_deviation(leg.end.deviation);
  // Half the width of the ellipse along the wall.
  const Point local = rotated(side, -used.theta);
  const double half = 1.0 / std::hypot(local.x() / used.a, local.y() / used.b);
  constexpr double kShortest = 0.02;  // [m]
  if (!(reach > half + kShortest)) return;
  constexpr double kThin = 0.01;  // half the thickness of a wall [m]
  const Point& node = leg.end.position;
  for (const double sign : {-1.0, 1.0}) {
    const Point inner = node + sign * half * side;
    const Point outer = node + sign * reach * side;
    area.push_back({.kind = ZoneKind::KeepOut,
                    .polygon = {inner - kThin * along, inner + kThin * along, outer + kThin * along,
                                outer - kThin * along},
                    .reference = ZoneReference::Centre,
                    .name = leg.end_node_id});
  }
}

Zones driving_area(std::span<const RouteLeg> legs, std::span<const vda5050::Zone> zones) {
  Zones area;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const RouteLeg& leg = legs[i];
    const bool last = i + 1 == legs.size();
    const double after =
        last ? end_extension(leg.end.deviation) : reach_of(used_deviation(leg.end.deviation));
    add_strip(leg, reach_of(used_deviation(leg.start.deviation)), after, area);
    add_speed(leg, area);
    if (last || !leg.strip || !legs[i + 1].strip) continue;
    const Strip& a = *leg.strip;
    const Strip& b = *legs[i + 1].strip;
    add_gate(leg, legs[i + 1], 1.5 * std::max({a.left, a.right, b.left, b.right}), area);
  }
  for (const vda5050::Zone& zone : zones) {
    if (!legs.empty() && !is_near(zone, legs)) continue;
    add_zone(zone, closes_line_guided(zone, legs), area);
  }
  return area;
}

}  // namespace fairway::vda5050
