// SPDX-License-Identifier: Apache-2.0
#include "protocol/messages/zone_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace fairway::vda5050 {

namespace {

using Polygon = std::vector<Eigen::Vector2d>;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double distance_to_segment(const Eigen::Vector2d& a,
                           const Eigen::Vector2d& b,
                           const Eigen::Vector2d& p) {
  const Eigen::Vector2d line = b - a;
  const double squared = line.squaredNorm();
  const double share = squared > 0.0 ? std::clamp((p - a).dot(line) / squared, 0.0, 1.0) : 0.0;
  return (a + share * line - p).norm();
}

bool segments_touch(const Eigen::Vector2d& a,
                    const Eigen::Vector2d& b,
                    const Eigen::Vector2d& c,
                    const Eigen::Vector2d& d) {
  const double c_side = cross(b - a, c - a);
  const double d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c);
  const double b_side = cross(d - c, b - c);
  if (c_side * d_side < 0.0 && a_side * b_side < 0.0) return true;
  constexpr double kTouch = 1e-9;  // [m]
  return distance_to_segment(a, b, c) < kTouch || distance_to_segment(a, b, d) < kTouch ||
         distance_to_segment(c, d, a) < kTouch || distance_to_segment(c, d, b) < kTouch;
}

void check_type(FieldReader& reader, Zone& zone) {
  static constexpr std::array<const char*, 3> kLosses{"STOP", "CONTINUE", "EVACUATE"};
  static constexpr std::array<const char*, 3> kDirected{"SOFT", "RESTRICTED", "STRICT"};
  static constexpr std::array<const char*, 2> kBidirected{"SOFT", "RESTRICTED"};
  const FieldRange share{.low = 0.0, .high = 1.0};
  switch (zone.type) {
    case ZoneType::SpeedLimit:
      zone.speed_max = reader.number("maximumSpeed");
      if (!(zone.speed_max > 0.0)) reader.complain("maximumSpeed", "expected a number above 0");
      break;
    case ZoneType::Priority:
      zone.factor = reader.number("priorityFactor", share);
      break;
    case ZoneType::Penalty:
      zone.factor = reader.number("penaltyFactor", share);
      break;
    case ZoneType::Release:
      zone.goes_on_without_leave = reader.word("releaseLossBehavior", kLosses) > 0;
      break;
    case ZoneType::Action:
      for (const char* list : {"entryActions", "duringActions", "exitActions"})
        (void)reader.objects(list);
      break;
    case ZoneType::Directed:
      zone.direction = reader.number("direction");
      zone.direction_limit =
          static_cast<DirectionLimit>(reader.word("directedLimitation", kDirected));
      break;
    case ZoneType::Bidirected:
      (void)reader.number("direction");
      (void)reader.word("bidirectedLimitation", kBidirected);
      break;
    case ZoneType::Blocked:
    case ZoneType::LineGuided:
    case ZoneType::CoordinatedReplanning:
      break;
  }
}

Zone read_zone(FieldReader& reader) {
  constexpr double kMost = 1e7;  // [m]
  Zone zone;
  zone.id = reader.text("zoneId");
  zone.type = static_cast<ZoneType>(reader.word("zoneType", kZoneTypeNames));
  for (FieldReader& vertex : reader.objects("vertices")) {
    const FieldRange range{.low = -kMost, .high = kMost};
    zone.vertices.emplace_back(vertex.number("x", range), vertex.number("y", range));
  }
  if (zone.vertices.size() < 3) {
    reader.complain("vertices",
                    "expected at least 3 vertices, found " + std::to_string(zone.vertices.size()));
    return zone;
  }
  if (zone.vertices.front() == zone.vertices.back() && zone.vertices.size() > 3)
    zone.vertices.pop_back();
  if (!is_simple(zone.vertices))
    reader.complain("vertices", "expected a polygon that does not cross itself");
  if (signed_area(zone.vertices) < 0.0) std::reverse(zone.vertices.begin(), zone.vertices.end());
  check_type(reader, zone);
  return zone;
}

}  // namespace

double signed_area(const Polygon& polygon) {
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sum += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return 0.5 * sum;
}

bool is_simple(const Polygon& polygon) {
  constexpr double kLeastArea = 1e-6;  // [m^2]
  const std::size_t n = polygon.size();
  if (n < 3 || std::abs(signed_area(polygon)) < kLeastArea) return false;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const bool adjacent = j == i + 1 || (i == 0 && j == n - 1);
      if (adjacent) continue;
      if (segments_touch(polygon[i], polygon[(i + 1) % n], polygon[j], polygon[(j + 1) % n]))
        return false;
    }
  }
  return true;
}

bool contains(const Polygon& polygon, const Eigen::Vector2d& point) {
  return distance_to(polygon, point) <= 0.0;
}

double distance_to(const Polygon& polygon, const Eigen::Vector2d& point) {
  bool inside = false;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    least = std::min(least, distance_to_segment(a, b, point));
    if ((a.y() > point.y()) != (b.y() > point.y()) &&
        point.x() < a.x() + (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y())) {
      inside = !inside;
    }
  }
  return inside ? 0.0 : least;
}

ZoneSet read_zone_set(FieldReader& reader) {
  ZoneSet set;
  if (!reader.has("zoneSet")) reader.complain("zoneSet", "expected an object, found nothing");
  FieldReader body = reader.object("zoneSet");
  set.id = body.text("zoneSetId");
  set.map_id = body.text("mapId");
  std::set<std::string> ids;
  for (FieldReader& zone : body.objects("zones")) {
    set.zones.push_back(read_zone(zone));
    set.zones.back().set_id = set.id;
    if (!ids.insert(set.zones.back().id).second)
      zone.complain("zoneId",
                    "expected ids that differ, found \"" + set.zones.back().id + "\" again");
  }
  return set;
}

}  // namespace fairway::vda5050
