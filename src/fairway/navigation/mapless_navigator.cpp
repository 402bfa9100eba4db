// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/mapless_navigator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/map/free_space.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr CellWindow kNothing{
    .first = {.x = std::numeric_limits<int>::max(), .y = std::numeric_limits<int>::max()},
    .last = {.x = -1, .y = -1}};
constexpr double kRetryAfter = 0.25;  // [s], when there was no way

}  // namespace

MaplessNavigator::MaplessNavigator(const Settings& settings,
                                   ControlSolver& solver,
                                   std::size_t max_beams,
                                   const Vector2d& position)
    : settings_(settings),
      perception_(settings.perception, max_beams, position),
      navigator_(settings, solver),
      map_(perception_.grid().occupied()),
      goal_{.position = position, .heading = {}},
      changed_(kNothing) {}

void MaplessNavigator::set_goal(const Goal& goal) {
  goal_ = goal;
  has_goal_ = true;
  wants_plan_ = true;
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
  const bool pose_known = is_finite(pose) && std::isfinite(time);
  if (pose_known && std::isfinite(perception_.time())) {
    refresh_map();
    const bool usable = navigator_.plan().usable();
    const bool waited = time - plan_time_ >= kRetryAfter;
    if (has_goal_ && ((usable && !corridor_is_free()) || ((wants_plan_ || !usable) && waited))) {
      plan(time, pose);
    }
  }
  NavigationStep step = navigator_.update({.time = time,
                                           .pose = pose,
                                           .pose_time = pose_time,
                                           .obstacles = perception_.tracker().obstacles(),
                                           .obstacles_time = perception_.time(),
                                           .map = &perception_.grid().not_seen_free(),
                                           .map_time = perception_.time()});
  if (step.status == NavigationStatus::GoalReached &&
      navigator_.plan().goal.position != goal_.position) {
    // Only as near as it could get so far: look again.
    step.status = NavigationStatus::Blocked;
    step.limit = Limit::NoPath;
    step.wants_plan = true;
  }
  wants_plan_ = step.wants_plan;
  return step;
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

// Whether the rest of the corridor is still free for the robot, as far as is known.
bool MaplessNavigator::corridor_is_free() const noexcept {
  const CorridorString& corridor = navigator_.corridor();
  const Corridor& built = corridor.corridor();
  const bool workspace = built.space == CorridorSpace::Workspace;
  const double clearance =
      workspace ? 0.0 : std::min(built.robot_radius, settings_.robot.radius) - 2e-3;
  for (std::size_t i = corridor.current(); i < corridor.size(); ++i) {
    if (!is_free(map_.obstacles, built.rectangles[i], clearance)) return false;
  }
  return true;
}

// The goal itself where the robot can stand there as far as is known; else the place nearest to it
// that is, inside the window.
Goal MaplessNavigator::reachable_goal(const Vector2d& position) const noexcept {
  const GridFrame& frame = map_.obstacles.frame();
  const double room = settings_.robot.radius + settings_.path.margin + frame.resolution;
  if (map_.distances.at(frame.cell_at(goal_.position)) > room) return goal_;
  if (distance_to_blocked(map_.obstacles, goal_.position, room) > settings_.robot.radius) {
    return goal_;
  }
  Goal nearest{.position = position, .heading = {}};
  double least = std::numeric_limits<double>::infinity();
  const auto width = static_cast<std::size_t>(frame.width);
  const std::span<const float> distances = map_.distances.cells();
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (static_cast<double>(distances[i]) <= room) continue;
    const Vector2d center =
        frame.center({.x = static_cast<int>(i % width), .y = static_cast<int>(i / width)});
    const double away = (center - goal_.position).squaredNorm();
    if (away >= least) continue;
    least = away;
    nearest.position = center;
  }
  return nearest;
}

void MaplessNavigator::plan(double time, const Pose2& pose) {
  planned_ = true;
  plan_time_ = time;
  Plan found = planner_.plan(map_, pose.position, reachable_goal(pose.position), settings_);
  // An old way is better than none while the map may be wrong about a narrow place: what is done on
  // it is checked anyway.
  if (found.usable() || !navigator_.plan().usable()) navigator_.follow(std::move(found));
}

}  // namespace fairway
