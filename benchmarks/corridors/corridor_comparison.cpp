// SPDX-License-Identifier: Apache-2.0
// Compares corridors on generated maps: rectangles of other papers as published, the library's
// sound versions, and the fewest. Prints Markdown tables. Usage: corridor_comparison [MAPS]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "corridor_scenes.hpp"
#include "corridor_tally.hpp"
#include "corridor_timing.hpp"
#include "experiments/baselines/sampled_rectangles.hpp"
#include "experiments/baselines/sound_baselines.hpp"
#include "fairway/corridor/corridor_builder.hpp"
#include "fairway/corridor/path_piece.hpp"
#include "fairway/corridor/rectangle/largest_rectangle.hpp"
#include "fairway/corridor/rectangle/rectangle_growth.hpp"
#include "fairway/map/distance_field.hpp"
#include "fairway/path/path_planner.hpp"
#include "fairway/simulation/scenarios/generated_maps.hpp"
#include "support/oracles/rectangle_oracle.hpp"

namespace fairway::benchmarks {
namespace {

using baselines::SampledGrowth;
using baselines::Sampling;
using Eigen::Vector2d;

void run_sampled(const std::vector<Scene>& scenes, const char* name, const SampledGrowth& growth) {
  Tally tally;
  for (const Scene& scene : scenes) {
    std::vector<OrientedRectangle> built;
    const double spent = best_time(
        3, [&] { built = baselines::build_sampled(scene.obstacles, scene.waypoints, growth); });
    tally.add(scene, built, 0.0, kRadius, spent);
  }
  tally.print(name);
}

using Build =
    std::function<CorridorResult(const BitGrid&, const Path&, double, const CorridorSettings&)>;

double run_sound(const std::vector<Scene>& scenes,
                 const char* name,
                 CorridorSpace space,
                 const Build& build) {
  Tally tally;
  CorridorSettings settings;
  settings.space = space;
  for (const Scene& scene : scenes) {
    CorridorResult result;
    const double spent =
        best_time(3, [&] { result = build(scene.obstacles, scene.path, kRadius, settings); });
    if (result.status != CorridorStatus::Built) ++tally.failed;
    const bool workspace = space == CorridorSpace::Workspace;
    tally.add(scene, result.corridor.rectangles, workspace ? 0.0 : kRadius,
              result.corridor.inward_offset, spent);
  }
  tally.print(name);
  return tally.rectangles / tally.paths;
}

// Returns the least number of free rectangles that cover the path piece by piece. It tries
// `num_angles` orientations and ignores the overlap condition. Greedy: bisection finds the furthest
// reach of each rectangle. Slow and simple.
int lower_bound(const Scene& scene, double clearance, double margin, int num_angles) {
  const GridFrame& grid = scene.obstacles.frame();
  PathTrack track;
  track.assign(scene.path, grid);
  const double radius = search_radius(grid, clearance);
  const double room = margin / grid.resolution;
  int count = 0;
  for (double from = 0.0; from < track.length(); ++count) {
    double best = from;
    for (int k = 0; k < num_angles; ++k) {
      const TurnedFrame frame{.origin = track.at(from),
                              .along = direction(std::numbers::pi / 2.0 * k / num_angles)};
      const auto fits = [&](double to) {
        const PathPiece piece{.begin = {from, from, room}, .end = {to, to, room}, .margin = room};
        const Box box = piece.bounds(track, frame);
        return (box.max - box.min).maxCoeff() <=
                   CorridorSettings{}.longest_side / grid.resolution &&
               is_free(scene.obstacles, frame.region(box), radius);
      };
      if (!fits(std::min(track.length(), best + 0.01))) continue;
      double good = best;
      double bad = track.length() + 0.01;
      while (bad - good > 0.01) {
        const double middle = 0.5 * (good + bad);
        (fits(std::min(middle, track.length())) ? good : bad) = middle;
      }
      best = std::min(good, track.length());
    }
    if (best <= from) return count;  // blocked: no bound to compare with
    from = best;
    if (from >= track.length() - 0.02) return count + 1;
  }
  return count;
}

void compare_corridors(MapKind kind, int maps) {
  const std::vector<Scene> scenes = make_scenes(kind, maps);
  double length = 0.0;
  double pack = 0.0;
  for (const Scene& scene : scenes)
    length += scene.path.length();
  const OccupancyGrid grid = generate_map(kind, 0);
  BitGrid packed(grid);
  pack = best_time(20, [&] { packed.assign(grid); });
  std::printf("\n### %s: %.0f m x %.0f m, %d maps, mean path %.1f m, map preparation %.2f ms\n\n",
              to_text(kind), side_length(kind), side_length(kind), maps,
              length / static_cast<double>(scenes.size()), pack * 1e3);
  std::puts(
      "| method | rectangles | mean area m2 | us each | us per path | overlap obstacles | "
      "broken chains | failed |");
  std::puts("|---|---|---|---|---|---|---|---|");
  run_sampled(scenes, "SRC, strip sampled", {.sampling = Sampling::Strip, .num_orientations = 1});
  run_sampled(scenes, "FSRC, edge sampled", {.sampling = Sampling::Edge, .num_orientations = 1});
  run_sampled(scenes, "MDSRC, edge sampled (the paper's)", {});
  const auto build_mdsrc = [](const BitGrid& o, const Path& p, double r, CorridorSettings s) {
    s.method = CorridorMethod::Mdsrc;
    return build_corridor(o, p, r, s);
  };
  const auto build_fewest = [](const BitGrid& o, const Path& p, double r,
                               const CorridorSettings& s) { return build_corridor(o, p, r, s); };
  const auto workspace = CorridorSpace::Workspace;
  const auto configuration = CorridorSpace::Configuration;
  run_sound(scenes, "SRC, sound, workspace", workspace, baselines::build_src);
  run_sound(scenes, "FSRC, sound, workspace", workspace, baselines::build_fsrc);
  run_sound(scenes, "MDSRC, sound, workspace", workspace, build_mdsrc);
  const double few_work = run_sound(scenes, "fewest, workspace", workspace, build_fewest);
  const double src =
      run_sound(scenes, "SRC, sound, configuration", configuration, baselines::build_src);
  const double mdsrc = run_sound(scenes, "MDSRC, sound, configuration", configuration, build_mdsrc);
  const double few = run_sound(scenes, "fewest, configuration", configuration, build_fewest);
  double bound = 0.0;
  double bound_work = 0.0;
  for (const Scene& scene : scenes) {
    bound += lower_bound(scene, kRadius, 0.0, 360);
    bound_work += lower_bound(scene, 0.0, kRadius, 360);
  }
  bound /= maps;
  bound_work /= maps;
  std::printf(
      "\nLower bound on the count over 360 orientations: configuration %.1f, workspace %.1f."
      " Fewest is %.2f and %.2f times that; in configuration space %.2f x MDSRC, %.2f x SRC."
      "\n",
      bound, bound_work, few / bound, few_work / bound_work, few / mdsrc, few / src);
}

// Builds single workspace rectangles around points of the paths.
void compare_rectangles(MapKind kind, int maps) {
  const std::vector<Scene> scenes = make_scenes(kind, maps);
  constexpr double kSide = 16.0;
  constexpr int kOracleAngles = 90;
  RectangleSearch search;
  double naive = 0, greedy = 0, largest = 0;
  double naive_share = 0, greedy_share = 0, largest_share = 0, src_share = 0;
  int count = 0;
  for (const Scene& scene : scenes) {
    const BitGrid& map = scene.obstacles;
    std::vector<Vector2d> seeds;
    for (std::size_t i = 10; i < scene.waypoints.waypoints.size(); i += 30)
      seeds.push_back(scene.waypoints.waypoints[i]);
    std::vector<double> area(seeds.size());
    const auto timed = [&](const auto& area_at) {
      return best_time(5, [&] {
        for (std::size_t i = 0; i < seeds.size(); ++i)
          area[i] = area_at(seeds[i]);
      });
    };
    const auto share = [&] {
      double sum = 0.0;
      for (std::size_t i = 0; i < seeds.size(); ++i)
        sum += area[i] / largest_area_of(map, seeds[i], kSide, kOracleAngles);
      return sum;
    };
    naive += timed([&](const Vector2d& s) { return baselines::grow_sampled(map, s, {})->area(); });
    naive_share += share();
    timed([&](const Vector2d& s) {
      return grow_rectangle(map, 0.0, s, {.num_orientations = 1})->area();
    });
    src_share += share();
    greedy += timed([&](const Vector2d& s) { return grow_rectangle(map, 0.0, s, {})->area(); });
    greedy_share += share();
    const double cell = map.frame().resolution;
    largest += timed([&](const Vector2d& s) {
      const Anchor anchor{.point = map.frame().to_grid(s)};
      return search.find(map, 0.0, {&anchor, 1}, {.longest_side = kSide})->box.area() * cell * cell;
    });
    largest_share += share();
    count += static_cast<int>(seeds.size());
  }
  const double n = count / 100.0;
  std::printf("| %s | %d | %.1f | %.1f (%.2f x) | %.1f (%.2f x) | %.0f | %.0f | %.0f | %.1f |\n",
              to_text(kind), count, naive / count * 1e6, greedy / count * 1e6, greedy / naive,
              largest / count * 1e6, largest / naive, src_share / n, naive_share / n,
              greedy_share / n, largest_share / n);
}

// The paper's Figures 9 and 10 have random points on a 20 m map with an increasing number of
// obstacles. Points inside an earlier rectangle get none.
void compare_fields(int maps) {
  std::puts("\n### Fields of 20 m x 20 m, 24 random points\n");
  std::puts(
      "| obstacles | SRC count | area m2 | MDSRC count | area m2 | largest count | area m2 |");
  std::puts("|---|---|---|---|---|---|---|");
  for (const int obstacles : {5, 10, 15, 20}) {
    std::array<double, 3> counts{};
    std::array<double, 3> areas{};
    for (int seed = 0; seed < maps; ++seed) {
      const BitGrid map(generate_map(MapKind::Field, static_cast<std::uint64_t>(seed), obstacles));
      const std::vector<Vector2d> points = free_points(map, 24, static_cast<unsigned>(seed));
      const std::array<std::function<OrientedRectangle(const Vector2d&)>, 3> methods = {
          [&](const Vector2d& p) { return *grow_rectangle(map, 0.0, p, {.num_orientations = 1}); },
          [&](const Vector2d& p) { return *grow_rectangle(map, 0.0, p, {}); },
          [&](const Vector2d& p) { return *largest_rectangle(map, 0.0, {.point = p}); }};
      for (std::size_t m = 0; m < methods.size(); ++m) {
        std::vector<OrientedRectangle> built;
        for (const Vector2d& p : points) {
          const bool held = std::any_of(built.begin(), built.end(),
                                        [&](const OrientedRectangle& r) { return r.contains(p); });
          if (held) continue;
          built.push_back(methods[m](p));
          areas[m] += built.back().area();
        }
        counts[m] += static_cast<double>(built.size());
      }
    }
    std::printf("| %d |", obstacles);
    for (std::size_t m = 0; m < 3; ++m)
      std::printf(" %.1f | %.1f |", counts[m] / maps, areas[m] / counts[m]);
    std::puts("");
  }
}

// Makes small changes on the map, one per control cycle, each followed by an update.
void time_updates(int maps) {
  std::vector<double> times;
  double builds = 0.0;
  for (Scene& scene : make_scenes(MapKind::UnstructuredLarge, maps)) {
    CorridorBuilder builder;
    builds += best_time(3, [&] { builder.build(scene.obstacles, scene.path, kRadius, {}); });
    const BitGrid keep_clear =
        inflated(path_cells(scene.obstacles.frame(), resampled(scene.path, 0.03)), 0.45);
    for (std::size_t i = 20; i + 20 < scene.waypoints.waypoints.size(); i += 12) {
      const CellIndex at = scene.obstacles.frame().cell_at(scene.waypoints.waypoints[i]);
      const int dx = static_cast<int>(i * 7 % 41) - 20;
      const int dy = static_cast<int>(i * 13 % 37) - 18;
      const CellWindow block{.first = {.x = at.x + dx, .y = at.y + dy},
                             .last = {.x = at.x + dx + 6, .y = at.y + dy + 6}};
      for (const bool blocked : {true, false}) {
        set_cells(scene.obstacles, block, keep_clear, blocked);
        times.push_back(best_time(1, [&] { builder.update(scene.obstacles, block); }));
      }
    }
  }
  std::sort(times.begin(), times.end());
  const auto at = [&](double share) {
    return times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))] * 1e6;
  };
  std::printf(
      "\n### Updates after a 0.35 m block appears or goes near the path (env1, %zu updates)\n"
      "\nWhole build %.0f us; update median %.0f us, 90 %% %.0f us, 99 %% %.0f us.\n",
      times.size(), builds * 1e6 / maps, at(0.5), at(0.9), at(0.99));
}

}  // namespace
}  // namespace fairway::benchmarks

int main(int argc, char** argv) {
  using namespace fairway;
  const int maps = argc > 1 ? std::max(1, std::atoi(argv[1])) : 40;
  constexpr std::array<MapKind, 3> kKinds = {MapKind::UnstructuredLarge, MapKind::UnstructuredSmall,
                                             MapKind::Structured};
  for (const MapKind kind : kKinds)
    benchmarks::compare_corridors(kind, maps);
  std::puts("\n### Single rectangles in the workspace: time in us and share of the largest in %\n");
  std::puts(
      "| map | seeds | sampled MDSRC us | sound MDSRC us | largest us | SRC % | sampled MDSRC "
      "% | sound MDSRC % | largest % |");
  std::puts("|---|---|---|---|---|---|---|---|---|");
  for (const MapKind kind : kKinds)
    benchmarks::compare_rectangles(kind, maps);
  benchmarks::compare_fields(2 * maps);
  benchmarks::time_updates(maps);
  return 0;
}
