// SPDX-License-Identifier: Apache-2.0
#include "exchange_study.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <numbers>
#include <random>

#include "fairway/geometry/angle.hpp"
#include "parallel_runs.hpp"

namespace fairway::reproduction {

namespace {

using Eigen::Vector2d;

constexpr double kBodyRadius = 0.25;   // [m]
constexpr double kPaperKeepOut = 0.8;  // R_o [m]
constexpr double kCircle = 4.0;        // radius of the circle that they start on [m]
constexpr double kSide = 16.0;         // of the open square [m]
constexpr double kStartNoise = 0.05;   // [m]
constexpr double kTimeLimit = 90.0;    // some ten times what the straight way takes [s]

Settings exchange_settings(ExchangeKind kind) {
  Settings settings = kind == ExchangeKind::Ismpc ? paper_settings() : Settings{};
  settings.robot.radius = kBodyRadius;
  if (kind == ExchangeKind::Ismpc) {
    settings.navigation.obstacle_margin = kPaperKeepOut - 2.0 * kBodyRadius;
    settings.navigation.blocked_after = 1000.0;  // the paper has no recovery
  }
  return settings;
}

// Keeps where everybody was and meant to go.
class MomentRecorder final : public EpisodeObserver {
 public:
  explicit MomentRecorder(std::vector<ExchangeMoment>& moments) : moments_(moments) {}

  void on_start(const Scenario& /*scenario*/) override {}
  void on_navigators(double /*time*/,
                     const Settings& /*settings*/,
                     std::span<const Twist2> /*twists*/) override {}
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
      return "ours";
  }
  return "unknown";
}

double keep_out_distance(const Settings& settings) noexcept {
  return 2.0 * settings.robot.radius + settings.navigation.obstacle_margin;
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

Scenario exchange_scenario(std::uint64_t seed, ExchangeKind kind) {
  constexpr double kCell = 0.05;
  Scenario scenario;
  scenario.name = to_text(kind);
  const int cells = static_cast<int>(kSide / kCell);
  scenario.map =
      OccupancyGrid({.width = cells, .height = cells, .resolution = kCell, .origin = {}});
  scenario.settings = exchange_settings(kind);
  scenario.time_limit = kTimeLimit;
  std::mt19937_64 engine(seed);
  const auto noise = [&] {
    return kStartNoise * (static_cast<double>(engine() >> 11U) * 0x1.0p-52 - 1.0);
  };
  const Vector2d center = Vector2d::Constant(0.5 * kSide);
  for (std::size_t i = 0; i < kExchangeRobots; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / kExchangeRobots;
    const double x = noise();
    const Vector2d off(x, noise());
    const Vector2d way = kCircle * direction(angle);
    scenario.robots.push_back(
        {.name = fmt::format("robot {}", i + 1),
         .start = {.position = center + way + off, .heading = wrap_to_pi(angle + std::numbers::pi)},
         .goal = {.position = center - way, .heading = std::nullopt}});
  }
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
                                        scenario.settings.mpc.linear_max);
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
          one.at(k) =
              exchange(exchange_scenario(options.seed + i, static_cast<ExchangeKind>(k)), options);
        }
        return one;
      });
}

}  // namespace fairway::reproduction
