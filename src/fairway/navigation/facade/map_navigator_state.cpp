// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/facade/map_navigator_state.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "fairway/map/free_space.hpp"
#include "fairway/map/grid_overlay.hpp"
#include "fairway/navigation/facade/obstacle_merge.hpp"
#include "fairway/tracking/corridor_check.hpp"
#include "fairway/zones/zone_map.hpp"

namespace fairway {

namespace {

// The poses on a map are those of the map's localisation, which scans do not correct.
PerceptionSettings on_a_map(PerceptionSettings settings) noexcept {
  settings.match_scans = false;
  return settings;
}

// Returns the cells of `map` under the window of another grid.
CellWindow window_under(const GridFrame& window, const GridFrame& map) noexcept {
  CellWindow cells = kNoCells;
  for (const double x : {0.0, static_cast<double>(window.width)}) {
    for (const double y : {0.0, static_cast<double>(window.height)}) {
      const CellIndex corner = map.cell_at(window.to_world({x, y}));
      cells = united(cells, {.first = {.x = corner.x - 1, .y = corner.y - 1},
                             .last = {.x = corner.x + 1, .y = corner.y + 1}});
    }
  }
  return cells;
}

}  // namespace

MapNavigator::State::State(const Settings& given,
                           ControlSolver* solver,
                           const PreparedMap* shared_map,
                           Planner* shared_planner)
    : settings(given),
      solver_(solver),
      shared_map_(shared_map),
      shared_planner_(shared_planner) {
  constexpr std::size_t kManyObstacles = 256;
  moving_.reserve(kManyObstacles);
  make_navigator();
  planning = shared_map_ != nullptr
                 ? std::make_unique<MapPlanning>(settings, *shared_map_, *shared_planner_)
                 : std::make_unique<MapPlanning>(settings);
}

void MapNavigator::State::make_navigator() {
  navigator = solver_ != nullptr ? std::make_unique<Navigator>(settings, *solver_)
                                 : std::make_unique<Navigator>(settings);
}

void MapNavigator::State::set_settings(const Settings& given) {
  settings = checked(given);
  if (zones) use_zones(Zones(zones->zones()));
  const std::unique_ptr<Navigator> older = std::move(navigator);
  make_navigator();
  navigator->continue_from(*older);
  planning->set_settings(settings);  // a plan that is being made ends first, and is not used
  const Eigen::Vector2d& here = input.pose.position;
  if (perception) {
    perception.emplace(on_a_map(settings.perception),
                       is_plausible(here) ? here : Eigen::Vector2d(Eigen::Vector2d::Zero()));
  }
  if (task.task()) set_task(NavigationTask(*task.task()));
}

void MapNavigator::State::set_zones(const Zones& given) {
  if (const Expected<void> valid = validate(given); !valid)
    throw std::invalid_argument(valid.error().message);
  if (shared_map_ != nullptr)
    throw std::invalid_argument("set_zones: expected a navigator with a map of its own");
  use_zones(given);
}

void MapNavigator::State::use_zones(const Zones& given) {
  zones = given.empty() ? nullptr : std::make_shared<const ZoneMap>(given, settings.robot.radius);
  zones_changed_ = true;
  if (!map) return;
  map->set_zones(zones);
  seen_.set_zones(zones);
  map_changed_ = true;
}

void MapNavigator::State::set_task(NavigationTask given) {
  task.begin(std::move(given));
  planning->begin_task();
  ++task_number_;
  task_is_new_ = task.can_be_done();
  plan_is_current = false;
  if (!task.can_be_done()) navigator->cancel();
}

void MapNavigator::State::change(const CellWindow& window, bool moved) {
  map_changed_ = true;
  map_moved_ = map_moved_ || moved;
  planning->note_change(window);
  if (perception && map) overlay_scans();
}

bool MapNavigator::State::observe(const LidarScan& scan, const Eigen::Vector2d& position) {
  scan_refused_ = !is_plausible(scan, position);
  if (scan_refused_ && !perception)
    perception.emplace(on_a_map(settings.perception), Eigen::Vector2d::Zero());
  if (scan_refused_) return false;
  if (!perception) perception.emplace(on_a_map(settings.perception), position);
  perception->observe(scan, position, settings.robot.radius);
  scans_changed_ = true;
  if (map) overlay_scans();
  return true;
}

void MapNavigator::State::overlay_scans() {
  seen_ = *map;
  add_obstacles(perception->grid().occupied(), seen_);
  const CellWindow now = window_under(perception->grid().frame(), map->frame());
  planning->note_change(united(scanned_, now));
  scanned_ = now;
}

const BitGrid* MapNavigator::State::obstacles() const noexcept {
  if (shared_map_ != nullptr) return &shared_map_->obstacles;
  if (!map) return nullptr;
  return perception ? &seen_ : &*map;
}

bool MapNavigator::State::pose_is_known(const Measurements& m) const noexcept {
  return is_plausible(m.pose) && std::isfinite(m.time) &&
         std::abs(m.time - m.pose_time.value_or(m.time)) <= settings.safety.pose_timeout;
}

// Checks whether the plan is still free after the map or the scans have changed.
void MapNavigator::State::check_plan() {
  if (!map_changed_ && !scans_changed_) return;
  const CorridorFollower& corridor = navigator->corridor();
  const double radius = settings.robot.radius;
  const BitGrid* fixed = shared_map_ != nullptr ? &shared_map_->obstacles : &*map;
  if (navigator->plan().usable()) {
    // After the map's window moved, it does not contain the whole corridor and cannot be used to
    // check it.
    if (map_changed_ && !map_moved_) {
      blocked_by_map_ = !corridor_is_free(*fixed, corridor, radius, 4.0 * kFreeSpaceSkin);
    }
    // A cell of a scan that flickers at a side must not cause a new plan.
    const double flicker = perception ? 0.5 * settings.perception.resolution : 0.0;
    blocked_ = blocked_by_map_ ||
               (perception && !corridor_is_free(*obstacles(), corridor, radius, flicker));
  }
  may_be_better_ = may_be_better_ || map_changed_;
  map_moved_ = false;
  map_changed_ = false;
  scans_changed_ = false;
}

// The policy is to plan at once for a new goal or if the map blocks the plan. In all other cases it
// plans at most once per `retry_period`.
bool MapNavigator::State::needs_plan(const Measurements& m, bool at_once) {
  const double time = m.time;
  if (!task.can_be_done() || planning->busy() || obstacles() == nullptr) return false;
  if (task_is_new_) return true;
  check_plan();
  if (zones_changed_) return true;
  if (blocked_by_map_ && navigator->plan().usable()) return true;
  const bool just_tried = time - plan_time_ < settings.planning.retry_period && time >= plan_time_;
  if (just_tried && !at_once) return false;
  asked_ = asked_ || (tight_start_ && has_clearance(m.pose.position));
  return !navigator->plan().usable() || asked_ || blocked_ || may_be_better_;
}

// Whether the disc that covers the robot fits there.
bool MapNavigator::State::has_clearance(const Eigen::Vector2d& position) const noexcept {
  const double radius = settings.robot.radius;
  return distance_to_blocked(*obstacles(), position, radius) > radius;
}

void MapNavigator::State::start_plan(const Measurements& m) {
  tight_start_ = !has_clearance(m.pose.position);
  asked_number_ = task_number_;
  plan_time_ = m.time;
  // The plan to a new goal is made on the map as it is: earlier changes need no other one.
  if (task_is_new_) map_changed_ = map_moved_ = scans_changed_ = false;
  task_is_new_ = false;
  asked_ = asked_ || zones_changed_;
  zones_changed_ = false;
  planned = true;
  planning->start(
      *obstacles(),
      {.start = m.pose.position, .goal = task.task()->goal, .along = task.task()->along});
}

// Another plan is adopted only if it is clearly shorter.
bool MapNavigator::State::is_clearly_shorter(const Path& path) const noexcept {
  constexpr double kShorter = 0.25;       // [m]
  constexpr double kShorterShare = 0.05;  // share of the remaining length
  if (navigator->corridor().reference_path().count == 0) return false;  // not followed yet
  const double remaining = navigator->corridor().remaining();
  return path.length() < remaining - std::max(kShorter, kShorterShare * remaining);
}

void MapNavigator::State::take_plan() {
  std::optional<Plan> plan = planning->take();
  if (!plan || !task.task() || asked_number_ != task_number_) return;
  const bool has_old = plan_is_current && navigator->plan().usable();
  const bool only_better = has_old && !asked_ && !blocked_ && !task.task()->along;
  may_be_better_ = false;
  if (only_better && !(plan->usable() && is_clearly_shorter(plan->path))) return;
  asked_ = false;
  // While only scans block it, the old plan is better than none. Scans may be wrong about a narrow
  // place, and every command is checked before it is sent.
  if (!plan->usable() && has_old && !blocked_by_map_) return;
  follow(*std::move(plan));
}

void MapNavigator::State::follow(Plan plan) {
  navigator->follow(std::move(plan));
  plan_is_current = true;
  follows_new_plan = true;
  blocked_ = false;
  blocked_by_map_ = false;
}

void MapNavigator::State::set_input(const Measurements& m) {
  input = input_of(m);
  input.map = obstacles();
  input.hold = hold;
  input.entrances = m.entrances;
  input.planning = task.task() && !plan_is_current && planning->busy();
  if (!perception) return;
  input.map_time = std::min(input.map_time, std::max(kNeverMeasured, perception->time()));
  merge_tracked(*perception, moving_, input);
  input.obstacles_due = true;
}

// Interprets the navigator's result with respect to the task.
NavigationStep MapNavigator::State::judged(const NavigationStep& step) {
  const CorridorFollower& corridor = navigator->corridor();
  const bool driven_on = plan_is_current && corridor.reference_path().count > 0;
  NavigationStep answer =
      task.judge(step, {.time = input.time,
                        .plan_is_current = plan_is_current,
                        .leads_to_goal = navigator->plan().whole,
                        .new_path = follows_new_plan,
                        .remaining = driven_on ? std::optional(corridor.remaining()) : std::nullopt,
                        .turn = driven_on ? turn_left(*navigator, input.pose) : 0.0,
                        .patience = settings.navigation.patience});
  // An unusable plan is kept, because it explains why there is none.
  if (answer.status == NavigationStatus::GaveUp && navigator->plan().usable()) navigator->cancel();
  if (scan_refused_ && answer.limit == LimitingFactor::StaleMap)
    answer.limit = LimitingFactor::InvalidScan;
  return answer;
}

void MapNavigator::State::plan_if_needed(const Measurements& m, bool at_once) {
  follows_new_plan = false;
  planned = false;
  take_plan();
  if (!pose_is_known(m) || !needs_plan(m, at_once)) return;
  start_plan(m);
  if (!settings.planning.background) take_plan();
}

NavigationStep MapNavigator::State::update(const Measurements& m) {
  plan_if_needed(m, false);
  set_input(m);
  const NavigationStep step = judged(navigator->update(input));
  asked_ = asked_ || step.wants_plan;
  return step;
}

}  // namespace fairway
