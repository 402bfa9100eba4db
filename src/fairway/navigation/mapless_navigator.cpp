// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/mapless_navigator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "fairway/map/free_space.hpp"
#include "fairway/path/path_beginning.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr CellWindow kNothing{
    .first = {.x = std::numeric_limits<int>::max(), .y = std::numeric_limits<int>::max()},
    .last = {.x = -1, .y = -1}};
constexpr double kRetryAfter = 0.25;  // [s], when there was no way, or a further one is wanted
constexpr double kLookFurther = 2.5;  // [m], of corridor beyond what a horizon can reach

// A cell of the map may turn out occupied although what is in it lies at its far side: wherever
// there is room, keep so much more that the robot still has its own room then.
Settings with_margins(const Settings& settings) {
  Settings wider = settings;
  wider.path.margin += settings.perception.resolution;
  wider.safety.stop_margin += 0.5 * settings.perception.resolution;
  return wider;
}

// How far the robot can get within a horizon [m].
double reach_of_horizon(const Settings& settings) noexcept {
  return settings.mpc.horizon * settings.mpc.step_length * settings.robot.linear_max;
}

double corridor_length(const Settings& settings) noexcept {
  return reach_of_horizon(settings) + kLookFurther;
}

}  // namespace

MaplessNavigator::MaplessNavigator(const Settings& given,
                                   ControlSolver& solver,
                                   std::size_t max_beams,
                                   const Vector2d& position)
    : settings_(with_margins(given)),
      perception_(settings_.perception, max_beams, position),
      navigator_(settings_, solver),
      goal_{.position = position, .heading = {}},
      changed_(kNothing) {
  constexpr double kMore = 4.0;  // [cells]
  const double cell = settings_.perception.resolution;
  const double matters = settings_.robot.radius + settings_.path.margin +
                         std::max(settings_.path.comfort_distance, cell) + kMore * cell;
  if (matters <= DistanceField::kMostReach * cell) map_.distances.set_reach(matters);
  map_.obstacles = perception_.grid().occupied();
  map_.distances.update(map_.obstacles);
}

void MaplessNavigator::set_goal(const Goal& goal) {
  goal_ = goal;
  has_goal_ = true;
  asked_for_plan_ = true;
  look_for_narrow_ = false;
  way_length_ = std::numeric_limits<double>::infinity();
  plan_time_ = -std::numeric_limits<double>::infinity();
}

void MaplessNavigator::cancel() {
  has_goal_ = false;
  navigator_.cancel();
}

void MaplessNavigator::observe(const LidarScan& scan, const Vector2d& position) noexcept {
  perception_.observe(scan, position, settings_.robot.radius);
  const RollingGrid& grid = perception_.grid();
  rolled_ = rolled_ || grid.rolled();
  const CellWindow& now = grid.changed();
  changed_.first = {.x = std::min(changed_.first.x, now.first.x),
                    .y = std::min(changed_.first.y, now.first.y)};
  changed_.last = {.x = std::max(changed_.last.x, now.last.x),
                   .y = std::max(changed_.last.y, now.last.y)};
}

NavigationStep MaplessNavigator::update(double time, const Pose2& pose, double pose_time) {
  planned_ = false;
  follows_new_plan_ = false;
  const bool pose_known = is_finite(pose) && std::isfinite(time);
  if (rolled_) {
    refresh_map();  // all of it, which is enough for one cycle: plans wait for the next one
  } else if (pose_known && std::isfinite(perception_.time()) && has_goal_ && wants_plan(time)) {
    plan(time, pose);
  }
  input_ = {.time = time,
            .pose = pose,
            .pose_time = pose_time,
            .obstacles = perception_.tracker().obstacles(),
            .obstacles_time = perception_.time(),
            .map = &perception_.grid().not_seen_free(),
            .map_time = perception_.time()};
  NavigationStep step = navigator_.update(input_);
  if (step.status == NavigationStatus::GoalReached && !leads_to_goal_) {
    // As near as it gets for now, but not there.
    step.status = NavigationStatus::Blocked;
    step.limit = LimitingFactor::NoPath;
    step.wants_plan = true;
  }
  asked_for_plan_ = step.wants_plan;
  return step;
}

// At once where the robot is about to go into something new; else not more often than that pays.
bool MaplessNavigator::wants_plan(double time) const noexcept {
  const Plan& now = navigator_.plan();
  const CorridorFollower& corridor = navigator_.corridor();
  const bool driven_on = now.usable() && corridor.reference_path().count > 0;
  constexpr double kSoon = 1.0;  // [m], beyond the braking distance
  const double braking = braking_distance(settings_.robot);
  if (look_for_narrow_ || (driven_on && !corridor_is_free(braking + kSoon))) return true;
  if (time - plan_time_ < kRetryAfter) return false;
  if (!driven_on || asked_for_plan_) return true;
  if (!leads_to_goal_ && corridor.remaining() < reach_of_horizon(settings_)) return true;
  return !corridor_is_free(std::numeric_limits<double>::infinity()) || !path_is_free();
}

void MaplessNavigator::refresh_map() noexcept {
  const bool changed = changed_.first.x <= changed_.last.x;
  if (!rolled_ && !changed) return;
  map_.obstacles = perception_.grid().occupied();
  if (rolled_) {
    map_.distances.update(map_.obstacles);
  } else {
    map_.distances.update(map_.obstacles, changed_);
  }
  rolled_ = false;
  changed_ = kNothing;
}

// Whether the rectangles that the robot enters within `length` [m] are still free for it, as far as
// is known.
bool MaplessNavigator::corridor_is_free(double length) const noexcept {
  const CorridorFollower& corridor = navigator_.corridor();
  const ReferencePath& string = corridor.reference_path();
  const Corridor& built = corridor.corridor();
  const bool workspace = built.space == CorridorSpace::Workspace;
  // A cell that flickers in and out at the side is no reason for another way.
  const double tolerance = 0.5 * settings_.perception.resolution;
  const double clearance =
      workspace ? 0.0
                : std::max(0.0, std::min(built.robot_radius, settings_.robot.radius) - tolerance);
  for (std::size_t i = corridor.current(); i < corridor.size(); ++i) {
    const std::size_t entry = i - corridor.current();  // the string's point where it enters
    const auto last = static_cast<std::size_t>(string.count) - 1;
    if (string.arc[std::min(entry, last)] > length) break;
    if (!is_free(perception_.grid().occupied(), built.rectangles[i], clearance)) return false;
  }
  return true;
}

// Whether the path is still free beyond the corridor, so that a dead end is noticed from afar.
bool MaplessNavigator::path_is_free() const noexcept {
  const Plan& now = navigator_.plan();
  if (now.whole) return true;
  const double clearance =
      std::max(0.0, settings_.robot.radius - 0.5 * settings_.perception.resolution);
  const std::vector<Vector2d>& points = now.path.waypoints;
  double covered = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    covered += (points[i] - points[i - 1]).norm();
    if (covered < corridor_length(settings_)) continue;
    if (!is_free(perception_.grid().occupied(), points[i - 1], points[i], clearance)) return false;
  }
  return true;
}

// The goal itself where the robot can stand there as far as is known; else (nearly) the place
// nearest to it that is, inside the window.
Goal MaplessNavigator::reachable_goal(const Vector2d& position) const noexcept {
  const GridFrame& frame = map_.obstacles.frame();
  const double room = settings_.robot.radius + settings_.path.margin + frame.resolution;
  const CellIndex wanted = frame.cell_at(goal_.position);
  if (map_.distances.at(wanted) > room) return goal_;
  if (distance_to_blocked(map_.obstacles, goal_.position, room) > settings_.robot.radius) {
    return goal_;
  }
  Goal nearest{.position = position, .heading = {}};
  double least = std::numeric_limits<double>::infinity();
  const auto look_at = [&](int x, int y) {
    if (map_.distances.at({.x = x, .y = y}) <= room) return;
    const Vector2d center = frame.center({.x = x, .y = y});
    const double away = (center - goal_.position).squaredNorm();
    if (away >= least) return;
    least = away;
    nearest.position = center;
  };
  // Rings around the cell of the window that is nearest to the goal. After the first ring that has
  // a place, one further out may still be nearer: those at the corners of a ring are the furthest.
  const int x = std::clamp(wanted.x, 0, frame.width - 1);
  const int y = std::clamp(wanted.y, 0, frame.height - 1);
  int last = std::max(frame.width, frame.height);
  for (int ring = 0; ring <= last; ++ring) {
    const bool found = std::isfinite(least);
    for (int i = -ring; i <= ring; ++i) {
      look_at(x + i, y - ring);
      look_at(x + i, y + ring);
      look_at(x - ring, y + i);
      look_at(x + ring, y + i);
    }
    if (!found && std::isfinite(least)) last = std::min(last, 2 + ring * 3 / 2);
  }
  return nearest;
}

// A way that keeps `margin`, or less where there is no more. A corridor that breaks off, but not
// before kEnough of the path, is taken as far as it leads: from nearby the narrow place will look
// different.
Plan MaplessNavigator::find_way(const Vector2d& position, const Goal& goal, double margin) {
  constexpr double kEnough = 2.0;                   // [m]
  constexpr double kLeastOverlap = 5e-4;            // [m^2]
  constexpr double kFits = 0.9 * std::numbers::pi;  // of the largest disc that has room
  PlannerSettings settings = planner_settings(settings_);
  settings.path.margin = margin;
  std::optional<double> breaks_off;  // there [m]
  std::optional<Vector2d> failed;    // radius and overlap of the last try
  const auto build = [&](const BitGrid& obstacles, const Path& path, double radius,
                         CorridorSettings corridor) {
    // Patches that fit between the path and the obstacles need no search for a place beside it.
    const double play = std::max(0.0, radius - settings_.robot.radius);
    corridor.min_overlap_area =
        std::min(corridor.min_overlap_area, std::max(kLeastOverlap, kFits * play * play));
    const Vector2d attempt(radius, corridor.min_overlap_area);
    if (failed == attempt) return CorridorResult{.status = CorridorStatus::NoOverlap};
    CorridorResult result = corridor_.build(obstacles, path, radius, corridor);
    const std::vector<PathSpan>& spans = result.corridor.spans;
    breaks_off.reset();
    if (result.status != CorridorStatus::Built && !spans.empty() && spans.back().to >= kEnough) {
      breaks_off = spans.back().to;
      result.status = CorridorStatus::Built;
    }
    failed = attempt;
    return result;
  };
  Plan found = planner_.plan(map_, position, goal, settings,
                             {.build = build, .corridor_length = corridor_length(settings_)});
  if (found.usable() && breaks_off) {
    found.whole = false;
    found.goal = {.position = beginning_of(found.path, *breaks_off).waypoints.back(),
                  .heading = {}};
  }
  return found;
}

void MaplessNavigator::plan(double time, const Pose2& pose) {
  constexpr double kDetour = 1.0;       // [m]; a way that is so much longer than the last one was
  constexpr double kNarrow = 0.05;      // share of the margin that is kept in the narrowest places
  constexpr double kWorthNarrow = 0.7;  // of the wide way's length
  planned_ = true;
  plan_time_ = time;
  refresh_map();
  const double wished = settings_.path.margin;
  const Goal goal = reachable_goal(pose.position);
  const bool narrow = std::exchange(look_for_narrow_, false);
  const double margin = narrow ? kNarrow * wished : std::min(wished, 2.0 * last_margin_);
  Plan found = find_way(pose.position, goal, margin);
  if (narrow) {
    if (!found.usable() || found.path.length() >= kWorthNarrow * way_length_) return;
  } else {
    // Before a long way round: is there none through a narrower place? That is the next cycle's
    // work; by then the robot will not have gone far.
    look_for_narrow_ = found.usable() && found.path.length() > way_length_ + kDetour;
  }
  last_margin_ = found.usable() ? found.margin : wished;
  // An old way is better than none while the map may be wrong about a narrow place: what is done on
  // it is checked anyway.
  if (!found.usable() && navigator_.plan().usable()) return;
  way_length_ = found.path.length();
  leads_to_goal_ = found.whole && goal.position == goal_.position;
  follows_new_plan_ = true;
  navigator_.follow(std::move(found));
}

}  // namespace fairway
