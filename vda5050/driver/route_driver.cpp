// SPDX-License-Identifier: Apache-2.0
#include "driver/route_driver.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "driver/approach.hpp"
#include "driver/leg_strips.hpp"
#include "driver/legs_apart.hpp"
#include "fairway/geometry/angle.hpp"
#include "fairway/zones/zone_map.hpp"
#include "protocol/orders/node_passing.hpp"

namespace fairway::vda5050 {

namespace {

constexpr double kWindow = 12.0;    // length of legs that the navigator knows [m]
constexpr double kRefresh = 5.0;    // length left at which it gets more [m]
constexpr double kAtNode = 0.3;     // from a node at which the robot has stopped [m]
constexpr double kFreeWidth = 1.0;  // of the strip around a path that the robot chose [m]
constexpr double kRetry = 1.0;      // between attempts while a leg is closed [s]

// The legs from `first` on whose length is about that of a window.
std::vector<RouteLeg> legs_from(const Route& route, std::size_t first, double length) {
  std::vector<RouteLeg> legs;
  for (std::size_t i = first; i < route.legs.size(); ++i) {
    legs.push_back(route.legs[i]);
    length += length_of(route.legs[i].line);
    if (length > kWindow && legs.size() > 1) break;
  }
  return legs;
}

}  // namespace

RouteDriver::RouteDriver(const Settings& settings, const BitGrid& map)
    : settings_(settings),
      map_(map),
      navigator_(settings) {
  navigator_.set_map(map_);
}

void RouteDriver::restart() {
  window_.reset();
  driving_ = false;
  navigator_.cancel();
  navigator_.reset();
}

Twist2 RouteDriver::brake(const Measurements& measurements) {
  window_.reset();
  driving_ = false;
  navigator_.cancel();
  return navigator_.update(measurements).command;
}

// Gives legs without a line of their own the path that the robot chooses. Returns the first leg to
// which there is none; it keeps its straight line.
std::optional<std::size_t> RouteDriver::choose_free_lines(std::vector<RouteLeg>& legs,
                                                          const Eigen::Vector2d& robot,
                                                          const std::vector<vda5050::Zone>& zones) {
  const PlannerSettings planner = planner_settings(settings_);
  std::optional<PreparedMap> open;
  std::optional<std::size_t> without;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    RouteLeg& leg = legs[i];
    if (leg.strip) continue;
    const Eigen::Vector2d from = i == 0 ? robot : leg.start.position;
    leg.strip = Strip{.left = kFreeWidth, .right = kFreeWidth};
    constexpr double kSpot = 0.01;                           // [m]
    if ((leg.end.position - from).norm() < kSpot) continue;  // a turn on the spot
    if (!open) {
      std::optional<BitGrid> map = map_with(driving_area({}, zones, settings_.robot.radius));
      if (!map) return i;
      open.emplace(*std::move(map));
    }
    const auto path = free_path(*open, from, leg.end.position, planner, planner_);
    if (path) leg.line = *path;
    if (!path && !without) without = i;
  }
  return without;
}

std::optional<BitGrid> RouteDriver::map_with(Zones zones) const {
  if (!validate(zones)) return std::nullopt;
  const double body = settings_.robot.radius;
  BitGrid map = map_.part(cells_of_area(map_.frame(), zones, std::nullopt, body));
  if (!zones.empty()) map.set_zones(std::make_shared<const ZoneMap>(std::move(zones), body));
  return map;
}

// A long order is checked in windows, as it is driven. Neighbours share a leg, so that the joint
// between them is checked too, except where the robot stops.
std::optional<std::size_t> RouteDriver::first_closed(const Route& route,
                                                     const std::vector<vda5050::Zone>& zones) {
  const double body = settings_.robot.radius;
  std::size_t first = 0;
  while (first < route.legs.size()) {
    std::vector<RouteLeg> legs = legs_from(route, first, 0.0);
    for (std::size_t i = 1; i < legs.size(); ++i) {
      if (needs_stop(legs[i - 1], legs[i])) legs.resize(i);
    }
    if (const auto leg = choose_free_lines(legs, legs.front().start.position, zones))
      return first + *leg;
    Zones behind;
    if (first > 0) behind = strips_behind(route.legs[first - 1], legs.front(), kAtNode, body);
    legs = legs_apart(legs, behind, body).legs;
    const std::optional<BitGrid> map = map_with(driving_area(legs, zones, body, behind));
    if (!map) return first;
    const LegPath path =
        path_along(*map, legs, std::nullopt, planner_settings(settings_), planner_);
    if (path.closed_leg) return first + *path.closed_leg;
    const std::size_t end = first + legs.size();
    const bool stops = end == route.legs.size() || needs_stop(route.legs[end - 1], route.legs[end]);
    first = stops || legs.size() == 1 ? end : end - 1;
  }
  return std::nullopt;
}

bool RouteDriver::needs_window(const Vehicle& vehicle, const Measurements& m) const {
  if (!driving_ || !window_ || window_->route != vehicle.route_revision()) return true;
  const bool waited = m.time - window_time_ >= kRetry;
  if (closed_time_ >= 0.0) return waited;
  if (navigator_.plan_is_current() && !navigator_.plan().usable()) return waited;
  if (window_->whole || window_->closed_leg) return false;
  if (window_->cut && vehicle.legs_passed() == window_->first) return false;
  const LinePoint near = nearest_on(window_->path, m.pose.position);
  return length_of(window_->path) - near.arc < kRefresh;
}

LegPath RouteDriver::window_path(const std::vector<RouteLeg>& legs, const Eigen::Vector2d& robot) {
  const PlannerSettings planner = planner_settings(settings_);
  const BitGrid& map = *navigator_.obstacles();
  if (!legs.front().returns) return path_along(map, legs, robot, planner, planner_);
  return {.points = path_back(map, legs.front(), robot, planner, planner_), .closed_leg = 0};
}

// The strips beside those of the present leg in which the robot may be.
Zones RouteDriver::strips_around(const RouteLeg& leg, const Eigen::Vector2d& robot) const {
  const double body = settings_.robot.radius;
  if (!last_leg_) {
    const auto approach = approach_to(leg, robot);
    return approach ? strips_of(*approach, std::nullopt, std::nullopt, kAtNode) : Zones{};
  }
  if (!last_leg_->strip) return {};
  constexpr double kSlack = 0.1;  // [m]
  const bool inside = outside_by(leg, robot, body) <= 0.0;
  const double here = (robot - last_leg_->end.position).norm();
  const double reach = inside ? kAtNode : std::max(kAtNode, here + kSlack);
  return strips_behind(*last_leg_, leg, reach, body);
}

void RouteDriver::open_window(const Vehicle& vehicle, const Measurements& m) {
  const Route& route = vehicle.route();
  const Eigen::Vector2d& robot = m.pose.position;
  Window window{.route = vehicle.route_revision(), .first = vehicle.legs_passed()};
  std::vector<RouteLeg> legs =
      legs_from(route, window.first, -nearest_on(route.legs[window.first].line, robot).arc);
  (void)choose_free_lines(legs, robot, vehicle.zones());
  const double body = settings_.robot.radius;
  const Zones behind = strips_around(legs.front(), robot);
  LegsApart apart = legs_apart(legs, behind, body);
  window.cut = apart.cut;
  window.stop = apart.stop;
  legs = std::move(apart.legs);
  window.count = legs.size();
  window.whole = !window.cut && window.first + window.count == route.legs.size();
  LegPath path{.closed_leg = 0};
  for (const Penalties penalties : {Penalties::AreAvoided, Penalties::AreCosts}) {
    if (penalties == Penalties::AreAvoided && closed_time_ >= 0.0) continue;
    const Zones area = driving_area(legs, vehicle.zones(), body, behind, penalties);
    if (!validate(area)) continue;
    navigator_.set_map(map_.part(cells_of_area(map_.frame(), area, robot, body)));
    navigator_.set_zones(area);
    path = window_path(legs, robot);
    if (!path.closed_leg) break;
  }
  if (path.closed_leg) window.closed_leg = window.first + *path.closed_leg;
  if (!path.points.empty()) window.path = with_short_chords(path.points);
  follow(vehicle, std::move(window), legs);
  window_time_ = m.time;
}

void RouteDriver::follow(const Vehicle& vehicle, Window window, const std::vector<RouteLeg>& legs) {
  if (window.path.empty()) {
    navigator_.cancel();
  } else {
    const bool to_end = window.whole && !window.closed_leg;
    const bool stops = to_end || (window.stop && !window.closed_leg);
    Settings now = navigator_.settings();
    const NodePosition& end = legs.back().end;
    constexpr double kShare = 0.6;  // of the deviation that the robot uses
    constexpr double kLeast = 0.03;
    const NodeDeviation used = used_deviation(end.deviation);
    const double tolerance = stops ? std::min(settings_.navigation.goal_tolerance,
                                              std::max(kLeast, kShare * std::min(used.a, used.b)))
                                   : settings_.navigation.goal_tolerance;
    const double turn = to_end && end.theta && end.theta_deviation > 0.0
                            ? std::min(settings_.navigation.heading_tolerance,
                                       std::max(0.02, kShare * end.theta_deviation))
                            : settings_.navigation.heading_tolerance;
    if (now.navigation.goal_tolerance != tolerance || now.navigation.heading_tolerance != turn) {
      now.navigation.goal_tolerance = tolerance;
      now.navigation.heading_tolerance = turn;
      navigator_.set_settings(now);
    }
    navigator_.follow({.waypoints = window.path},
                      to_end ? vehicle.route().heading : std::optional<double>());
  }
  window_ = std::move(window);
  arrived_ = false;
}

DrivenRoute RouteDriver::drive(const Vehicle& vehicle, const Measurements& measurements) {
  // The leg that was passed last is part of the area: the body may still be in it.
  if (vehicle.route_revision() != known_route_ || vehicle.legs_passed() != known_passed_) {
    if (vehicle.legs_passed() > 0 && vehicle.legs_passed() <= known_legs_.size() &&
        vehicle.route_revision() == known_route_) {
      last_leg_ = known_legs_[vehicle.legs_passed() - 1];
    } else if (vehicle.route_revision() != known_route_ && !vehicle.route().legs.empty()) {
      // A route that begins elsewhere has no last leg.
      const Eigen::Vector2d& begin = vehicle.route().legs.front().start.position;
      if (!known_legs_.empty() && known_legs_.back().end.position == begin)
        last_leg_ = known_legs_.back();
      const bool continues = last_leg_ && ((last_leg_->end.position - begin).norm() < 1e-9 ||
                                           (last_leg_->start.position - begin).norm() < 1e-9);
      if (!continues) last_leg_.reset();
    }
    if (vehicle.route_revision() != known_route_) moved_time_ = measurements.time;
    known_route_ = vehicle.route_revision();
    known_passed_ = vehicle.legs_passed();
    known_legs_ = vehicle.route().legs;
  }
  DrivenRoute driven;
  driven.report.route = vehicle.route_revision();
  const bool may = vehicle.may_drive();
  if (!may) {
    if (driving_) navigator_.cancel();
    driving_ = false;
    window_.reset();
    closed_time_ = -1.0;
  } else if (needs_window(vehicle, measurements)) {
    driving_ = true;
    open_window(vehicle, measurements);
  }
  const NavigationStep step = navigator_.update(measurements);
  driven.command = step.command;
  driven.status = step.status;
  driven.limit = step.limit;
  driven.solution = step.plan;
  if (may) report_progress(vehicle, measurements, driven);
  return driven;
}

std::vector<Eigen::Vector2d> RouteDriver::planned(const Eigen::Vector2d& robot) const {
  if (!window_ || window_->path.empty()) return {};
  const double arc = nearest_on(window_->path, robot).arc;
  std::vector<Eigen::Vector2d> ahead;
  double passed = 0.0;
  for (std::size_t i = 1; i < window_->path.size(); ++i) {
    passed += (window_->path[i] - window_->path[i - 1]).norm();
    if (passed > arc) ahead.push_back(window_->path[i]);
  }
  return ahead;
}

}  // namespace fairway::vda5050
