// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "fairway/corridor/corridor_builder.hpp"
#include "support/oracles/corridor_promises.hpp"
#include "support/random/random_path.hpp"

namespace fairway {
namespace {

struct Scene {
  BitGrid obstacles;
  Path path;
  double radius = 0.0;
  CorridorSettings settings;
};

std::optional<Scene> random_scene(test::Random& random) {
  Scene scene{.obstacles = BitGrid(test::random_world(random, 160))};
  const double cell = scene.obstacles.frame().resolution;
  scene.radius = cell * random.uniform(0.0, 4.0);
  scene.settings.min_overlap_area = cell * cell;
  scene.settings.longest_side = 60.0 * cell;
  const auto path = test::random_path(random, scene.obstacles, scene.radius + cell);
  if (!path) return std::nullopt;
  scene.path = *path;
  return scene;
}

// Blocks or frees some cells of a small block; blocked cells keep a distance from the path.
CellWindow change_map(test::Random& random, Scene& scene) {
  const GridFrame& frame = scene.obstacles.frame();
  const int size = random.integer(1, 12);
  CellWindow block;
  block.first = {.x = random.integer(0, frame.width - 1), .y = random.integer(0, frame.height - 1)};
  block.last = {.x = block.first.x + size, .y = block.first.y + size};
  const bool block_cells = random.chance(0.5);
  const double room = scene.radius + frame.resolution;
  for (int y = block.first.y; y <= std::min(block.last.y, frame.height - 1); ++y) {
    for (int x = block.first.x; x <= std::min(block.last.x, frame.width - 1); ++x) {
      if (!random.chance(0.5)) continue;
      if (!block_cells) {
        scene.obstacles.set({x, y}, false);
        continue;
      }
      const OrientedRectangle cell = test::cell_rectangle(frame, {x, y});
      bool clear = true;
      for (std::size_t i = 1; i < scene.path.waypoints.size() && clear; ++i) {
        clear =
            test::distance(segment_rectangle(scene.path.waypoints[i - 1], scene.path.waypoints[i]),
                           cell) > room;
      }
      if (clear) scene.obstacles.set({x, y}, true);
    }
  }
  return block;
}

TEST(CorridorUpdate, KeepsItsGuaranteesThroughManyChanges) {
  test::Random random(21);
  int updates = 0;
  std::size_t updated_count = 0;
  std::size_t fresh_count = 0;
  for (int trial = 0; trial < 60; ++trial) {
    auto scene = random_scene(random);
    if (!scene || scene->path.waypoints.size() < 2) continue;
    CorridorBuilder builder;
    ASSERT_EQ(builder.build(scene->obstacles, scene->path, scene->radius, scene->settings).status,
              CorridorStatus::Built);
    for (int i = 0; i < 15; ++i) {
      const CellWindow changed = change_map(random, *scene);
      const CorridorResult& result = builder.update(scene->obstacles, changed);
      ASSERT_EQ(result.status, CorridorStatus::Built) << "trial " << trial << " change " << i;
      test::expect_a_sound_chain(scene->obstacles, scene->path, result.corridor, scene->settings,
                                 i == 14 && trial % 8 == 0);
      ++updates;
    }
    updated_count += builder.result().corridor.rectangles.size();
    fresh_count += build_corridor(scene->obstacles, scene->path, scene->radius, scene->settings)
                       .corridor.rectangles.size();
  }
  EXPECT_GT(updates, 400);
  EXPECT_LE(static_cast<double>(updated_count), 1.15 * static_cast<double>(fresh_count))
      << "the chain stays nearly as short as a new one";
}

TEST(CorridorUpdate, KeepsTheChainWhereNothingChanged) {
  test::Random random(22);
  for (int trial = 0; trial < 30; ++trial) {
    const auto scene = random_scene(random);
    if (!scene) continue;
    CorridorBuilder builder;
    const CorridorResult before =
        builder.build(scene->obstacles, scene->path, scene->radius, scene->settings);
    const CorridorResult& after = builder.update(scene->obstacles, {{0, 0}, {1000, 1000}});
    ASSERT_EQ(after.corridor.rectangles.size(), before.corridor.rectangles.size());
    for (std::size_t i = 0; i < before.corridor.rectangles.size(); ++i) {
      EXPECT_EQ(after.corridor.rectangles[i].min, before.corridor.rectangles[i].min);
      EXPECT_EQ(after.corridor.rectangles[i].max, before.corridor.rectangles[i].max);
    }
  }
}

TEST(CorridorUpdate, ReportsWhereThePathIsBlockedAndRecovers) {
  BitGrid obstacles(GridFrame{.width = 400, .height = 100, .resolution = 0.05, .origin = {}},
                    false);
  const Path path{.waypoints = {{1.0, 2.5}, {19.0, 2.5}}};
  CorridorBuilder builder;
  ASSERT_EQ(builder.build(obstacles, path, 0.3, {}).status, CorridorStatus::Built);
  const CellWindow wall{{200, 0}, {201, 99}};
  for (int y = 0; y < 100; ++y)
    obstacles.set({200, y}, true);
  const CorridorResult& blocked = builder.update(obstacles, wall);
  EXPECT_EQ(blocked.status, CorridorStatus::SeedBlocked);
  EXPECT_NEAR(blocked.stuck_at, 10.0 - 1.0 - 0.3, 0.1);
  EXPECT_EQ(blocked.stuck_waypoint, 0U);
  for (int y = 0; y < 100; ++y)
    obstacles.set({200, y}, false);
  EXPECT_EQ(builder.update(obstacles, wall).status, CorridorStatus::Built);
}

TEST(CorridorUpdate, DoesNothingBeforeTheFirstBuild) {
  CorridorBuilder builder;
  EXPECT_EQ(builder.update(BitGrid(), {}).status, CorridorStatus::EmptyPath);
}

}  // namespace
}  // namespace fairway
