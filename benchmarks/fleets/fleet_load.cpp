// SPDX-License-Identifier: Apache-2.0
// How many robots one core controls: robots in open space with random goals. Measures all cycles of
// a round (receiving, navigating, publishing), and the memory of one robot.
//
//   fleet_load [SECONDS] N...
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <vector>

#include "experiments/clocks.hpp"
#include "fairway/simulation/episode.hpp"
#include "fairway/simulation/recorded/metrics.hpp"

namespace {

using namespace fairway;

constexpr double kGroundPerRobot = 25.0;  // [m^2]

Scenario random_tasks(int robots) {
  const double side = std::sqrt(kGroundPerRobot * robots);
  const int cells = static_cast<int>(std::ceil(side / 0.1));
  Scenario scenario;
  scenario.name = "load";
  scenario.map = OccupancyGrid({.width = cells, .height = cells, .resolution = 0.1, .origin = {}});
  Noise noise(1);
  const auto anywhere = [&] {
    const double x = noise.uniform(1.0, side - 1.0);
    return Eigen::Vector2d(x, noise.uniform(1.0, side - 1.0));
  };
  const auto far_from = [](const Eigen::Vector2d& p, const std::vector<Eigen::Vector2d>& others) {
    return std::all_of(others.begin(), others.end(),
                       [&](const Eigen::Vector2d& other) { return (other - p).norm() > 1.2; });
  };
  std::vector<Eigen::Vector2d> starts;
  std::vector<Eigen::Vector2d> goals;
  for (int i = 0; i < robots; ++i) {
    Eigen::Vector2d start = anywhere();
    while (!far_from(start, starts))
      start = anywhere();
    Eigen::Vector2d goal = anywhere();
    while (!far_from(goal, goals))
      goal = anywhere();
    starts.push_back(start);
    goals.push_back(goal);
    const double heading = noise.uniform(-std::numbers::pi, std::numbers::pi);
    scenario.robots.push_back({.name = "robot " + std::to_string(i + 1),
                               .start = {.position = start, .heading = heading},
                               .goal = {.position = goal, .heading = {}}});
  }
  return scenario;
}

void run(int robots, double seconds) {
  Scenario scenario = random_tasks(robots);
  scenario.time_limit = seconds;
  EpisodeHooks hooks;
  hooks.clock = thread_cpu_seconds;
  const EpisodeResult result = run_episode(scenario, hooks);
  std::vector<double> rounds;
  int contacts = 0;
  int arrived = 0;
  for (const RobotResult& robot : result.robots) {
    rounds.resize(std::max(rounds.size(), robot.cycle_seconds.size()));
    for (std::size_t k = 0; k < robot.cycle_seconds.size(); ++k)
      rounds[k] += robot.cycle_seconds[k];
    contacts += robot.collided ? 1 : 0;
    arrived += robot.reached ? 1 : 0;
  }
  const Quantiles round = quantiles(rounds);
  std::printf(
      "%5d robots: a round takes %.1f ms (median), %.1f ms (p99), %.1f ms (max); arrived %d, "
      "contact %d after %.0f s\n",
      robots, 1e3 * round.median, 1e3 * round.p99, 1e3 * round.max, arrived, contacts, result.time);
  std::fflush(stdout);
}

// Bytes in use. Large blocks are mapped one by one and are not part of the heap.
std::size_t bytes_in_use() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

// The memory of one more navigator that follows a plan.
void memory() {
  const Scenario scenario = random_tasks(200);
  const PreparedMap map(scenario.map);
  Planner planner;
  std::vector<Plan> plans;
  for (const RobotTask& task : scenario.robots)
    plans.push_back(
        planner.plan(map, task.start.position, task.goal, planner_settings(scenario.settings)));
  std::vector<std::unique_ptr<Navigator>> navigators;
  class NoSolver final : public ControlSolver {
    MpcSolution none_;
    const MpcSolution& solve(const ControlProblem&, const InitialGuess&) noexcept override {
      return none_;
    }
  } shared;
  const std::size_t before = bytes_in_use();
  for (const Plan& plan : plans) {
    navigators.push_back(std::make_unique<Navigator>(scenario.settings, shared));
    navigators.back()->follow(plan);
  }
  const std::size_t after = bytes_in_use();
  std::printf("memory of a robot: %.1f kB, and %.1f kB for its shared motion\n",
              1e-3 * static_cast<double>(after - before) / static_cast<double>(plans.size()),
              1e-3 * sizeof(SharedMotion));
}

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 10.0;
  memory();
  for (int i = 2; i < argc; ++i)
    run(std::atoi(argv[i]), seconds);
  return 0;
}
