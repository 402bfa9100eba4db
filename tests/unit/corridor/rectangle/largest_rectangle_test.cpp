// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/rectangle/largest_rectangle.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "fairway/simulation/scenarios/generated_maps.hpp"
#include "support/oracles/geometry_oracle.hpp"
#include "support/oracles/rectangle_oracle.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

BitGrid empty_map(int side) {
  return {GridFrame{.width = side, .height = side, .resolution = 0.05, .origin = {}}, false};
}

Vector2d random_point(test::Random& random, const GridFrame& frame) {
  return frame.to_world({random.uniform(0, frame.width), random.uniform(0, frame.height)});
}

TEST(LargestRectangle, FillsAnEmptyMap) {
  const auto r = largest_rectangle(empty_map(100), 0.0, {.point = {2.0, 3.0}});
  ASSERT_TRUE(r.has_value());
  EXPECT_GT(r->area(), 24.9);
  EXPECT_LT(r->area(), 25.0);
}

TEST(LargestRectangle, AlignsWithAPassageBetweenTwoSlantedWalls) {
  BitGrid obstacles = empty_map(400);
  const double turn = 0.4;
  for (double t = -8.0; t < 8.0; t += 0.02) {
    for (const double side : {-0.6, 0.6}) {
      const Vector2d p = Vector2d(10, 10) + rotated({t, side}, turn);
      obstacles.set(obstacles.frame().cell_at(p), true);
    }
  }
  const auto r = largest_rectangle(obstacles, 0.0, {.point = {10, 10}});
  ASSERT_TRUE(r.has_value());
  EXPECT_NEAR(std::abs(std::remainder(r->orientation - turn, std::numbers::pi / 2)), 0.0, 0.02);
  EXPECT_GT(r->area(), 16.0 * 1.0);
}

TEST(LargestRectangle, IsFreeAndContainsItsAnchorsInRandomWorlds) {
  test::Random random(31);
  int found = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const BitGrid obstacles(test::random_world(random, 100));
    const double cell = obstacles.frame().resolution;
    const double clearance = random.chance(0.5) ? 0.0 : cell * random.uniform(0.0, 4.0);
    const Anchor seed{.point = random_point(random, obstacles.frame()),
                      .margin = cell * random.uniform(0.0, 1.0)};
    const Anchor other{
        .point = seed.point + cell * Vector2d(random.uniform(-5, 5), random.uniform(-5, 5)),
        .margin = 0.0};
    const auto r = largest_rectangle(obstacles, clearance, seed, {&other, 1},
                                     {.longest_side = cell * random.uniform(8.0, 100.0)});
    if (!r) continue;
    ++found;
    EXPECT_TRUE(is_free(obstacles, *r, clearance));
    EXPECT_GT(test::clearance(obstacles, *r), clearance);
    EXPECT_TRUE(r->contains(seed.point, 1e-9 - seed.margin));
    EXPECT_TRUE(r->contains(other.point, 1e-9));
  }
  EXPECT_GT(found, 150);
}

TEST(LargestRectangle, IsNearTheTrueOptimum) {
  const BitGrid obstacles(generate_map(MapKind::UnstructuredSmall, 3));
  test::Random random(32);
  double share = 0.0;
  int found = 0;
  while (found < 25) {
    const Vector2d seed = random_point(random, obstacles.frame());
    if (!is_free(obstacles, seed, seed, 0.3)) continue;
    const auto r = largest_rectangle(obstacles, 0.0, {.point = seed}, {}, {.longest_side = 16.0});
    ASSERT_TRUE(r.has_value());
    share += r->area() / test::largest_area_oracle(obstacles, seed, 16.0, 45);
    ++found;
  }
  // The oracle is an upper bound that lets cells protrude by up to half a cell.
  EXPECT_GT(share / found, 0.96);
}

TEST(LargestRectangle, HasNoSideAboveTheLimit) {
  const auto r =
      largest_rectangle(empty_map(400), 0.3, {.point = {9, 9}}, {}, {.longest_side = 3.0});
  ASSERT_TRUE(r.has_value());
  EXPECT_LE((r->max - r->min).maxCoeff(), 3.0 + 1e-9);
  EXPECT_GT(r->area(), 8.9);
}

TEST(LargestRectangle, IsDeterministic) {
  test::Random random(33);
  for (int trial = 0; trial < 50; ++trial) {
    const BitGrid obstacles(test::random_world(random, 100));
    const Anchor seed{.point = random_point(random, obstacles.frame())};
    const auto a = largest_rectangle(obstacles, 0.0, seed);
    const auto b = largest_rectangle(obstacles, 0.0, seed);
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) continue;
    EXPECT_EQ(a->min, b->min);
    EXPECT_EQ(a->max, b->max);
    EXPECT_EQ(a->orientation, b->orientation);
  }
}

TEST(LargestRectangle, RefusesInvalidSeeds) {
  BitGrid blocked = empty_map(20);
  blocked.set({10, 10}, true);
  const double nan = std::nan("");
  EXPECT_FALSE(largest_rectangle(blocked, 0.0, {.point = {0.52, 0.52}}));
  EXPECT_FALSE(largest_rectangle(blocked, 0.3, {.point = {0.4, 0.4}}));
  EXPECT_FALSE(largest_rectangle(blocked, 0.0, {.point = {-1.0, 0.5}}));
  EXPECT_FALSE(largest_rectangle(blocked, 0.0, {.point = {nan, 0.5}}));
  EXPECT_FALSE(largest_rectangle(blocked, 0.0, {.point = {1e300, 0.5}}));
  EXPECT_FALSE(largest_rectangle(BitGrid(), 0.0, {.point = {0.5, 0.5}}));
  EXPECT_FALSE(largest_rectangle(BitGrid(blocked.frame(), true), 0.0, {.point = {0.5, 0.5}}));
}

}  // namespace
}  // namespace fairway
