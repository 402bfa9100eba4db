// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/planner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "fairway/corridor/corridor_builder.hpp"
#include "fairway/map/free_space.hpp"
#include "fairway/path/path_beginning.hpp"
#include "fairway/path/path_planner.hpp"
#include "fairway/zones/zone_map.hpp"

namespace fairway {

namespace {

// Shares of the desired margin and overlap, in the order in which they are tried.
constexpr std::array kMarginShares = {1.0, 0.5, 0.2, 0.05};
struct CorridorTry {
  double margin_share;   // share of the path margin that the rectangles keep; the rest is tolerance
  double overlap_share;  // share of the desired overlap
};
constexpr std::array kCorridorTries = {CorridorTry{0.5, 1.0},  CorridorTry{0.5, 0.25},
                                       CorridorTry{0.5, 0.05}, CorridorTry{0.0, 0.25},
                                       CorridorTry{0.0, 0.05}, CorridorTry{0.0, 0.005}};

// Returns the radius of the disc for which the corridor is built. It is robot and margin, or the
// clearance of start and goal if that is less.
double corridor_radius(const PreparedMap& map,
                       const Eigen::Vector2d& start,
                       const Eigen::Vector2d& goal,
                       double robot_radius,
                       double margin) {
  const double desired = robot_radius + margin;
  const double clearance = std::min(distance_to_blocked(map.obstacles, start, desired + 1.0),
                                    distance_to_blocked(map.obstacles, goal, desired + 1.0));
  return std::max(0.0, std::min(desired, clearance - 4.0 * kFreeSpaceSkin));
}

// Returns the radius to plan for. If the robot's estimated position is slightly inside an obstacle,
// or only its body fits beside a wall, the plan uses as much of the robot as fits, so that it can
// leave. The commands are still checked with the whole robot.
double radius_that_fits(const PreparedMap& map,
                        const Eigen::Vector2d& start,
                        double radius,
                        double inner_radius) {
  constexpr double kLeast = 0.9;  // share; a start with less clearance is blocked
  const double least = std::min(kLeast * radius, inner_radius);
  const double clearance = distance_to_blocked(map.obstacles, start, radius + 1.0);
  return clearance > radius ? radius : std::max(least, clearance - 4.0 * kFreeSpaceSkin);
}

// Adds the duration of a stage to `sum`.
class Stopwatch {
 public:
  Stopwatch(const std::function<double()>& clock, double& sum)
      : clock_(clock),
        sum_(sum),
        start_(clock ? clock() : 0.0) {}
  ~Stopwatch() {
    if (clock_) sum_ += clock_() - start_;
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  const std::function<double()>& clock_;
  double& sum_;
  double start_;
};

// How deep a straight piece of a path leads into a polygon, at points 0.05 m apart; negative
// outside [m].
double deepest_along(const ZonePolygon& polygon, const Segment& piece) {
  constexpr double kApart = 0.05;  // [m]
  const double length = (piece.b - piece.a).norm();
  const int parts = 1 + static_cast<int>(length / kApart);
  double deepest = -std::numeric_limits<double>::infinity();
  for (int k = 0; k <= parts; ++k) {
    const Eigen::Vector2d point = piece.a + (piece.b - piece.a) * k / parts;
    deepest = std::max(deepest, -polygon.signed_distance(point));
  }
  return deepest;
}

// Returns zones in which the one-way zones that a path avoids are keep-outs for the centre. Null if
// there are none.
std::shared_ptr<const ZoneMap> with_closed_lanes(const BitGrid& obstacles, const Path& path) {
  const ZoneMap* zones = obstacles.zones();
  if (zones == nullptr) return nullptr;
  Zones closed = zones->zones();
  bool any = false;
  for (Zone& zone : closed) {
    if (zone.kind != ZoneKind::OneWay) continue;
    const ZonePolygon polygon(zone.polygon);
    bool entered = false;
    for (std::size_t i = 1; i < path.waypoints.size() && !entered; ++i) {
      // What touches it from outside does not enter it.
      constexpr double kDeep = 1e-3;  // [m]
      const Segment piece{.a = path.waypoints[i - 1], .b = path.waypoints[i]};
      entered = polygon.is_near(segment_rectangle(piece.a, piece.b), 0.0) &&
                deepest_along(polygon, piece) > kDeep;
    }
    if (entered) continue;
    zone.kind = ZoneKind::KeepOut;
    zone.reference = ZoneReference::Centre;
    any = true;
  }
  return any ? std::make_shared<const ZoneMap>(std::move(closed), zones->radius()) : nullptr;
}

bool depends_on_margin(PathStatus status) { return status == PathStatus::NoConnection; }

}  // namespace

Planner::Planner() : path_planner_(std::make_unique<PathPlanner>()) {}
Planner::Planner(Planner&&) noexcept = default;
Planner& Planner::operator=(Planner&&) noexcept = default;
Planner::~Planner() = default;

Plan Planner::plan(const PreparedMap& map,
                   const Eigen::Vector2d& start,
                   const Goal& goal,
                   const PlannerSettings& settings,
                   const PlannerHooks& hooks) {
  Plan plan = plan_on(map, start, goal, settings, hooks);
  if (plan.paused || plan.path_status != PathStatus::Found) return plan;
  // A rectangle beside the path may reach into a one-way zone, against its direction.
  const std::shared_ptr<const ZoneMap> closed = with_closed_lanes(map.obstacles, plan.path);
  if (closed == nullptr) return plan;
  BitGrid obstacles = map.obstacles;
  obstacles.set_zones(closed);
  PlannerHooks at_once = hooks;
  at_once.pause = false;
  at_once.begun = nullptr;
  Plan around = plan_on(PreparedMap(std::move(obstacles)), start, goal, settings, at_once);
  around.path_seconds += plan.path_seconds;
  around.corridor_seconds += plan.corridor_seconds;
  return around.usable() ? around : plan;
}

Plan Planner::plan_on(const PreparedMap& map,
                      const Eigen::Vector2d& start,
                      const Goal& goal,
                      const PlannerSettings& settings,
                      const PlannerHooks& hooks) {
  Plan plan;
  plan.goal = goal;
  // Input that cannot be located on the map; this form also rejects NaN.
  if (!(settings.radius >= 0.0 && std::isfinite(settings.radius))) {
    plan.path_status = PathStatus::InvalidInput;
    return plan;
  }
  if (!is_finite(start) || !is_finite(goal.position)) {
    plan.path_status = is_finite(start) ? PathStatus::GoalOutsideMap : PathStatus::StartOutsideMap;
    return plan;
  }
  // In the workspace the paper keeps Delta_s between path and walls, which already is the clearance
  // needed.
  const bool in_workspace = settings.corridor.space == CorridorSpace::Workspace;
  const double body =
      in_workspace ? std::max(settings.radius, settings.corridor.inward_offset) : settings.radius;
  const double radius = radius_that_fits(map, start, body, settings.inner_radius);
  const bool may_shrink = settings.path.margin > 0.0 && !hooks.fixed_margin;
  int expanded = 0;
  for (const double margin_share : kMarginShares) {
    PathSettings path_settings = settings.path;
    path_settings.margin = settings.path.margin * margin_share;
    PathResult found;
    if (hooks.begun != nullptr && path_settings.margin >= hooks.begun->margin) {
      const bool present = path_settings.margin == hooks.begun->margin;
      if (!present || hooks.begun->path_status != PathStatus::Found) continue;
      found = {.status = PathStatus::Found, .path = hooks.begun->path};
    } else {
      const Stopwatch stopwatch(hooks.clock, plan.path_seconds);
      found = path_planner_->find(map.obstacles, map.distances, start, goal.position, radius,
                                  path_settings);
    }
    plan.path_status = found.status;
    plan.margin = path_settings.margin;
    const bool is_last = margin_share == kMarginShares.back();
    expanded += found.expanded;
    plan.paused = hooks.pause && expanded > hooks.most_expanded;
    if (found.status != PathStatus::Found) {
      if (depends_on_margin(found.status) && may_shrink && !is_last) {
        if (plan.paused) return plan;
        continue;
      }
      plan.paused = false;
      return plan;
    }
    plan.path = std::move(found.path);
    if (plan.paused) return plan;
    plan.whole = plan.path.length() <= hooks.corridor_length;
    const Path driven = plan.whole ? plan.path : beginning_of(plan.path, hooks.corridor_length);
    plan.goal = plan.whole ? goal : Goal{.position = driven.waypoints.back(), .heading = {}};
    for (const CorridorTry& attempt : kCorridorTries) {
      CorridorSettings corridor_settings = settings.corridor;
      corridor_settings.min_overlap_area *= attempt.overlap_share;
      const double corridor_body = corridor_radius(map, start, plan.goal.position, settings.radius,
                                                   attempt.margin_share * path_settings.margin);
      const Stopwatch stopwatch(hooks.clock, plan.corridor_seconds);
      CorridorResult built =
          hooks.build ? hooks.build(map.obstacles, driven, corridor_body, corridor_settings)
                      : build_corridor(map.obstacles, driven, corridor_body, corridor_settings);
      plan.corridor_status = built.status;
      plan.corridor = std::move(built.corridor);
      plan.stuck_at = built.stuck_at;
      if (built.status == CorridorStatus::Built) return plan;
    }
    if (!may_shrink) break;
  }
  return plan;
}

}  // namespace fairway
