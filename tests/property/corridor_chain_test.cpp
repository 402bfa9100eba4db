// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "fairway/corridor/corridor_builder.hpp"
#include "fairway/map/free_space.hpp"
#include "support/geometry_oracle.hpp"
#include "support/random_path.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

constexpr double kRounding = 1e-9;  // [m]; of a point that lies on a side

Vector2d point_at(const Path& path, double s) {
  for (std::size_t i = 1; i < path.waypoints.size(); ++i) {
    const Vector2d way = path.waypoints[i] - path.waypoints[i - 1];
    if (s <= way.norm()) return path.waypoints[i - 1] + way.normalized() * s;
    s -= way.norm();
  }
  return path.waypoints.back();
}

// What build_corridor promises when it says Built.
void expect_a_sound_chain(const BitGrid& obstacles,
                          const Path& path,
                          const Corridor& corridor,
                          const CorridorSettings& settings,
                          bool look_at_every_cell) {
  const double clearance = corridor.space == CorridorSpace::Workspace ? 0.0 : corridor.robot_radius;
  ASSERT_FALSE(corridor.rectangles.empty());
  ASSERT_EQ(corridor.spans.size(), corridor.rectangles.size());
  const std::size_t n = corridor.rectangles.size();
  for (std::size_t i = 0; i < n; ++i) {
    const OrientedRectangle& r = corridor.rectangles[i];
    EXPECT_TRUE(is_free(obstacles, r, clearance));
    EXPECT_TRUE(r.contains(r.seed, kRounding));
    if (look_at_every_cell) {
      EXPECT_GT(test::clearance(obstacles, r), clearance);
    }
    const PathSpan& span = corridor.spans[i];
    ASSERT_LE(span.from, span.to);
    for (double s = span.from; s <= span.to; s += 0.02)
      EXPECT_TRUE(corridor.admissible(i).contains(point_at(path, s), kRounding));
    if (i == 0) continue;
    EXPECT_LE(span.from, corridor.spans[i - 1].to + kRounding);
    EXPECT_GT(span.to, corridor.spans[i - 1].to);
    const OverlapPatch patch = overlap(corridor.admissible(i - 1), corridor.admissible(i));
    EXPECT_GT(patch.count, 0);
    EXPECT_GE(patch.area(), settings.min_overlap_area);
  }
  EXPECT_TRUE(corridor.admissible(0).contains(path.waypoints.front(), kRounding));
  EXPECT_TRUE(corridor.admissible(n - 1).contains(path.waypoints.back(), kRounding));
  EXPECT_EQ(corridor.spans.front().from, 0.0);
  EXPECT_NEAR(corridor.spans.back().to, path.length(), kRounding);
}

TEST(CorridorChain, FewestCoversEveryPathThatHasRoomForThePatch) {
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
    // Every point of the path has a disc of radius margin / sqrt(2) in any rectangle about it.
    settings.min_overlap_area = 1.57 * margin * margin;
    settings.longest_side = random.chance(0.5) ? 16.0 : 40.0 * cell;
    const CorridorResult result = build_corridor(obstacles, *path, radius, settings);
    ASSERT_EQ(result.status, CorridorStatus::Built)
        << "trial " << trial << " stuck at " << result.stuck_at << " of " << path->length();
    expect_a_sound_chain(obstacles, *path, result.corridor, settings, trial % 8 == 0);
    ++built;
  }
  EXPECT_GT(built, 200);
}

TEST(CorridorChain, FewestCoversEveryFreePathWhenNoPatchIsAsked) {
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
    expect_a_sound_chain(obstacles, *path, result.corridor, settings, false);
  }
}

TEST(CorridorChain, WhateverIsBuiltIsSound) {
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
      expect_a_sound_chain(obstacles, *path, result.corridor, settings, trial % 8 == 0);
      ++built;
    } else {
      EXPECT_GE(result.stuck_at, 0.0);
      EXPECT_LE(result.stuck_at, path->length() + kRounding);
      EXPECT_LT(result.stuck_waypoint, path->waypoints.size());
      ++stuck;
    }
  }
  EXPECT_GT(built, 150);
  EXPECT_GT(stuck, 5);
}

}  // namespace
}  // namespace fairway
