// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/facade/local_planning.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <numbers>
#include <utility>

#include "fairway/map/free_space.hpp"
#include "fairway/path/path_beginning.hpp"

namespace fairway {

using Eigen::Vector2d;

LocalPlanning::LocalPlanning(const Settings& settings, const BitGrid& seen) : settings_(settings) {
  constexpr double kMore = 4.0;  // [cells]; greater distances do not change a plan
  const double cell = settings_.perception.resolution;
  const double matters = settings_.robot.radius + settings_.path.margin +
                         std::max(settings_.path.comfort_distance, cell) + kMore * cell;
  if (matters <= DistanceField::kMostReach * cell) map_.distances.set_reach(matters);
  map_.obstacles = seen;
  map_.measure();
}

double LocalPlanning::corridor_length(const Settings& settings) noexcept {
  constexpr double kLookFurther = 2.5;  // [m] of corridor beyond what the horizon can reach
  return settings.mpc.horizon * settings.mpc.step_length * settings.robot.linear_max + kLookFurther;
}

void LocalPlanning::refresh(const BitGrid& seen) {
  if (settings_.planning.background) {
    note_change(all_cells(seen.frame()));
    return;
  }
  map_.update(seen, all_cells(seen.frame()));
  changed_ = kNoCells;
}

void LocalPlanning::start(const BitGrid& seen, const LocalRequest& request) {
  request_ = request;
  made_.reset();
  const CellWindow changed = std::exchange(changed_, kNoCells);
  if (!settings_.planning.background) {
    map_.update(seen, changed);
    make();
    return;
  }
  worker_.start([this, changed, cells = seen] {
    map_.update(cells, changed);
    make();
  });
}

void LocalPlanning::make() {
  made_.emplace();
  made_->request = request_;
  try {
    if (request_.along) {
      made_->goal = request_.goal;
      made_->plan = plan_along(planner_, map_, request_.position, *request_.along,
                               planner_settings(settings_));
    } else {
      made_->goal = reachable_goal(request_.position, request_.goal);
      make_plan(nullptr);
    }
  } catch (const std::exception&) {  // out of memory: no plan, and another attempt later
    made_->plan = Plan{};
  }
}

// Makes a plan, or continues a paused one.
void LocalPlanning::make_plan(const Plan* begun) {
  constexpr int kMostExpanded = 600;  // nodes that a search may take beside the other work
  made_->plan = find_path(
      request_.position, made_->goal, request_.margin,
      {.pause = !settings_.planning.background, .most_expanded = kMostExpanded, .begun = begun});
  if (request_.find_opening && !made_->plan.paused && !made_->plan.usable()) find_opening();
}

bool LocalPlanning::resume() {
  if (!paused()) return false;
  try {
    const Plan begun = std::move(made_->plan);
    make_plan(&begun);
  } catch (const std::exception&) {
    made_->plan = Plan{};
  }
  return true;
}

std::optional<LocalPlan> LocalPlanning::take() {
  if (settings_.planning.background) {
    if (!worker_.finished()) return std::nullopt;
    worker_.collect();
  }
  if (paused()) return std::nullopt;
  return std::exchange(made_, std::nullopt);
}

// Returns the goal if, as far as is known, the robot fits there. Otherwise returns approximately
// the free place in the window that is nearest to it.
Goal LocalPlanning::reachable_goal(const Vector2d& position, const Goal& goal) const noexcept {
  const GridFrame& frame = map_.obstacles.frame();
  const double required = settings_.robot.radius + settings_.path.margin + frame.resolution;
  const CellIndex wanted = frame.cell_at(goal.position);
  if (map_.distances.at(wanted) > required) return goal;
  if (distance_to_blocked(map_.obstacles, goal.position, required) > settings_.robot.radius) {
    return goal;
  }
  Goal nearest{.position = position, .heading = {}};
  double least = std::numeric_limits<double>::infinity();
  const auto look_at = [&](int x, int y) {
    if (map_.distances.at({.x = x, .y = y}) <= required) return;
    const Vector2d center = frame.center({.x = x, .y = y});
    const double away = (center - goal.position).squaredNorm();
    if (away >= least) return;
    least = away;
    nearest.position = center;
  };
  // Search rings around the cell of the window that is nearest to the goal. After the first ring
  // with a place, one further out may still be nearer, because the corners of a ring are its
  // furthest points.
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

// Finds a path that keeps `margin`, or less where it must. A corridor that covers only the
// beginning of the path, but at least kEnough of it, is used as far as it leads: from nearby the
// narrow place may appear different.
Plan LocalPlanning::find_path(const Vector2d& position,
                              const Goal& goal,
                              double margin,
                              const PlannerHooks& given) {
  constexpr double kEnough = 2.0;                   // [m]
  constexpr double kLeastOverlap = 5e-4;            // [m^2]
  constexpr double kFits = 0.9 * std::numbers::pi;  // share of the largest disc that fits
  PlannerSettings settings = planner_settings(settings_);
  settings.path.margin = margin;
  std::optional<double> breaks_off;  // end of an incomplete corridor [m]
  std::optional<Vector2d> failed;    // radius and overlap of the last attempt
  const auto build = [&](const BitGrid& obstacles, const Path& path, double radius,
                         CorridorSettings corridor) {
    // Overlaps that fit between the path and the obstacles need no search for a place beside the
    // path.
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
  PlannerHooks hooks = given;
  hooks.build = build;
  hooks.corridor_length = corridor_length(settings_);
  Plan found = planner_.plan(map_, position, goal, settings, hooks);
  if (found.usable() && breaks_off) {
    found.whole = false;
    found.goal = {.position = beginning_of(found.path, *breaks_off).waypoints.back(),
                  .heading = {}};
  }
  return found;
}

void LocalPlanning::find_opening() {
  made_->opening = openings_.find(map_, request_.position, request_.goal.position,
                                  settings_.robot.radius, request_.tried);
  if (!made_->opening) return;
  const Vector2d ahead = made_->opening->blocked_at - made_->opening->viewpoint;
  made_->to_opening = find_path(
      request_.position,
      {.position = made_->opening->viewpoint, .heading = std::atan2(ahead.y(), ahead.x())},
      request_.margin);
}

}  // namespace fairway
