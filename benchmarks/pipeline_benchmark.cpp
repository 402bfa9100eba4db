// SPDX-License-Identifier: Apache-2.0
// Times each stage from map to command on generated maps of the paper's three kinds: map
// preparation, path, corridor, one cold MPC solve. The argument is the MapKind.
#include <memory>
#include <vector>

#include <benchmark/benchmark.h>

#include "fairway/corridor/corridor_builder.hpp"
#include "fairway/map/free_space.hpp"
#include "fairway/mpc/interior_point/solver.hpp"
#include "fairway/navigation/settings.hpp"
#include "fairway/path/path_planner.hpp"
#include "fairway/planning/planner.hpp"
#include "fairway/simulation/scenarios/generated_maps.hpp"
#include "ocp_generator.hpp"

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

void find_path(benchmark::State& state) {
  const Query q = query(state);
  fairway::PathPlanner planner;
  fairway::PathResult result;
  for (auto _ : state) {
    result = planner.find(q.map.obstacles, q.map.distances, q.start, q.goal,
                          q.settings.robot.radius, q.settings.path);
  }
  if (result.status != fairway::PathStatus::Found) state.SkipWithError("no path");
  state.counters["metres"] = result.path.length();
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

}  // namespace

BENCHMARK(prepare_map)->ArgName("kind")->DenseRange(0, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(find_path)->ArgName("kind")->DenseRange(0, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(build_corridor)->ArgName("kind")->DenseRange(0, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(solve_mpc)->ArgName("horizon")->Arg(10)->Arg(20)->Arg(50)->Unit(benchmark::kMicrosecond);

BENCHMARK_MAIN();
