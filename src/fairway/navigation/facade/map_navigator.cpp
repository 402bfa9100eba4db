// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/facade/map_navigator.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "fairway/navigation/explanation/step_explanation.hpp"
#include "fairway/navigation/facade/map_navigator_state.hpp"

namespace fairway {

MapNavigator::MapNavigator(const Settings& settings)
    : state_(std::make_unique<State>(settings, nullptr, nullptr, nullptr)) {}

MapNavigator::MapNavigator(const Settings& settings, const OccupancyGrid& map)
    : MapNavigator(settings) {
  set_map(map);
}

MapNavigator::MapNavigator(const Settings& settings, ControlSolver& solver)
    : state_(std::make_unique<State>(settings, &solver, nullptr, nullptr)) {}

MapNavigator::MapNavigator(const Settings& settings,
                           const PreparedMap& map,
                           Planner& planner,
                           ControlSolver& solver)
    : state_(std::make_unique<State>(settings, &solver, &map, &planner)) {}

MapNavigator::MapNavigator(MapNavigator&&) noexcept = default;
MapNavigator& MapNavigator::operator=(MapNavigator&&) noexcept = default;
MapNavigator::~MapNavigator() = default;

void MapNavigator::set_map(const OccupancyGrid& map) {
  set_map(BitGrid(map, unknown_cells(state_->settings.map)));
}

void MapNavigator::set_map(const BitGrid& obstacles) {
  const bool moved = !state_->map || !same_frame(obstacles.frame(), state_->map->frame());
  state_->map = obstacles;
  state_->map->set_zones(state_->zones);
  state_->change(all_cells(obstacles.frame()), moved);
}

void MapNavigator::update_map(const OccupancyGrid& map, CellIndex first, CellIndex last) {
  if (!state_->map || !same_frame(map.frame(), state_->map->frame())) {
    throw std::invalid_argument("update_map: expected a grid with the cells of the present map");
  }
  const bool unknown_blocks = state_->settings.map.unknown_is_occupied;
  const GridFrame& frame = map.frame();
  const CellWindow window = clipped({.first = first, .last = last}, frame);
  for (int y = window.first.y; y <= window.last.y; ++y) {
    for (int x = window.first.x; x <= window.last.x; ++x) {
      const CellState cell = map.at({.x = x, .y = y});
      state_->map->set({.x = x, .y = y}, cell == CellState::Occupied ||
                                             (cell == CellState::Unknown && unknown_blocks));
    }
  }
  if (!is_empty(window)) state_->change(window);
}

void MapNavigator::map_changed() { state_->change(kNoCells); }

bool MapNavigator::observe(const LidarScan& scan, const Eigen::Vector2d& position) {
  return state_->observe(scan, position);
}

void MapNavigator::set_goal(const Goal& goal) { state_->set_task(task_of(goal)); }

void MapNavigator::follow(Path path, const std::optional<double>& goal_heading) {
  if (path.waypoints.empty()) {
    cancel();
    return;
  }
  state_->set_task(task_of(std::move(path), goal_heading));
}

void MapNavigator::cancel() {
  state_->task.end();
  state_->navigator->cancel();
}

void MapNavigator::set_zones(const Zones& zones) { state_->set_zones(zones); }
void MapNavigator::hold() noexcept { state_->hold = true; }
void MapNavigator::resume() noexcept { state_->hold = false; }
bool MapNavigator::on_hold() const noexcept { return state_->hold; }

void MapNavigator::reset(const Twist2& actual) noexcept { state_->navigator->reset(actual); }

void MapNavigator::replace_last(const Twist2& sent) noexcept {
  state_->navigator->replace_last(sent);
}

void MapNavigator::set_settings(const Settings& settings) { state_->set_settings(settings); }

NavigationStep MapNavigator::update(const Measurements& measurements) {
  return state_->update(measurements);
}

bool MapNavigator::plan_now(const Measurements& measurements) {
  state_->plan_if_needed(measurements, true);
  return state_->follows_new_plan;
}

SharedMotion MapNavigator::share(std::uint32_t robot,
                                 double time,
                                 const Pose2& pose) const noexcept {
  return state_->navigator->share(robot, time, pose);
}

const Settings& MapNavigator::settings() const noexcept { return state_->settings; }
const Plan& MapNavigator::plan() const noexcept { return state_->navigator->plan(); }
const std::string& MapNavigator::explanation() const noexcept {
  return state_->planning->explanation();
}

bool MapNavigator::plan_is_current() const noexcept { return state_->plan_is_current; }
bool MapNavigator::follows_new_plan() const noexcept { return state_->follows_new_plan; }

bool MapNavigator::planned() const noexcept { return state_->planned; }

MovingObstacles MapNavigator::tracked() const noexcept {
  return state_->perception ? state_->perception->tracker().obstacles() : MovingObstacles{};
}

const BitGrid* MapNavigator::obstacles() const noexcept { return state_->obstacles(); }
void MapNavigator::wait_for_plan() const noexcept { state_->planning->wait(); }

void MapNavigator::lend_clock(std::function<double()> clock) {
  state_->clock = std::move(clock);
  state_->planning->lend_clock(state_->clock);
}

double MapNavigator::planning_seconds() const noexcept {
  return state_->planned ? state_->planning->seconds() : 0.0;
}

const Navigator& MapNavigator::navigator() const noexcept { return *state_->navigator; }
const NavigationInput& MapNavigator::input() const noexcept { return state_->input; }

StepExplanation MapNavigator::explain(const NavigationStep& step, double speed) const {
  if (step.limit == LimitingFactor::NoPath && state_->plan_is_current && !plan().usable()) {
    return {.kind = StepExplanation::Kind::Path,
            .text = explanation().empty() ? plan().reason() : explanation()};
  }
  return explain_step(*state_->navigator, step, state_->input, speed);
}

}  // namespace fairway
