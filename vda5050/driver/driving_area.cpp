// SPDX-License-Identifier: Apache-2.0
#include "driver/driving_area.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "driver/leg_strips.hpp"
#include "fairway/geometry/pose2.hpp"

namespace fairway::vda5050 {

namespace {

using Point = Eigen::Vector2d;

constexpr double kFastest = 100.0;  // that a zone can have [m/s]

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

// Whether all legs that lead through a zone are trajectories, and one does.
bool has_line(const vda5050::Zone& zone, std::span<const RouteLeg> legs) {
  bool guided = false;
  for (const RouteLeg& leg : legs) {
    if (!meets(zone, leg.line)) continue;
    if (!leg.line_is_given) return false;
    guided = true;
  }
  return guided;
}

// The extra cost of a metre for a factor from 0 to 1, which the standard leaves open; at 1 the
// greatest that the search knows.
double weight_of(double factor) {
  constexpr double kMost = 20.0;
  return factor < 1.0 ? std::min(kMost, factor / (1.0 - factor)) : kMost;
}

// Whether the centre of the robot keeps out of a zone on these lines.
bool is_avoided(const vda5050::Zone& zone, std::span<const RouteLeg> legs) {
  return std::none_of(legs.begin(), legs.end(), [&](const RouteLeg& leg) {
    const auto line = with_short_chords(leg.line);
    return std::any_of(line.begin(), line.end(), [&](const Point& point) {
      return distance_to(zone.vertices, point) <= 0.0;
    });
  });
}

// Whether a leg leads through a zone against its direction.
bool is_driven_against(const vda5050::Zone& zone, std::span<const RouteLeg> legs) {
  constexpr double kAcross = 1e-3;  // against a direction, of a line square to it
  const Point along = direction(zone.direction);
  for (const RouteLeg& leg : legs) {
    const auto line = with_short_chords(leg.line);
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Point chord = line[i] - line[i - 1];
      const Point middle = 0.5 * (line[i] + line[i - 1]);
      if (chord.dot(along) < -kAcross * chord.norm() && distance_to(zone.vertices, middle) <= 0.0)
        return true;
    }
  }
  return false;
}

void add_zone(const vda5050::Zone& zone, bool along_line, Zones& area) {
  fairway::Zone added{.polygon = zone.vertices, .name = zone.id};
  switch (zone.type) {
    case ZoneType::Blocked:
    case ZoneType::Release:  // without leave
      added.kind = ZoneKind::KeepOut;
      break;
    case ZoneType::LineGuided:
      if (along_line) return;
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
    case ZoneType::Directed:
      // A trajectory has precedence over the direction.
      if (along_line || zone.direction_limit == DirectionLimit::Soft) return;
      if (zone.direction_limit == DirectionLimit::Restricted) {
        added.kind = ZoneKind::OneWay;
        added.direction = std::remainder(zone.direction, 2.0 * std::numbers::pi);
      }
      break;
    case ZoneType::CoordinatedReplanning:
    case ZoneType::Action:
    case ZoneType::Bidirected:
      return;
  }
  area.push_back(std::move(added));
}

}  // namespace

Zones strips_behind(const RouteLeg& leg, const RouteLeg& next, double reach, double body) {
  Zones strips =
      strips_of(leg, std::nullopt, joint_of(leg, next, body), end_extension(leg.end.deviation));
  keep_near(leg.end.position, reach, body, strips);
  return strips;
}

Zones driving_area(std::span<const RouteLeg> legs,
                   std::span<const vda5050::Zone> zones,
                   double body,
                   const Zones& behind,
                   Penalties penalties) {
  Zones area = behind;
  const auto joints = joints_of(legs, nullptr, body);
  Zones before;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const RouteLeg& leg = legs[i];
    const bool last = i + 1 == legs.size();
    const double after =
        last ? end_extension(leg.end.deviation) : reach_of(used_deviation(leg.end.deviation));
    Zones strips = strips_of(leg, joints[i], joints[i + 1], after);
    area.insert(area.end(), strips.begin(), strips.end());
    add_speed(leg, area);
    if (joints[i]) add_gate(legs[i - 1], *joints[i], before, strips, area);
    before = std::move(strips);
  }
  for (const vda5050::Zone& zone : zones) {
    if (!legs.empty() && !is_near(zone, legs)) continue;
    const std::size_t before_zone = area.size();
    add_zone(zone, has_line(zone, legs), area);
    if (area.size() == before_zone) continue;
    fairway::Zone& added = area.back();
    const bool is_lane = added.kind == ZoneKind::OneWay && !legs.empty();
    const bool is_costly = zone.type == ZoneType::Penalty && penalties == Penalties::AreAvoided;
    if (!is_lane && !is_costly) continue;
    // The legs are known: a zone that they avoid, or would have to enter against its direction, is
    // closed, so that nothing beside the path leads into it.
    if (!is_avoided(zone, legs) && !(is_lane && is_driven_against(zone, legs))) continue;
    added.kind = ZoneKind::KeepOut;
    added.reference = ZoneReference::Centre;
    added.weight = 0.0;
  }
  return area;
}

CellWindow cells_of_area(const GridFrame& map,
                         const Zones& area,
                         const std::optional<Point>& robot,
                         double body) {
  CellWindow window = kNoCells;
  // Further away than this, cells change neither a path nor a stop.
  const double cells = (3.0 * body + 2.0) / map.resolution;
  const auto add = [&](const Point& point) {
    const Point at = map.to_grid(point);
    const auto index = [](double v) { return static_cast<int>(std::clamp(v, -1e6, 1e6)); };
    window = united(window, {.first = {.x = index(at.x() - cells), .y = index(at.y() - cells)},
                             .last = {.x = index(at.x() + cells), .y = index(at.y() + cells)}});
  };
  for (const fairway::Zone& zone : area) {
    if (zone.kind == ZoneKind::Strip) std::for_each(zone.polygon.begin(), zone.polygon.end(), add);
  }
  if (is_empty(window)) return all_cells(map);
  if (robot) add(*robot);
  return window;
}

}  // namespace fairway::vda5050
