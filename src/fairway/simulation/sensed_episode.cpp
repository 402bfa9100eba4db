// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/sensed_episode.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "fairway/map/free_space.hpp"
#include "fairway/mpc/real_time_solver.hpp"
#include "fairway/simulation/robot_driver.hpp"

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

class SensedEpisode {
 public:
  SensedEpisode(const Scenario& scenario, const EpisodeHooks& hooks)
      : scenario_(scenario),
        hooks_(hooks),
        world_(scenario, hooks.physics ? hooks.physics(scenario) : nullptr),
        map_(scenario.map) {
    if (hooks_.solver == nullptr) {
      own_solver_ = std::make_unique<RealTimeSolver>(scenario.settings.mpc);
      hooks_.solver = own_solver_.get();
    }
    if (hooks_.clock) {
      timed_solver_ = std::make_unique<TimedSolver>(*hooks_.solver, hooks_.clock);
      hooks_.solver = timed_solver_.get();
    }
    for (const RobotTask& task : scenario.robots)
      result_.robots.push_back({.name = task.name, .status_counts = std::vector<int>(kStatuses)});
    const DriverContext context{.scenario = scenario_,
                                .map = map_,
                                .planner = planner_,
                                .solver = *hooks_.solver,
                                .clock = hooks_.clock};
    for (std::size_t i = 0; i < result_.robots.size(); ++i)
      drivers_.push_back(make_driver(context, world_, i, result_.robots[i]));
    commands_.resize(drivers_.size());
    done_.resize(drivers_.size());
  }

  EpisodeResult run() {
    const double dt = scenario_.settings.mpc.dt;
    for (int cycle = 0;; ++cycle) {
      const bool time_left = cycle * dt < scenario_.time_limit;
      for (std::size_t i = 0; i < drivers_.size(); ++i)
        control(i);
      const bool all_done = std::all_of(done_.begin(), done_.end(), [](bool done) { return done; });
      if (all_done || !time_left || (hooks_.on_cycle && !hooks_.on_cycle(world_.time()))) break;
      advance(dt);
    }
    finish();
    return std::move(result_);
  }

 private:
  // Lets the world go on for one cycle, with stops where something is measured.
  void advance(double dt) {
    constexpr double kSameTime = 1e-9;  // [s]
    const double end = world_.time() + dt;
    while (true) {
      double next = end;
      for (const auto& driver : drivers_)
        next = std::min(next, driver->next_measurement());
      if (next >= end - kSameTime) break;
      world_.advance(commands_, next - world_.time());
      for (const auto& driver : drivers_)
        driver->measure(world_);
    }
    world_.advance(commands_, end - world_.time());
  }

  void control(std::size_t i) {
    RobotResult& result = result_.robots[i];
    if (done_[i] || world_.encounters()[i].collided) {
      done_[i] = true;
      commands_[i] = {};
      drivers_[i]->measure(world_);
      return;
    }
    const NavigationStep step = drivers_[i]->drive(world_);
    if (hooks_.clock) result.solve_seconds.push_back(timed_solver_->take_seconds());
    commands_[i] = step.command;
    record(i, step);
    if (step.status == NavigationStatus::GoalReached) {
      result.reached = true;
      result.time = world_.time();
      done_[i] = true;
    }
  }

  void record(std::size_t i, const NavigationStep& step) {
    RobotResult& result = result_.robots[i];
    const UnicycleRobot& robot = world_.robots()[i];
    const double radius = scenario_.settings.robot.radius;
    ++result.cycles;
    ++result.status_counts[static_cast<std::size_t>(step.status)];
    result_.trace.rows.push_back(
        {.time = world_.time(),
         .robot = i,
         .pose = robot.pose,
         .twist = robot.twist,
         .command = step.command,
         .status = step.status,
         .limit = step.limit,
         .rectangle = step.rectangle,
         .clearance = distance_to_blocked(world_.obstacles(), robot.pose.position,
                                          radius + World::kClearanceLimit) -
                      radius});
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
      robot.plan = drivers_[i]->plan();
      if (!robot.reached) robot.time = met.collided ? met.collision_time : world_.time();
      result_.success = result_.success && robot.reached && !robot.collided;
    }
  }

  const Scenario& scenario_;
  EpisodeHooks hooks_;
  std::unique_ptr<ControlSolver> own_solver_;
  std::unique_ptr<TimedSolver> timed_solver_;
  World world_;
  PreparedMap map_;
  Planner planner_;
  std::vector<std::unique_ptr<RobotDriver>> drivers_;
  std::vector<Twist2> commands_;
  std::vector<bool> done_;
  EpisodeResult result_;
};

}  // namespace

EpisodeResult run_sensed_episode(const Scenario& scenario, const EpisodeHooks& hooks) {
  return SensedEpisode(scenario, hooks).run();
}

}  // namespace fairway
