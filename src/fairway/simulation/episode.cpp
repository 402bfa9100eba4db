// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/episode.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "fairway/base/contract.hpp"
#include "fairway/mpc/interior_point/real_time_solver.hpp"
#include "fairway/simulation/robot_driver.hpp"
#include "fairway/simulation/timed_solver.hpp"

namespace fairway {

namespace {

class Episode final : public EpisodeControl {
 public:
  Episode(const Scenario& scenario, const EpisodeHooks& hooks)
      : scenario_(scenario),
        hooks_(hooks),
        settings_(scenario.settings),
        world_(scenario, hooks.physics ? hooks.physics(scenario) : nullptr),
        map_(world_.obstacles()),
        radio_(scenario.radio, scenario.robots.size(), scenario.seed) {
    if (hooks_.observer != nullptr) hooks_.observer->on_start(scenario);
    for (const RobotTask& task : scenario.robots) {
      goals_.push_back(task.goal);
      result_.robots.push_back(
          {.name = task.name, .status_counts = std::vector<int>(kNavigationStatuses)});
    }
    commands_.resize(goals_.size());
    done_.resize(goals_.size());
    make_drivers();
    for (std::size_t i = 0; i < drivers_.size(); ++i)
      head_for_goal(i);
  }

  // Senses, controls and moves until every robot has stopped at its goal or the time is up.
  EpisodeResult run() {
    for (int cycle = 0;; ++cycle) {
      const bool time_left = cycle * settings_.navigation.control_period < scenario_.time_limit;
      show_world();
      measure();
      for (std::size_t i = 0; i < drivers_.size(); ++i)
        control(i);
      const bool all_done = std::all_of(done_.begin(), done_.end(), [](bool done) { return done; });
      if (!hooks_.play && (all_done || !time_left)) break;
      if (hooks_.on_cycle && !hooks_.on_cycle(world_.time())) break;
      advance(settings_.navigation.control_period);
      if (hooks_.play && !hooks_.play(*this)) break;
    }
    finish();
    return std::move(result_);
  }

  [[nodiscard]] const World& world() const override { return world_; }

  void set_goal(std::size_t robot, const Goal& goal) override {
    FAIRWAY_EXPECTS(robot < goals_.size());
    goals_[robot] = goal;
    done_[robot] = false;
    result_.robots[robot].reached = false;
    head_for_goal(robot);
  }

  void set_cells(std::span<const CellIndex> cells, bool blocked) override {
    CellWindow changed{.first = {.x = OccupancyGrid::kMaxSide, .y = OccupancyGrid::kMaxSide},
                       .last = {.x = -1, .y = -1}};
    for (const CellIndex cell : cells) {
      if (!world_.set_blocked(cell, blocked)) continue;
      map_.obstacles.set(cell, blocked);
      changed.first = {.x = std::min(changed.first.x, cell.x),
                       .y = std::min(changed.first.y, cell.y)};
      changed.last = {.x = std::max(changed.last.x, cell.x), .y = std::max(changed.last.y, cell.y)};
    }
    if (changed.last.x < 0) return;
    map_.measure(changed);
    for (std::size_t i = 0; i < drivers_.size(); ++i) {
      if (!done_[i] && drivers_[i]->note_map_change(world_)) show_plan(i);
    }
  }

  void set_body(std::size_t index, const MovingBody& body) override {
    world_.set_body(index, body);
  }

  void remove_body(std::size_t index) override { world_.remove_body(index); }

  void set_settings(const Settings& settings) override {
    settings_ = settings;
    world_.set_robots(settings);
    make_drivers();
    for (std::size_t i = 0; i < drivers_.size(); ++i) {
      if (!done_[i]) head_for_goal(i);
    }
  }

 private:
  // Makes a driver without a plan for every robot; the robot keeps its current motion.
  void make_drivers() {
    if (!scenario_.zones.empty()) {
      map_.set_zones(std::make_shared<const ZoneMap>(scenario_.zones, settings_.robot.radius));
    }
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
                                .clock = hooks_.clock};
    drivers_.clear();
    std::vector<NavigatorStart> starts;
    for (std::size_t i = 0; i < goals_.size(); ++i) {
      drivers_.push_back(make_driver(context, world_, i, result_.robots[i]));
      starts.push_back({.pose = world_.robots()[i].pose, .twist = world_.robots()[i].twist});
    }
    if (hooks_.observer != nullptr) {
      hooks_.observer->on_navigators(world_.time(), settings_, starts);
    }
  }

  void head_for_goal(std::size_t i) {
    if (hooks_.observer != nullptr) hooks_.observer->on_goal(world_.time(), i, goals_[i]);
    if (drivers_[i]->head_for(goals_[i], world_)) show_plan(i);
  }

  void measure() {
    for (const auto& driver : drivers_)
      driver->measure(world_);
  }

  // Advances the world by one cycle, and pauses at each time at which a driver measures.
  void advance(double dt) {
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

  void control(std::size_t i) {
    RobotResult& result = result_.robots[i];
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
    if (step.status == NavigationStatus::GoalReached) {
      result.reached = true;
      result.time = world_.time();
      done_[i] = true;
    }
  }

  void command(std::size_t i, const NavigationStep& step) {
    commands_[i] = step.command;
    const BodyRobot* robot = world_.model_of(i);
    if (robot == nullptr) return;
    const bool steered = is_steered(robot->model.base);
    world_.send(i, {.linear = step.command.linear,
                    .lateral = step.lateral,
                    .turn = steered ? step.steering : step.command.angular});
  }

  void record(std::size_t i, const DrivenCycle& cycle) {
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

  void show_plan(std::size_t i) {
    if (hooks_.observer != nullptr) {
      hooks_.observer->on_plan(world_.time(), i, drivers_[i]->plan());
    }
  }

  void show_world() {
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

  void finish() {
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
      robot.min_clearance = met.min_clearance;
      robot.min_separation = met.min_separation;
      robot.zones = met.zones;
      robot.plan = drivers_[i]->plan();
      if (!robot.reached) robot.time = met.collided ? met.collision_time : world_.time();
      result_.success = result_.success && robot.reached && !robot.collided && robot.zones.none();
    }
  }

  const Scenario& scenario_;
  EpisodeHooks hooks_;
  Settings settings_;
  std::vector<Goal> goals_;
  std::unique_ptr<ControlSolver> own_solver_;
  std::optional<TimedSolver> timed_solver_;
  World world_;
  PreparedMap map_;
  Planner planner_;
  FleetRadio radio_;
  std::vector<std::unique_ptr<RobotDriver>> drivers_;
  std::vector<Twist2> commands_;
  std::vector<bool> done_;
  std::vector<MovingObstacle> bodies_;
  EpisodeResult result_;
};

}  // namespace

EpisodeResult run_episode(const Scenario& scenario, const EpisodeHooks& hooks) {
  return Episode(scenario, hooks).run();
}

}  // namespace fairway
