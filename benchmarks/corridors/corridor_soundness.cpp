// SPDX-License-Identifier: Apache-2.0
// Builds corridors by every sound method on many random small maps with posts and one-cell
// diagonals. Counts rectangles that are too close to an obstacle and broken chains.
// Usage: corridor_soundness [MAPS]; exit code 1 when there is any.
#include <cstdio>
#include <cstdlib>

#include "experiments/baselines/sound_baselines.hpp"
#include "fairway/corridor/corridor_builder.hpp"
#include "fairway/map/free_space.hpp"
#include "support/random/random_path.hpp"

namespace fairway {
namespace {

struct Count {
  long built = 0, stuck = 0, rectangles = 0, overlapping = 0, broken = 0;
};

void check(const BitGrid& obstacles,
           const Path& path,
           const CorridorSettings& settings,
           const CorridorResult& result,
           Count& count) {
  if (result.status != CorridorStatus::Built) {
    ++count.stuck;
    return;
  }
  ++count.built;
  const Corridor& corridor = result.corridor;
  const double clearance = corridor.space == CorridorSpace::Workspace ? 0.0 : corridor.robot_radius;
  const std::size_t n = corridor.rectangles.size();
  bool broken = n == 0 || !corridor.admissible(0).contains(path.waypoints.front(), 1e-9) ||
                !corridor.admissible(n - 1).contains(path.waypoints.back(), 1e-9);
  for (std::size_t i = 0; i < n; ++i) {
    ++count.rectangles;
    count.overlapping += is_free(obstacles, corridor.rectangles[i], clearance) ? 0 : 1;
    if (i == 0) continue;
    const OverlapPatch patch = overlap(corridor.admissible(i - 1), corridor.admissible(i));
    broken = broken || patch.count == 0 || patch.area() < settings.min_overlap_area;
  }
  count.broken += broken ? 1 : 0;
}

}  // namespace
}  // namespace fairway

int main(int argc, char** argv) {
  using namespace fairway;
  const int maps = argc > 1 ? std::atoi(argv[1]) : 10000;
  test::Random random(1);
  constexpr std::array<const char*, 4> kNames = {"src", "fsrc", "mdsrc", "fewest"};
  std::array<Count, 8> counts;
  for (int map = 0; map < maps; ++map) {
    const BitGrid obstacles(test::random_world(random, 120));
    const double cell = obstacles.frame().resolution;
    const double radius = cell * random.uniform(0.0, 5.0);
    for (int space = 0; space < 2; ++space) {
      CorridorSettings settings;
      settings.space = space == 0 ? CorridorSpace::Workspace : CorridorSpace::Configuration;
      settings.inward_offset = radius;
      settings.min_overlap_area = cell * cell * random.uniform(0.0, 2.0);
      settings.waypoint_spacing = 2.0 * cell;
      const double room = (space == 0 ? 1.415 : 1.0) * radius + random.uniform(0.1, 1.5) * cell;
      const auto path = test::random_path(random, obstacles, room);
      if (!path) continue;
      for (std::size_t m = 0; m < kNames.size(); ++m) {
        settings.method = m == 3 ? CorridorMethod::Fewest : CorridorMethod::Mdsrc;
        const CorridorResult result =
            m == 0   ? baselines::build_src(obstacles, *path, radius, settings)
            : m == 1 ? baselines::build_fsrc(obstacles, *path, radius, settings)
                     : build_corridor(obstacles, *path, radius, settings);
        check(obstacles, *path, settings, result, counts[m + 4 * static_cast<std::size_t>(space)]);
      }
    }
  }
  std::printf(
      "%d random maps\n\n| method | space | chains | stuck | rectangles | overlapping | "
      "broken |\n|---|---|---|---|---|---|---|\n",
      maps);
  long bad = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const Count& c = counts[i];
    std::printf("| %s | %s | %ld | %ld | %ld | %ld | %ld |\n", kNames[i % 4],
                i < 4 ? "workspace" : "configuration", c.built, c.stuck, c.rectangles,
                c.overlapping, c.broken);
    bad += c.overlapping + c.broken;
  }
  return bad == 0 ? 0 : 1;
}
