// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/episode.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "fairway/base/contract.hpp"
#include "fairway/map/free_space.hpp"
#include "fairway/mpc/real_time_solver.hpp"
#include "fairway/simulation/sensed_episode.hpp"

namespace fairway {

namespace {

constexpr std::size_t kStatuses = static_cast<std::size_t>(NavigationStatus::GoalReached) + 1;

// A solver that adds up what it takes, on a lent clock.
class TimedSolver final : public ControlSolver {
 public:
  TimedSolver(ControlSolver& solver, const std::function<double()>& clock)
      : solver_(solver),
        clock_(clock) {}

  const MpcSolution& solve(const ControlProblem& problem,
                           const InitialGuess& guess) noexcept override {
    const double before = clock_();
    const MpcSolution& solution = solver_.solve(problem, guess);
    seconds_ += clock_() - before;
    return solution;
  }

  // What was taken since the last call.
  double take_seconds() noexcept { return std::exchange(seconds_, 0.0); }

 private:
  ControlSolver& solver_;
  const std::function<double()>& clock_;
  double seconds_ = 0.0;
};

class Episode final : public EpisodeControl {
 public:
  Episode(const Scenario& scenario, const EpisodeHooks& hooks)
      : scenario_(scenario),
        hooks_(hooks),
        settings_(scenario.settings),
        world_(scenario),
        map_(world_.obstacles()) {
    if (hooks_.observer != nullptr) hooks_.observer->on_start(scenario);
    for (const RobotTask& task : scenario.robots) {
      goals_.push_back(task.goal);
      result_.robots.push_back({.name = task.name, .status_counts = std::vector<int>(kStatuses)});
    }
    commands_.resize(goals_.size());
    done_.resize(goals_.size());
    make_navigators();
    for (std::size_t i = 0; i < navigators_.size(); ++i)
      replan(i);
  }

  EpisodeResult run() {
    for (int cycle = 0;; ++cycle) {
      const bool time_left = cycle * settings_.mpc.dt < scenario_.time_limit;
      show_world();
      for (std::size_t i = 0; i < navigators_.size(); ++i)
        control(i);
      const bool all_done = std::all_of(done_.begin(), done_.end(), [](bool done) { return done; });
      if (!hooks_.play && (all_done || !time_left)) break;
      if (hooks_.on_cycle && !hooks_.on_cycle(world_.time())) break;
      world_.advance(commands_, settings_.mpc.dt);
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
    replan(robot);
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
    map_.distances.update(map_.obstacles, changed);
    replan_all();
  }

  void set_body(std::size_t index, const MovingBody& body) override {
    world_.set_body(index, body);
  }

  void remove_body(std::size_t index) override { world_.remove_body(index); }

  void set_settings(const Settings& settings) override {
    settings_ = settings;
    world_.set_robots(settings);
    make_navigators();
    replan_all();
  }

 private:
  [[nodiscard]] double now() const { return hooks_.clock ? hooks_.clock() : 0.0; }

  // One for every robot, which goes on as it moves now, but without a plan.
  void make_navigators() {
    if (hooks_.solver == nullptr) own_solver_ = std::make_unique<RealTimeSolver>(settings_.mpc);
    ControlSolver* solver = hooks_.solver == nullptr ? own_solver_.get() : hooks_.solver;
    if (hooks_.clock) {
      timed_solver_ = std::make_unique<TimedSolver>(*solver, hooks_.clock);
      solver = timed_solver_.get();
    }
    navigators_.clear();
    std::vector<Twist2> twists;
    for (const UnicycleRobot& robot : world_.robots()) {
      navigators_.emplace_back(settings_, *solver).reset(robot.twist);
      twists.push_back(robot.twist);
    }
    if (hooks_.observer != nullptr) {
      hooks_.observer->on_navigators(world_.time(), settings_, twists);
    }
  }

  void replan(std::size_t i) {
    const double before = now();
    navigators_[i].follow(
        planner_.plan(map_, world_.robots()[i].pose.position, goals_[i], settings_));
    if (hooks_.clock) result_.robots[i].plan_seconds.push_back(now() - before);
    if (hooks_.observer != nullptr) {
      hooks_.observer->on_plan(world_.time(), i, navigators_[i].plan());
    }
  }

  void replan_all() {
    for (std::size_t i = 0; i < navigators_.size(); ++i) {
      if (!done_[i]) replan(i);
    }
  }

  void control(std::size_t i) {
    RobotResult& result = result_.robots[i];
    const UnicycleRobot& robot = world_.robots()[i];
    if (done_[i] || world_.encounters()[i].collided) {
      done_[i] = true;
      commands_[i] = {};
      return;
    }
    world_.moving_around(i, seen_);
    const NavigationInput input{.time = world_.time(),
                                .pose = robot.pose,
                                .pose_time = world_.time(),
                                .obstacles = seen_,
                                .obstacles_time = world_.time(),
                                .map = &world_.obstacles(),
                                .map_time = world_.time()};
    const double before = now();
    const NavigationStep step = navigators_[i].update(input);
    const double seconds = now() - before;
    if (hooks_.clock) {
      result.cycle_seconds.push_back(seconds);
      result.solve_seconds.push_back(timed_solver_->take_seconds());
    }
    commands_[i] = step.command;
    record(i, input, step, seconds);
    if (step.status == NavigationStatus::GoalReached) {
      result.reached = true;
      result.time = world_.time();
      done_[i] = true;
    } else if (step.wants_plan) {
      replan(i);
    }
  }

  void record(std::size_t i,
              const NavigationInput& input,
              const NavigationStep& step,
              double seconds) {
    RobotResult& result = result_.robots[i];
    const UnicycleRobot& robot = world_.robots()[i];
    const double radius = settings_.robot.radius;
    const double clearance = distance_to_blocked(world_.obstacles(), robot.pose.position,
                                                 radius + World::kClearanceLimit) -
                             radius;
    if (hooks_.observer != nullptr) {
      hooks_.observer->on_cycle({.robot = i,
                                 .input = input,
                                 .step = step,
                                 .twist = robot.twist,
                                 .clearance = clearance,
                                 .seconds = seconds,
                                 .mark = limit_mark(navigators_[i], step)});
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
      robot.min_clearance = met.min_clearance;
      robot.min_separation = met.min_separation;
      robot.plan = navigators_[i].plan();
      if (!robot.reached) robot.time = met.collided ? met.collision_time : world_.time();
      result_.success = result_.success && robot.reached && !robot.collided;
    }
  }

  const Scenario& scenario_;
  EpisodeHooks hooks_;
  Settings settings_;
  std::vector<Goal> goals_;
  std::unique_ptr<ControlSolver> own_solver_;
  std::unique_ptr<TimedSolver> timed_solver_;
  World world_;
  PreparedMap map_;
  Planner planner_;
  std::vector<Navigator> navigators_;
  std::vector<Twist2> commands_;
  std::vector<bool> done_;
  std::vector<MovingObstacle> seen_;
  std::vector<MovingObstacle> bodies_;
  EpisodeResult result_;
};

}  // namespace

EpisodeResult run_episode(const Scenario& scenario, const EpisodeHooks& hooks) {
  if (scenario.sensing.sensing != Sensing::Map || hooks.physics) {
    return run_sensed_episode(scenario, hooks);
  }
  return Episode(scenario, hooks).run();
}

}  // namespace fairway
