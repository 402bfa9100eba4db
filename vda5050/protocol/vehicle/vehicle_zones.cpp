// SPDX-License-Identifier: Apache-2.0
// Zones of a vehicle: which of them hold, and the leave to enter those that need it.
#include <algorithm>
#include <cmath>

#include "protocol/vehicle/vehicle.hpp"

namespace fairway::vda5050 {

namespace {

// A line from the place on that is nearest to a point.
std::vector<Eigen::Vector2d> line_beyond(const std::vector<Eigen::Vector2d>& line,
                                         const Eigen::Vector2d& point) {
  const double begin = nearest_on(line, point).arc;
  std::vector<Eigen::Vector2d> beyond;
  double arc = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double length = (line[i] - line[i - 1]).norm();
    if (arc + length >= begin && length > 0.0) {
      if (beyond.empty())
        beyond.push_back(line[i - 1] + (begin - arc) / length * (line[i] - line[i - 1]));
      beyond.push_back(line[i]);
    }
    arc += length;
  }
  return beyond;
}

// Whether a disc that moves along the line touches the zone.
bool sweeps(const std::vector<Eigen::Vector2d>& line, const Zone& zone, double radius) {
  constexpr double kStep = 0.1;  // [m]
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (distance_to(zone.vertices, line[i]) < radius) return true;
    if (i == 0) continue;
    const Eigen::Vector2d chord = line[i] - line[i - 1];
    const int pieces = static_cast<int>(std::ceil(chord.norm() / kStep));
    for (int k = 1; k < pieces; ++k) {
      const Eigen::Vector2d point = line[i - 1] + static_cast<double>(k) / pieces * chord;
      if (distance_to(zone.vertices, point) < radius) return true;
    }
  }
  return false;
}

}  // namespace

bool Vehicle::is_inside(const Zone& zone) const {
  return has_motion_ && motion_.localized &&
         distance_to(zone.vertices, motion_.pose.position) < body_;
}

// Whether a released edge beyond the present one leads through the zone.
bool Vehicle::leads_through(const Zone& zone) const {
  const std::size_t released = std::min(order_.released_nodes(), order_.legs.size());
  for (std::size_t i = 1; i < released; ++i) {
    if (sweeps(order_.legs[i].line, zone, body_)) return true;
  }
  return false;
}

// The present edge from the vehicle on; empty unless it is released.
std::vector<Eigen::Vector2d> Vehicle::line_ahead() const {
  if (order_.legs.empty() || order_.released_nodes() == 0) return {};
  return line_beyond(order_.legs.front().line, motion_.pose.position);
}

std::vector<Zone> Vehicle::zones_with_leave() const {
  std::vector<Zone> zones = zones_;
  std::erase_if(zones, [](const Zone& zone) { return zone.type == ZoneType::Release; });
  return zones;
}

// A zone that needs leave is closed without it. A vehicle inside goes on if the zone says so.
bool Vehicle::is_closed(const Zone& zone) const {
  if (zone.type != ZoneType::Release || zone_leave_.granted(zone.id)) return false;
  return !is_inside(zone);
}

void Vehicle::refresh_zones() {
  std::vector<Zone> in_force;
  for (const Zone& zone : zones_) {
    if (zone.type != ZoneType::Release || is_closed(zone)) in_force.push_back(zone);
  }
  const auto same = [](const Zone& a, const Zone& b) { return a.id == b.id; };
  if (std::equal(in_force.begin(), in_force.end(), in_force_.begin(), in_force_.end(), same))
    return;
  in_force_ = std::move(in_force);
  rebuild_route();
}

void Vehicle::use_zones(std::vector<Zone> zones) {
  zones_ = std::move(zones);
  zone_leave_.clear();
  in_force_.clear();
  rebuild_route();
  refresh_zones();
}

// Which zones lie on later edges of the base; found again only when either has changed.
void Vehicle::find_zones_ahead() {
  if (zone_route_ == route_revision_ && zone_legs_ == legs_passed_) return;
  zone_route_ = route_revision_;
  zone_legs_ = legs_passed_;
  zones_ahead_.clear();
  for (const Zone& zone : zones_) {
    if (zone.type == ZoneType::Release && leads_through(zone)) zones_ahead_.insert(zone.id);
  }
}

// Requests leave for zones on the base, and removes the requests of zones that were left.
void Vehicle::update_zone_leave() {
  find_zones_ahead();
  const std::vector<Eigen::Vector2d> line =
      cancelling_ ? std::vector<Eigen::Vector2d>() : line_ahead();
  const Zone* lost = nullptr;
  zone_holds_ = false;
  waits_for_zone_ = false;
  for (const Zone& zone : zones_) {
    if (zone.type != ZoneType::Release) continue;
    const bool inside = is_inside(zone);
    const bool ahead =
        !cancelling_ && (zones_ahead_.contains(zone.id) || sweeps(line, zone, body_));
    const bool has_changed =
        inside || ahead ? zone_leave_.request(zone.set_id + "/" + zone.id, zone.id, zone.set_id)
                        : zone_leave_.finish(zone.id);
    if (has_changed) changed_ = true;
    const bool granted = zone_leave_.granted(zone.id);
    const bool ended = zone_leave_.lost(zone.id);
    if (inside && ended) lost = &zone;
    if (inside && !granted && !(ended && zone.goes_on_without_leave)) zone_holds_ = true;
    if (ahead && !granted) waits_for_zone_ = true;
  }
  const std::string id = lost != nullptr ? lost->id : std::string();
  set_condition(Fault::ZoneLeaveLost, lost != nullptr,
                "the leave for the zone \"" + id + "\" has ended while the vehicle is inside",
                {{.key = "zoneId", .value = id}});
  refresh_zones();
}

}  // namespace fairway::vda5050
