// SPDX-License-Identifier: Apache-2.0
#include "driver/leg_path.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/map/free_space.hpp"

namespace fairway::vda5050 {

namespace {

using Point = Eigen::Vector2d;

constexpr double kSpacing = 0.1;  // of samples on a line [m]
constexpr double kBefore = 0.4;   // length of line left before and after a blocked part [m]

// A point on the line of a leg.
struct Sample {
  Point point;
  std::size_t leg = 0;
};

void add_samples(const std::vector<Point>& line,
                 double from_arc,
                 std::size_t leg,
                 std::vector<Sample>& samples) {
  double arc = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point chord = line[i] - line[i - 1];
    const double length = chord.norm();
    const int pieces = std::max(1, static_cast<int>(std::ceil(length / kSpacing)));
    for (int k = 1; k <= pieces; ++k) {
      const double share = static_cast<double>(k) / pieces;
      if (arc + share * length < from_arc) continue;
      samples.push_back({.point = line[i - 1] + share * chord, .leg = leg});
    }
    arc += length;
  }
}

// The samples from the robot on; the robot joins the line ahead of it.
std::vector<Sample> samples_of(std::span<const RouteLeg> legs, const std::optional<Point>& from) {
  constexpr double kJoin = 0.3;  // ahead of the robot [m]
  std::vector<Sample> samples{{.point = from.value_or(legs.front().line.front()), .leg = 0}};
  for (std::size_t i = 0; i < legs.size(); ++i) {
    double begin = 0.0;
    if (i == 0 && from) {
      const LinePoint near = nearest_on(legs[0].line, *from);
      begin = std::min(near.arc + kJoin, length_of(legs[0].line));
    }
    add_samples(legs[i].line, begin, i, samples);
  }
  return samples;
}

}  // namespace

LegPath path_along(const BitGrid& map,
                   std::span<const RouteLeg> legs,
                   const std::optional<Point>& from,
                   const PlannerSettings& settings,
                   Planner& planner) {
  LegPath path;
  if (legs.empty()) return path;
  const std::vector<Sample> samples = samples_of(legs, from);
  const double clearance = settings.radius + settings.path.margin;
  const auto clear = [&](const Sample& a, const Sample& b) {
    return is_free(map, a.point, b.point, clearance);
  };
  std::optional<PreparedMap> prepared;
  path.points.push_back(samples.front().point);
  const auto steps = static_cast<std::size_t>(std::lround(kBefore / kSpacing));
  std::size_t at = 0;
  while (at + 1 < samples.size()) {
    if (clear(samples[at], samples[at + 1])) {
      path.points.push_back(samples[++at].point);
      continue;
    }
    // The next sample from which the line is clear again, for some length or to its end.
    std::size_t again = at + 1;
    std::size_t run = 0;
    for (std::size_t i = at + 1; i < samples.size() && run < steps; ++i) {
      const bool good = i + 1 < samples.size() ? clear(samples[i], samples[i + 1])
                                               : clear(samples[i], samples[i]);
      run = good ? run + 1 : 0;
      if (!good) again = i + 1;
      if (good && i + 1 == samples.size()) break;
    }
    const std::size_t closed = samples[at + 1].leg;
    if (again < samples.size()) {
      if (!prepared) prepared.emplace(map);
      // The detour begins a little before the blocked part.
      const std::size_t back = std::min({steps, at, path.points.size() - 1});
      for (std::size_t take = back + 1; take-- > 0;) {
        const Point start = path.points[path.points.size() - 1 - take];
        const std::size_t goal = std::min(again + take, samples.size() - 1);
        const auto detour = free_path(*prepared, start, samples[goal].point, settings, planner);
        if (!detour) continue;
        path.points.resize(path.points.size() - take);
        path.points.insert(path.points.end(), detour->begin() + 1, detour->end());
        at = goal;
        again = 0;
        break;
      }
      if (again == 0) continue;
    }
    path.closed_leg = closed;
    if (path.points.size() == 1) path.points.clear();
    return path;
  }
  return path;
}

std::vector<Point> path_back(const BitGrid& map,
                             const RouteLeg& leg,
                             const Point& from,
                             const PlannerSettings& settings,
                             Planner& planner) {
  const double here = nearest_on(leg.line, from).arc;
  std::vector<Sample> samples{{.point = leg.line.front(), .leg = 0}};
  add_samples(leg.line, 0.0, 0, samples);
  const PreparedMap prepared(map);
  for (std::size_t i = samples.size(); i-- > 0;) {
    const Point& point = samples[i].point;
    if (nearest_on(leg.line, point).arc > here) continue;
    if (!is_free(map, point, point, settings.radius + settings.path.margin)) continue;
    if (const auto path = free_path(prepared, from, point, settings, planner)) return *path;
  }
  return {};
}

std::optional<std::vector<Point>> free_path(const PreparedMap& map,
                                            const Point& from,
                                            const Point& to,
                                            const PlannerSettings& settings,
                                            Planner& planner) {
  const Plan plan = planner.plan(map, from, {.position = to, .heading = {}}, settings);
  if (!plan.usable() || !plan.whole || plan.path.waypoints.size() < 2) return std::nullopt;
  // Planned for the whole disc: a plan for a smaller one would not be followed to the end.
  if (!fits(plan, settings.radius, settings.inner_radius)) return std::nullopt;
  return plan.path.waypoints;
}

}  // namespace fairway::vda5050
