// SPDX-License-Identifier: Apache-2.0
// Times each stage from map to command on generated maps of the paper's three kinds: map
// preparation, path, corridor, one cold MPC solve. The argument is the MapKind. Beside them, the
// prediction of people.
#include <memory>
#include <vector>

#include <benchmark/benchmark.h>

#include "fairway/corridor/corridor_builder.hpp"
#include "fairway/map/free_space.hpp"
#include "fairway/mpc/interior_point/solver.hpp"
#include "fairway/navigation/settings.hpp"
#include "fairway/path/path_planner.hpp"
#include "fairway/planning/planner.hpp"
#include "fairway/prediction/forecast.hpp"
#include "fairway/simulation/scenarios/generated_maps.hpp"
#include "solvers/ocp_generator.hpp"

namespace {

using fairway::MapKind;

struct Query {
  fairway::PreparedMap map;
  fairway::Settings settings;
  Eigen::Vector2d start;
  Eigen::Vector2d goal;
};

// From the free point nearest to one corner to that nearest to the opposite one.
Query query(const benchmark::State& state) {
  Query q{
      .map = fairway::PreparedMap(fairway::generate_map(static_cast<MapKind>(state.range(0)), 1)),
      .settings = {},
      .start = {},
      .goal = {}};
  q.settings.path.margin = 0.1;  // always enough for the desired overlap: docs/corridors.md
  const fairway::GridFrame& frame = q.map.obstacles.frame();
  const double side = frame.width * frame.resolution;
  const auto free_near = [&](double from, double way) {
    for (double s = 1.0; s < 0.5 * side; s += 0.1) {
      const Eigen::Vector2d p = Eigen::Vector2d::Constant(from + way * s);
      if (fairway::is_free(q.map.obstacles, p, p, q.settings.robot.radius + 0.2)) return p;
    }
    return Eigen::Vector2d(0.0, 0.0);
  };
  q.start = free_near(0.0, 1.0);
  q.goal = free_near(side, -1.0);
  return q;
}

void prepare_map(benchmark::State& state) {
  const fairway::OccupancyGrid grid =
      fairway::generate_map(static_cast<MapKind>(state.range(0)), 1);
  for (auto _ : state)
    benchmark::DoNotOptimize(fairway::PreparedMap(grid));
}

// A planner that is new to the map, like the tool's.
void find_path(benchmark::State& state) {
  const Query q = query(state);
  fairway::PathResult result;
  for (auto _ : state) {
    fairway::PathPlanner planner;
    result = planner.find(q.map.obstacles, q.map.distances, q.start, q.goal,
                          q.settings.robot.radius, q.settings.path);
  }
  if (result.status != fairway::PathStatus::Found) state.SkipWithError("no path");
  state.counters["metres"] = result.path.length();
}

// Points all over the map at which the robot has some space.
std::vector<Eigen::Vector2d> goals_on(const Query& q) {
  const fairway::GridFrame& frame = q.map.obstacles.frame();
  const double side = frame.width * frame.resolution;
  std::vector<Eigen::Vector2d> goals;
  for (int i = 0; i < 64; ++i) {
    // A grid of 8 x 8 points, visited in steps of 27, so that neighbours do not follow each other.
    const int k = 27 * i % 64;
    const Eigen::Vector2d p = side / 8.0 * Eigen::Vector2d(k % 8 + 0.5, k / 8 + 0.5);
    if (fairway::is_free(q.map.obstacles, p, p, q.settings.robot.radius + 0.2)) goals.push_back(p);
  }
  return goals;
}

// Goals after the first one: from the same start, or each from the goal before. The time is that of
// one goal.
void find_further_paths(benchmark::State& state, bool same_start) {
  const Query q = query(state);
  const std::vector<Eigen::Vector2d> goals = goals_on(q);
  double metres = 0.0;
  std::unique_ptr<fairway::PathPlanner> planner;
  Eigen::Vector2d start;
  std::size_t i = goals.size();
  int found = 0;
  for (auto _ : state) {
    if (i == goals.size()) {
      state.PauseTiming();
      planner = std::make_unique<fairway::PathPlanner>();
      start = q.start;
      benchmark::DoNotOptimize(planner->find(q.map.obstacles, q.map.distances, start, q.goal,
                                             q.settings.robot.radius, q.settings.path));
      i = 0;
      state.ResumeTiming();
    }
    const fairway::PathResult result =
        planner->find(q.map.obstacles, q.map.distances, start, goals[i], q.settings.robot.radius,
                      q.settings.path);
    if (!same_start) start = goals[i];
    ++i;
    ++found;
    metres += result.path.length();
  }
  state.counters["metres"] = metres / found;
}

void build_corridor(benchmark::State& state) {
  const Query q = query(state);
  fairway::PathPlanner planner;
  const fairway::PathResult found = planner.find(q.map.obstacles, q.map.distances, q.start, q.goal,
                                                 q.settings.robot.radius, q.settings.path);
  fairway::CorridorResult result;
  for (auto _ : state) {
    result = fairway::build_corridor(q.map.obstacles, found.path, q.settings.robot.radius,
                                     q.settings.corridor);
  }
  if (result.status != fairway::CorridorStatus::Built) state.SkipWithError("no corridor");
  state.counters["rectangles"] = static_cast<double>(result.corridor.rectangles.size());
  state.counters["metres"] = found.path.length();
}

// Solves 100 problems of the paper's preset with two moving obstacles, one after the other.
void solve_mpc(benchmark::State& state) {
  fairway::benchmark::OcpGenerator generator(1);
  std::vector<fairway::ControlProblem> problems;
  for (int i = 0; i < 100; ++i)
    problems.push_back(generator.next(static_cast<int>(state.range(0)), 2));
  const auto solver = std::make_unique<fairway::InteriorPointSolver>();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(&solver->solve(problems[i]));
    i = (i + 1) % problems.size();
  }
}

// Predicts people around the robot for 8 s at 33 times; the argument is their number.
void predict_people(benchmark::State& state) {
  std::vector<fairway::MovingObstacle> people;
  for (int i = 0; i < static_cast<int>(state.range(0)); ++i) {
    const double turn = 2.4 * i;
    people.push_back({.position = (1.0 + 0.2 * i) * fairway::direction(turn),
                      .velocity = 1.3 * fairway::direction(3.0 * turn),
                      .radius = 0.3});
  }
  const fairway::PredictionSettings settings;
  fairway::Forecast forecast;
  for (auto _ : state) {
    fairway::predict(people, 0.1, {0.0, 0.0}, settings, 0.25, fairway::Forecast::kMaxSamples,
                     forecast);
    benchmark::DoNotOptimize(forecast);
  }
}

}  // namespace

BENCHMARK(predict_people)->ArgName("people")->Arg(20)->Arg(100)->Unit(benchmark::kMicrosecond);
BENCHMARK(prepare_map)->ArgName("kind")->DenseRange(0, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(find_path)->ArgName("kind")->DenseRange(0, 2)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(find_further_paths, from_the_same_start, true)
    ->ArgName("kind")
    ->DenseRange(0, 2)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(find_further_paths, from_the_goal_before, false)
    ->ArgName("kind")
    ->DenseRange(0, 2)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(build_corridor)->ArgName("kind")->DenseRange(0, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(solve_mpc)->ArgName("horizon")->Arg(10)->Arg(20)->Arg(50)->Unit(benchmark::kMicrosecond);

BENCHMARK_MAIN();
