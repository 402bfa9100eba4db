// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "fairway/corridor/corridor_builder.hpp"
#include "support/oracles/corridor_promises.hpp"
#include "support/random/random_path.hpp"

namespace fairway {
namespace {

TEST(CorridorChain, FewestCoversEveryPathWithClearanceForThePatch) {
  test::Random random(11);
  int built = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const BitGrid obstacles(test::random_world(random, 120));
    const double cell = obstacles.frame().resolution;
    const double radius = cell * random.uniform(0.0, 5.0);
    const double margin = cell * random.uniform(0.05, 0.5);
    const auto path = test::random_path(random, obstacles, radius + margin);
    if (!path) continue;
    CorridorSettings settings;
    // Around every point of the path, any rectangle has a free disc of radius margin / sqrt(2).
    settings.min_overlap_area = 1.57 * margin * margin;
    settings.longest_side = random.chance(0.5) ? 16.0 : 40.0 * cell;
    const CorridorResult result = build_corridor(obstacles, *path, radius, settings);
    ASSERT_EQ(result.status, CorridorStatus::Built)
        << "trial " << trial << " stuck at " << result.stuck_at << " of " << path->length();
    test::expect_a_sound_chain(obstacles, *path, result.corridor, settings, trial % 8 == 0);
    ++built;
  }
  EXPECT_GT(built, 200);
}

TEST(CorridorChain, FewestCoversEveryFreePathWithoutAPatch) {
  test::Random random(12);
  for (int trial = 0; trial < 200; ++trial) {
    const BitGrid obstacles(test::random_world(random, 120));
    const double radius = obstacles.frame().resolution * random.uniform(0.0, 5.0);
    const auto path = test::random_path(random, obstacles, radius + 1e-6);
    if (!path) continue;
    CorridorSettings settings;
    settings.min_overlap_area = 0.0;
    const CorridorResult result = build_corridor(obstacles, *path, radius, settings);
    ASSERT_EQ(result.status, CorridorStatus::Built) << "trial " << trial;
    test::expect_a_sound_chain(obstacles, *path, result.corridor, settings, false);
  }
}

TEST(CorridorChain, EveryBuiltCorridorIsSound) {
  test::Random random(13);
  int built = 0;
  int stuck = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const BitGrid obstacles(test::random_world(random, 120));
    const double cell = obstacles.frame().resolution;
    CorridorSettings settings;
    settings.method = random.chance(0.5) ? CorridorMethod::Mdsrc : CorridorMethod::Fewest;
    settings.space = random.chance(0.5) ? CorridorSpace::Workspace : CorridorSpace::Configuration;
    settings.num_orientations = random.integer(1, 10);
    settings.inward_offset = cell * random.uniform(0.0, 4.0);
    settings.min_overlap_area = random.chance(0.2) ? 0.0 : 3.0 * cell * cell;
    settings.waypoint_spacing = cell * random.uniform(0.5, 4.0);
    settings.growth_step = cell * random.uniform(0.3, 3.0);
    const double radius = cell * random.uniform(0.0, 4.0);
    const bool wide = random.chance(0.7);
    const double room = settings.space == CorridorSpace::Workspace
                            ? settings.inward_offset * std::sqrt(2.0)
                            : radius;
    const auto path = test::random_path(random, obstacles, wide ? room + cell : radius);
    if (!path) continue;
    const CorridorResult result = build_corridor(obstacles, *path, radius, settings);
    if (result.status == CorridorStatus::Built) {
      test::expect_a_sound_chain(obstacles, *path, result.corridor, settings, trial % 8 == 0);
      ++built;
    } else {
      EXPECT_GE(result.stuck_at, 0.0);
      EXPECT_LE(result.stuck_at, path->length() + test::kRounding);
      EXPECT_LT(result.stuck_waypoint, path->waypoints.size());
      ++stuck;
    }
  }
  EXPECT_GT(built, 150);
  EXPECT_GT(stuck, 5);
}

}  // namespace
}  // namespace fairway
