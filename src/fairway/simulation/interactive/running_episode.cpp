// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/interactive/running_episode.hpp"

#include <algorithm>
#include <utility>

#include "fairway/mpc/interior_point/real_time_solver.hpp"
#include "fairway/zones/zone_map.hpp"

namespace fairway {

Episode::Episode(const Scenario& scenario, const EpisodeHooks& hooks)
    : scenario_(scenario),
      hooks_(hooks),
      settings_(scenario.settings),
      tasks_(scenario.robots),
      world_(scenario, hooks.physics ? hooks.physics(scenario) : nullptr),
      map_(world_.obstacles()),
      radio_(scenario.radio, scenario.robots.size(), scenario.seed) {
  if (hooks_.observer != nullptr) hooks_.observer->on_start(scenario);
  for (const RobotTask& task : scenario.robots) {
    goals_.push_back(task.idle ? std::nullopt : std::optional(task.goal));
    result_.robots.push_back(
        {.name = task.name, .status_counts = std::vector<int>(kNavigationStatuses)});
  }
  commands_.resize(goals_.size());
  done_.resize(goals_.size());
  make_drivers();
  head_for_goals();
}
EpisodeResult Episode::run() {
  while (cycle()) {
  }
  finish();
  return std::move(result_);
}

bool Episode::cycle() {
  const bool time_left = cycles_++ * settings_.navigation.control_period < scenario_.time_limit;
  show_world();
  measure();
  for (std::size_t i = 0; i < drivers_.size(); ++i)
    control(i);
  const bool all_done = std::all_of(done_.begin(), done_.end(), [](bool done) { return done; });
  if (!hooks_.play && (all_done || !time_left)) return false;
  if (hooks_.on_cycle && !hooks_.on_cycle(world_.time())) return false;
  advance(settings_.navigation.control_period);
  return !hooks_.play || hooks_.play(*this);
}

void Episode::make_drivers() {
  map_.set_zones(scenario_.zones.empty()
                     ? nullptr
                     : std::make_shared<const ZoneMap>(scenario_.zones, settings_.robot.radius));
  if (hooks_.solver == nullptr) own_solver_ = std::make_unique<RealTimeSolver>(settings_.mpc);
  ControlSolver* solver = hooks_.solver == nullptr ? own_solver_.get() : hooks_.solver;
  if (hooks_.clock) solver = &timed_solver_.emplace(*solver, hooks_.clock);
  const DriverContext context{.scenario = scenario_,
                              .settings = settings_,
                              .map = map_,
                              .planner = planner_,
                              .solver = *solver,
                              .radio = radio_,
                              .observer = hooks_.observer,
                              .clock = hooks_.clock,
                              .entrances = hooks_.entrances};
  drivers_.clear();
  std::vector<NavigatorStart> starts;
  for (std::size_t i = 0; i < goals_.size(); ++i) {
    drivers_.push_back(make_driver(context, world_, i, result_.robots[i]));
    starts.push_back({.pose = world_.robots()[i].pose, .twist = world_.robots()[i].twist});
    // A new driver says where it is; a robot that was removed is nowhere.
    if (world_.encounters()[i].absent) radio_.forget(i);
  }
  if (hooks_.observer != nullptr) {
    hooks_.observer->on_navigators(world_.time(), settings_, starts);
  }
}

void Episode::head_for_goal(std::size_t i) {
  if (hooks_.observer != nullptr) hooks_.observer->on_goal(world_.time(), i, *goals_[i]);
  if (drivers_[i]->head_for(*goals_[i], world_)) show_plan(i);
}

void Episode::head_for_goals() {
  for (std::size_t i = 0; i < drivers_.size(); ++i) {
    if (goals_[i] && !done_[i] && !world_.encounters()[i].absent) head_for_goal(i);
  }
}

void Episode::start_again() {
  make_drivers();
  head_for_goals();
}

void Episode::measure() {
  for (const auto& driver : drivers_)
    driver->measure(world_);
}

void Episode::advance(double dt) {
  constexpr double kSameTime = 1e-9;  // [s]
  const double end = world_.time() + dt;
  double left = dt;
  while (true) {
    double next = end;
    for (const auto& driver : drivers_)
      next = std::min(next, driver->next_measurement());
    if (next >= end - kSameTime) break;
    world_.advance(commands_, next - world_.time());
    measure();
    left = end - world_.time();
  }
  world_.advance(commands_, left);
}

void Episode::control(std::size_t i) {
  RobotResult& result = result_.robots[i];
  if (world_.encounters()[i].absent) {
    command(i, {});
    return;
  }
  if (halted_) {
    command(i, {});
    drivers_[i]->tell_standing(world_);
    return;
  }
  if (done_[i] || world_.encounters()[i].collided) {
    done_[i] = true;
    command(i, {});
    drivers_[i]->tell_standing(world_);
    return;
  }
  const DrivenCycle cycle = drivers_[i]->drive(world_);
  const NavigationStep& step = cycle.step;
  if (hooks_.clock) {
    result.cycle_seconds.push_back(cycle.seconds);
    result.solve_seconds.push_back(timed_solver_->take_seconds());
  }
  command(i, step);
  if (cycle.new_plan) show_plan(i);
  record(i, cycle);
  const bool is_last =
      world_.time() + 1.5 * settings_.navigation.control_period > scenario_.time_limit;
  if (is_last && !hooks_.play)
    result.explanation = drivers_[i]->explain(step, world_.robots()[i].twist.linear);
  if (step.status == NavigationStatus::GoalReached) {
    result.reached = true;
    result.time = world_.time();
    done_[i] = true;
  }
}

void Episode::command(std::size_t i, const NavigationStep& step) {
  commands_[i] = step.command;
  const BodyRobot* robot = world_.model_of(i);
  if (robot == nullptr) return;
  const bool steered = is_steered(robot->model.base);
  world_.send(i, {.linear = step.command.linear,
                  .lateral = step.lateral,
                  .turn = steered ? step.steering : step.command.angular});
}

void Episode::record(std::size_t i, const DrivenCycle& cycle) {
  const NavigationStep& step = cycle.step;
  RobotResult& result = result_.robots[i];
  const UnicycleRobot& robot = world_.robots()[i];
  const double clearance = world_.clearance(i);
  if (hooks_.observer != nullptr) {
    hooks_.observer->on_cycle({.robot = i,
                               .input = cycle.input,
                               .step = step,
                               .twist = robot.twist,
                               .clearance = clearance,
                               .seconds = cycle.seconds,
                               .mark = drivers_[i]->mark(step),
                               .occupied = cycle.occupied});
  }
  ++result.cycles;
  ++result.status_counts[static_cast<std::size_t>(step.status)];
  if (hooks_.play) return;
  result_.trace.rows.push_back({.time = world_.time(),
                                .robot = i,
                                .pose = robot.pose,
                                .twist = robot.twist,
                                .command = step.command,
                                .status = step.status,
                                .limit = step.limit,
                                .rectangle = step.rectangle,
                                .clearance = clearance});
  const BodyRobot* model = world_.model_of(i);
  if (model == nullptr || model->model.base.kind != BaseKind::Omni) return;
  result_.trace.rows.back().lateral = model->twist().lateral;
  result_.trace.lateral = true;
}

void Episode::show_plan(std::size_t i) {
  if (hooks_.observer != nullptr) {
    hooks_.observer->on_plan(world_.time(), i, drivers_[i]->plan());
  }
}

void Episode::show_world() {
  if (hooks_.observer == nullptr) return;
  bodies_.clear();
  for (std::size_t i = 0; i < world_.num_bodies(); ++i)
    bodies_.push_back(world_.body(i).at(world_.time()));
  hooks_.observer->on_world({.time = world_.time(),
                             .obstacles = &world_.obstacles(),
                             .bodies = bodies_,
                             .robots = world_.robots(),
                             .encounters = world_.encounters()});
}

void Episode::finish() {
  result_.time = world_.time();
  result_.success = true;
  std::vector<Eigen::Vector2d> last;
  for (const RobotTask& task : scenario_.robots)
    last.push_back(task.start.position);
  for (const TraceRow& row : result_.trace.rows) {
    result_.robots[row.robot].length += (row.pose.position - last[row.robot]).norm();
    last[row.robot] = row.pose.position;
  }
  for (std::size_t i = 0; i < result_.robots.size(); ++i) {
    RobotResult& robot = result_.robots[i];
    const Encounter& met = world_.encounters()[i];
    robot.collided = met.collided;
    robot.approach = met.approach;
    robot.contact = met.contact;
    robot.min_clearance = met.min_clearance;
    robot.min_separation = met.min_separation;
    robot.zones = met.zones;
    robot.plan = drivers_[i]->plan();
    if (!robot.reached) robot.time = met.collided ? met.collision_time : world_.time();
    result_.success = result_.success && robot.reached && !robot.collided && robot.zones.none();
  }
}

EpisodeResult run_episode(const Scenario& scenario, const EpisodeHooks& hooks) {
  return Episode(scenario, hooks).run();
}

}  // namespace fairway
