// SPDX-License-Identifier: Apache-2.0
// Times map preparation (distance field, inflation) and path search on generated maps and, if the
// shared data is present, on Willow Garage.
#include <optional>
#include <string>

#include <benchmark/benchmark.h>

#include "fairway/io/maps/map_file.hpp"
#include "fairway/path/path_planner.hpp"
#include "support/random/random_world.hpp"

namespace {

using Eigen::Vector2d;
using fairway::BitGrid;
using fairway::DistanceField;

// Square obstacles of 5 to 50 cm on a tenth of the floor, cells of 0.05 m.
BitGrid cluttered_map(int side_cells) {
  fairway::test::Random random(1);
  BitGrid map({.width = side_cells, .height = side_cells, .resolution = 0.05, .origin = {}}, false);
  for (int i = side_cells * side_cells / 400; i > 0; --i) {
    const int x = random.integer(0, side_cells - 11);
    const int y = random.integer(0, side_cells - 11);
    const int size = random.integer(1, 10);
    for (int v = y; v < y + size; ++v) {
      for (int u = x; u < x + size; ++u)
        map.set({u, v}, true);
    }
  }
  return map;
}

std::optional<BitGrid> willow() {
  const auto map =
      fairway::io::read_map(std::string(FAIRWAY_SHARED_DATA) + "/maps/willow-full-0.05.yaml");
  if (!map) return std::nullopt;
  return BitGrid(*map);
}

void distance_field(benchmark::State& state) {
  const BitGrid map = cluttered_map(static_cast<int>(state.range(0)));
  DistanceField field;
  for (auto _ : state) {
    field.update(map);
    benchmark::DoNotOptimize(field.cells().data());
  }
}
BENCHMARK(distance_field)->ArgName("cells")->Arg(500)->Arg(1000)->Unit(benchmark::kMillisecond);

void distance_field_window(benchmark::State& state) {
  BitGrid map = cluttered_map(1000);
  DistanceField field(map);
  const int side = static_cast<int>(state.range(0));
  bool blocked = false;
  for (auto _ : state) {
    blocked = !blocked;
    map.set({500, 500}, blocked);
    field.update(map, {.first = {500, 500}, .last = {500 + side - 1, 500 + side - 1}});
    benchmark::DoNotOptimize(field.cells().data());
  }
}
BENCHMARK(distance_field_window)->ArgName("side")->Arg(1)->Arg(100)->Unit(benchmark::kMillisecond);

// All obstacles of a window of 100 x 100 cells are exchanged for others as dense.
void distance_field_other_window(benchmark::State& state) {
  constexpr fairway::CellWindow kWindow{.first = {500, 500}, .last = {599, 599}};
  BitGrid map = cluttered_map(1000);
  const BitGrid maps[2] = {
      map, [&] {
        BitGrid other = map;
        const BitGrid from = map.part({.first = {300, 300}, .last = {399, 399}});
        for (int y = 0; y < 100; ++y) {
          for (int x = 0; x < 100; ++x)
            other.set({500 + x, 500 + y}, from.blocked({x, y}));
        }
        return other;
      }()};
  DistanceField field(map);
  std::size_t next = 1;
  for (auto _ : state) {
    map.copy(maps[next], kWindow);
    field.update(map, kWindow);
    next = 1 - next;
    benchmark::DoNotOptimize(field.cells().data());
  }
}
BENCHMARK(distance_field_other_window)->Unit(benchmark::kMillisecond);

// Repeats one query with a planner that knows the map, there and back by turns, so that no search
// continues the one before. `cold` uses a new planner each time, like the tool's first plan.
void find_path(benchmark::State& state,
               const BitGrid& map,
               const Vector2d& start,
               const Vector2d& goal,
               double radius,
               bool cold) {
  const DistanceField distances(map);
  fairway::PathSettings settings;
  settings.comfort_weight = static_cast<double>(state.range(0)) / 10.0;
  fairway::PathPlanner planner;
  fairway::PathResult result;
  bool back = false;
  for (auto _ : state) {
    if (cold) planner = {};
    result = planner.find(map, distances, back ? goal : start, back ? start : goal,
                          radius - settings.margin, settings);
    back = !back && !cold;
  }
  if (result.status != fairway::PathStatus::Found) state.SkipWithError("no path");
  state.counters["metres"] = result.path.length();
  state.counters["cost"] = result.cost;
  state.counters["waypoints"] = static_cast<double>(result.path.waypoints.size());
  state.counters["expanded"] = result.expanded;
}

void path_cluttered(benchmark::State& state) {
  find_path(state, cluttered_map(1000), {1.0, 1.0}, {48.8, 49.1}, 0.2, false);
}
BENCHMARK(path_cluttered)->ArgName("weight10")->Arg(0)->Arg(15)->Unit(benchmark::kMillisecond);

// A start and goal in Willow Garage. 0.2755 m from every occupied square equals 0.3 m from the
// centre of every occupied cell.
void path_willow(benchmark::State& state, bool cold) {
  const std::optional<BitGrid> map = willow();
  if (!map) {
    state.SkipWithError("no willow-full-0.05 in the shared data");
    return;
  }
  find_path(state, *map, {36.27, 24.23}, {6.73, 2.33}, 0.2755, cold);
}
BENCHMARK_CAPTURE(path_willow, warm, false)
    ->ArgName("weight10")
    ->Arg(0)
    ->Arg(15)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(path_willow, cold, true)
    ->ArgName("weight10")
    ->Arg(0)
    ->Arg(15)
    ->Unit(benchmark::kMillisecond);

void distance_field_willow(benchmark::State& state) {
  const std::optional<BitGrid> map = willow();
  if (!map) {
    state.SkipWithError("no willow-full-0.05 in the shared data");
    return;
  }
  DistanceField field;
  for (auto _ : state) {
    field.update(*map);
    benchmark::DoNotOptimize(field.cells().data());
  }
}
BENCHMARK(distance_field_willow)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
