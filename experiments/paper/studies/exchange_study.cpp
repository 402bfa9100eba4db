// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/studies/exchange_study.hpp"

#include <algorithm>
#include <limits>
#include <memory>

#include "experiments/paper/studies/parallel_runs.hpp"
#include "fairway/simulation/scenarios/swap_scenario.hpp"

namespace fairway::reproduction {

namespace {

using Eigen::Vector2d;

constexpr double kExchangeBody = 0.25;       // [m]
constexpr double kPaperKeepOut = 0.8;        // R_o [m]
constexpr double kExchangeTimeLimit = 90.0;  // about ten times the time of the straight path [s]

Settings exchange_settings(ExchangeKind kind, const Settings& ours) {
  Settings settings = kind == ExchangeKind::Ismpc ? paper_settings() : ours;
  settings.robot.radius = kExchangeBody;
  if (kind == ExchangeKind::Ismpc) {
    settings.prediction.obstacle_margin = kPaperKeepOut - 2.0 * kExchangeBody;
    settings.navigation.stall_timeout = 1000.0;  // the paper has no recovery
  }
  return settings;
}

// Records the positions and predicted trajectories of all robots.
class MomentRecorder final : public EpisodeObserver {
 public:
  explicit MomentRecorder(std::vector<ExchangeMoment>& moments) : moments_(moments) {}

  void on_start(const Scenario& /*scenario*/) override {}
  void on_navigators(double /*time*/,
                     const Settings& /*settings*/,
                     std::span<const NavigatorStart> /*starts*/) override {}
  void on_plan(double /*time*/, std::size_t /*robot*/, const Plan& /*plan*/) override {}

  void on_world(const WorldView& world) override {
    ExchangeMoment& moment = moments_.emplace_back();
    moment.time = world.time;
    for (std::size_t i = 0; i < kExchangeRobots; ++i)
      moment.poses.at(i) = world.robots[i].pose;
  }

  void on_cycle(const NavigationCycle& cycle) override {
    const MpcSolution* plan = cycle.step.plan;
    if (plan == nullptr || moments_.empty()) return;
    std::vector<Vector2d>& shown = moments_.back().plans.at(cycle.robot);
    for (std::size_t k = 0; k <= static_cast<std::size_t>(plan->horizon); ++k)
      shown.push_back(plan->poses.at(k).position);
  }

 private:
  std::vector<ExchangeMoment>& moments_;
};

}  // namespace

const char* to_text(ExchangeKind kind) noexcept {
  switch (kind) {
    case ExchangeKind::Ismpc:
      return "ISMPC (the paper's)";
    case ExchangeKind::Ours:
      return "Fairway";
  }
  return "unknown";
}

double keep_out_distance(const Settings& settings) noexcept {
  return 2.0 * settings.robot.radius + settings.prediction.obstacle_margin;
}

double Exchange::nearest(const ExchangeMoment& moment, std::size_t robot) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < kExchangeRobots; ++i) {
    if (i == robot) continue;
    const Vector2d way = moment.poses.at(i).position - moment.poses.at(robot).position;
    least = std::min(least, way.norm());
  }
  return least;
}

Scenario exchange_scenario(std::uint64_t seed, ExchangeKind kind, const Settings& ours) {
  Scenario scenario = swap_scenario(static_cast<int>(kExchangeRobots), kExchangeRadius,
                                    exchange_settings(kind, ours), seed + 1);
  scenario.time_limit = kExchangeTimeLimit;
  // The paper's robots share positions and speeds, which every robot sees here anyway.
  scenario.radio.on = kind == ExchangeKind::Ours;
  return scenario;
}

Exchange exchange(const Scenario& scenario, const StudyOptions& options) {
  Exchange run{.settings = scenario.settings};
  MomentRecorder recorder(run.moments);
  const std::unique_ptr<ControlSolver> solver =
      options.make_solver ? options.make_solver() : nullptr;
  const EpisodeResult result = run_episode(
      scenario, {.clock = options.clock, .solver = solver.get(), .observer = &recorder});
  run.all_reached = true;
  run.min_separation = std::numeric_limits<double>::infinity();
  std::vector<double> cycles;
  for (std::size_t i = 0; i < result.robots.size(); ++i) {
    const RobotResult& robot = result.robots[i];
    run.all_reached = run.all_reached && robot.reached;
    run.contacts += robot.collided ? 1 : 0;
    run.time = std::max(run.time, robot.time);
    run.min_separation = std::min(run.min_separation, robot.min_separation);
    const RobotTask& task = scenario.robots[i];
    run.goals.at(i) = task.goal.position;
    run.bound = std::max(run.bound, (task.goal.position - task.start.position).norm() /
                                        scenario.settings.robot.linear_max);
    cycles.insert(cycles.end(), robot.cycle_seconds.begin(), robot.cycle_seconds.end());
  }
  run.cycle = quantiles(cycles);
  return run;
}

std::vector<ExchangeComparison> compare_exchanges(int runs, const StudyOptions& options) {
  return run_all(
      static_cast<std::size_t>(runs), options, "robots that exchange places", [&](std::size_t i) {
        ExchangeComparison one;
        for (std::size_t k = 0; k < kExchangeKinds; ++k) {
          one.at(k) = exchange(
              exchange_scenario(options.seed + i, static_cast<ExchangeKind>(k), options.ours),
              options);
        }
        return one;
      });
}

}  // namespace fairway::reproduction
