// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/rectangle/rectangle_growth.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/oracles/geometry_oracle.hpp"
#include "support/oracles/growth_oracle.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

Vector2d random_seed_point(test::Random& random, const GridFrame& frame) {
  return frame.to_world({random.uniform(0, frame.width), random.uniform(0, frame.height)});
}

TEST(RectangleGrowth, IsFreeContainsTheSeedAndCannotGrowByACell) {
  test::Random random(41);
  int found = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const BitGrid obstacles(test::random_world(random, 100));
    const double cell = obstacles.frame().resolution;
    const double clearance = random.chance(0.5) ? 0.0 : cell * random.uniform(0.0, 4.0);
    const GrowthSettings settings{.num_orientations = random.integer(1, 12),
                                  .growth_step = cell * random.uniform(0.2, 5.0),
                                  .max_growth = cell * random.uniform(10.0, 80.0),
                                  .start_size = cell * random.uniform(0.0, 1.0)};
    const Vector2d seed = random_seed_point(random, obstacles.frame());
    const auto r = grow_rectangle(obstacles, clearance, seed, settings);
    if (!r) continue;
    ++found;
    EXPECT_TRUE(is_free(obstacles, *r, clearance));
    if (trial % 4 == 0) {
      EXPECT_GT(test::clearance(obstacles, *r), clearance);
    }
    EXPECT_TRUE(r->contains(seed, 1e-9 - settings.start_size));
    const double step = std::min(cell, settings.growth_step) + 1e-6;
    for (int side = 0; side < 4; ++side) {
      OrientedRectangle larger = *r;
      double& place = (side < 2 ? larger.min : larger.max)[side % 2];
      place += side < 2 ? -step : step;
      EXPECT_LE(std::abs(place), settings.max_growth + 2.0 * step);
      const bool too_far = std::abs(place) > settings.max_growth;
      EXPECT_TRUE(too_far || !is_free(obstacles, larger, clearance)) << "side " << side;
    }
  }
  EXPECT_GT(found, 120);
}

TEST(RectangleGrowth, EqualsGrowthStepByStepOnTheMap) {
  test::Random random(44);
  int compared = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const BitGrid obstacles(test::random_world(random, 100));
    const double cell = obstacles.frame().resolution;
    const double clearance = random.chance(0.5) ? 0.0 : cell * random.uniform(0.0, 4.0);
    GrowthSettings settings{.num_orientations = 1,
                            .growth_step = cell * random.uniform(1.1, 4.0),
                            .max_growth = cell * random.uniform(10.0, 80.0),
                            .start_size = cell * random.uniform(0.0, 3.0)};
    const Vector2d seed = random_seed_point(random, obstacles.frame());
    const auto slow = test::grow_step_by_step(obstacles, clearance, seed, 0.0, settings);
    const auto quick = grow_rectangle(obstacles, clearance, seed, settings);
    ASSERT_EQ(quick.has_value(), slow.has_value()) << trial;
    if (!slow) continue;
    ++compared;
    EXPECT_TRUE(quick->min.isApprox(slow->min, 1e-9)) << trial;
    EXPECT_TRUE(quick->max.isApprox(slow->max, 1e-9)) << trial;

    settings.num_orientations = 7;
    double largest = 0.0;
    for (int k = 0; k < 7; ++k) {
      const auto turned = test::grow_step_by_step(obstacles, clearance, seed,
                                                  std::numbers::pi / 14.0 * k, settings);
      if (turned) largest = std::max(largest, turned->area());
    }
    EXPECT_NEAR(grow_rectangle(obstacles, clearance, seed, settings)->area(), largest, 1e-9);
  }
  EXPECT_GT(compared, 120);
}

TEST(RectangleGrowth, TheBestOrientationIsNeverSmallerThanTheFirst) {
  test::Random random(42);
  for (int trial = 0; trial < 100; ++trial) {
    const BitGrid obstacles(test::random_world(random, 100));
    const Vector2d seed = random_seed_point(random, obstacles.frame());
    const auto one = grow_rectangle(obstacles, 0.0, seed, {.num_orientations = 1});
    const auto ten = grow_rectangle(obstacles, 0.0, seed, {});
    if (!one) continue;
    ASSERT_TRUE(ten.has_value());
    EXPECT_GE(ten->area(), one->area());
  }
}

TEST(RectangleGrowth, ShiftingTheWorldByWholeCellsShiftsTheAnswer) {
  test::Random random(43);
  for (int trial = 0; trial < 100; ++trial) {
    OccupancyGrid world = test::random_world(random, 80);
    GridFrame frame = world.frame();
    frame.origin = {};
    frame.resolution = 0.0625;  // multiples of the cell size are exact numbers
    const int dx = random.integer(1, 9);
    const int dy = random.integer(1, 9);
    GridFrame large = frame;
    large.width += dx;
    large.height += dy;
    BitGrid before(frame, false);
    BitGrid after(large, true);
    for (int y = 0; y < frame.height; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        const bool blocked = world.at({x, y}) != CellState::Free;
        before.set({x, y}, blocked);
        after.set({x + dx, y + dy}, blocked);
      }
    }
    const Vector2d seed(random.integer(0, frame.width * 16) / 256.0,
                        random.integer(0, frame.height * 16) / 256.0);
    const Vector2d shift(dx * frame.resolution, dy * frame.resolution);
    const auto a = grow_rectangle(before, 0.0, seed, {});
    const auto b = grow_rectangle(after, 0.0, seed + shift, {});
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) continue;
    EXPECT_EQ(a->orientation, b->orientation);
    EXPECT_TRUE(a->min.isApprox(b->min, 1e-9));
    EXPECT_TRUE(a->max.isApprox(b->max, 1e-9));
  }
}

TEST(RectangleGrowth, ExcludesASinglePostAndAOneCellDiagonal) {
  BitGrid obstacles(GridFrame{.width = 200, .height = 200, .resolution = 0.05, .origin = {}},
                    false);
  obstacles.set({120, 103}, true);
  for (int i = 0; i < 60; ++i)
    obstacles.set({20 + i, 80 - i}, true);
  const auto r = grow_rectangle(obstacles, 0.0, {5.0, 5.0}, {});
  ASSERT_TRUE(r.has_value());
  EXPECT_GT(test::clearance(obstacles, *r), 0.0);
}

TEST(RectangleGrowth, RefusesInvalidSeeds) {
  BitGrid obstacles(GridFrame{.width = 20, .height = 20, .resolution = 0.05, .origin = {}}, false);
  obstacles.set({10, 10}, true);
  EXPECT_FALSE(grow_rectangle(obstacles, 0.0, {0.52, 0.52}, {}));
  EXPECT_FALSE(grow_rectangle(obstacles, 0.0, {std::nan(""), 0.5}, {}));
  EXPECT_FALSE(grow_rectangle(obstacles, 0.0, {-0.5, 0.5}, {}));
  EXPECT_FALSE(grow_rectangle(BitGrid(), 0.0, {0.5, 0.5}, {}));
}

}  // namespace
}  // namespace fairway
