// SPDX-License-Identifier: Apache-2.0
// Builds corridors along any line over any grid: no crash and no hang. A Built corridor keeps the
// guarantees of build_corridor, initially and after the map has changed.
#include <cstdint>

#include <gtest/gtest.h>

#include "fairway/corridor/corridor_builder.hpp"
#include "fuzz/random_grid.hpp"
#include "support/oracles/corridor_promises.hpp"

namespace {

using namespace fairway;

CorridorSettings random_settings(test::ByteSource& source, double cell) {
  CorridorSettings s;
  s.method = source.chance(0.3) ? CorridorMethod::Mdsrc : CorridorMethod::Fewest;
  s.space = source.chance(0.3) ? CorridorSpace::Workspace : CorridorSpace::Configuration;
  s.num_orientations = source.integer(1, 12);
  s.growth_step = std::max(1e-3, cell * source.usual(0.3, 3.0));
  s.max_growth = std::max(0.05, cell * source.usual(1.0, 60.0));
  s.longest_side = std::max(0.1, cell * source.usual(1.0, 90.0));
  s.inward_offset = source.chance(0.2) ? 0.0 : cell * source.usual(0.0, 4.0);
  s.min_overlap_area = source.chance(0.2) ? 0.0 : cell * cell * source.usual(0.0, 4.0);
  s.waypoint_spacing = std::max(0.01, cell * source.usual(0.5, 4.0));
  return s;
}

void check(const BitGrid& obstacles,
           const Path& path,
           const CorridorResult& result,
           const CorridorSettings& settings) {
  if (result.status == CorridorStatus::Built) {
    test::expect_a_sound_chain(obstacles, path, result.corridor, settings, true);
  } else if (result.status != CorridorStatus::EmptyPath) {
    EXPECT_GE(result.stuck_at, 0.0);
    EXPECT_LE(result.stuck_at, path.length() * (1.0 + 1e-9) + test::kRounding);
    EXPECT_LT(result.stuck_waypoint, path.waypoints.size());
  }
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
  testing::GTEST_FLAG(break_on_failure) = true;
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::ByteSource source(data, size);
  BitGrid obstacles = test::random_grid(source);
  const double cell = obstacles.frame().resolution;
  const CorridorSettings settings = random_settings(source, cell);
  const double radius = cell * source.usual(0.0, 4.0);
  Path path;
  for (int i = source.integer(0, 5); i > 0; --i)
    path.waypoints.push_back(test::random_point(source, obstacles.frame()));
  CorridorBuilder builder;
  check(obstacles, path, builder.build(obstacles, path, radius, settings), settings);
  for (int i = source.integer(0, 3); i > 0; --i) {
    const CellIndex corner{.x = source.integer(-2, 95), .y = source.integer(-2, 95)};
    const CellWindow block{
        .first = corner,
        .last = {.x = corner.x + source.integer(0, 9), .y = corner.y + source.integer(0, 9)}};
    const bool blocked = source.chance(0.5);
    for (int y = block.first.y; y <= block.last.y; ++y) {
      for (int x = block.first.x; x <= block.last.x; ++x) {
        if (obstacles.frame().contains({x, y})) obstacles.set({x, y}, blocked);
      }
    }
    check(obstacles, path, builder.update(obstacles, block), settings);
  }
  return 0;
}
