// SPDX-License-Identifier: Apache-2.0
#include "fairway/map/distance_field.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/map/free_space.hpp"
#include "support/oracles/distance_oracle.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

constexpr double kRounding = 1.5e-7;  // relative; the header's guarantee

void expect_exact(const BitGrid& obstacles, const DistanceField& field) {
  const GridFrame& frame = obstacles.frame();
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const double expected = test::distance_to_blocked(obstacles, {x, y});
      ASSERT_NEAR(field.at({x, y}), expected, kRounding * expected) << x << ", " << y;
    }
  }
}

TEST(DistanceField, AgreesWithTheDistanceToEveryCell) {
  test::Random random(11);
  for (int trial = 0; trial < 60; ++trial) {
    const BitGrid obstacles(test::random_world(random, trial < 50 ? 40 : 110));
    expect_exact(obstacles, DistanceField(obstacles));
  }
}

TEST(DistanceField, IsExactForEveryDensity) {
  test::Random random(12);
  for (const double density : {0.0, 0.001, 0.01, 0.1, 0.5, 0.9, 1.0}) {
    for (const int width : {1, 2, 63, 64, 65}) {
      BitGrid obstacles({.width = width, .height = 37, .resolution = 0.1, .origin = {}}, false);
      for (int y = 0; y < 37; ++y) {
        for (int x = 0; x < width; ++x)
          obstacles.set({x, y}, random.chance(density));
      }
      expect_exact(obstacles, DistanceField(obstacles));
    }
  }
}

TEST(DistanceField, MeasuresToTheNearEdgeOfACell) {
  BitGrid obstacles({.width = 20, .height = 20, .resolution = 0.5, .origin = {}}, false);
  obstacles.set({10, 10}, true);
  const DistanceField field(obstacles);
  EXPECT_EQ(field.at({10, 10}), 0.0);
  EXPECT_FLOAT_EQ(static_cast<float>(field.at({11, 10})), 0.25F);
  EXPECT_FLOAT_EQ(static_cast<float>(field.at({10, 13})), 1.25F);
  EXPECT_FLOAT_EQ(static_cast<float>(field.at({11, 11})), 0.25F * std::sqrt(2.0F));
  EXPECT_FLOAT_EQ(static_cast<float>(field.at({0, 5})), 0.25F) << "the outside is blocked";
  EXPECT_EQ(field.at({-1, 5}), 0.0);
  EXPECT_EQ(field.at({20, 5}), 0.0);
}

TEST(DistanceField, TheLargestGridDoesNotOverflow) {
  const BitGrid tall({.width = 2, .height = 32768, .resolution = 1.0, .origin = {}}, false);
  EXPECT_EQ(DistanceField(tall).at({0, 16000}), 0.5);
  const BitGrid column({.width = 32768, .height = 1, .resolution = 1.0, .origin = {}}, false);
  EXPECT_EQ(DistanceField(column).at({16000, 0}), 0.5);
  const BitGrid broad({.width = 3000, .height = 2999, .resolution = 1.0, .origin = {}}, false);
  EXPECT_EQ(DistanceField(broad).at({1500, 1499}), 1499.5);
}

TEST(DistanceField, NoCellsGiveNoDistances) {
  const DistanceField none{BitGrid()};
  EXPECT_TRUE(none.cells().empty());
  EXPECT_EQ(none.at({0, 0}), 0.0);
}

TEST(DistanceField, AWindowUpdateGivesTheBitsOfAFullOne) {
  test::Random random(13);
  for (int trial = 0; trial < 60; ++trial) {
    BitGrid obstacles(test::random_world(random, 150));
    const GridFrame& frame = obstacles.frame();
    DistanceField field(obstacles);
    for (int change = 0; change < 5; ++change) {
      const CellIndex first{random.integer(-5, frame.width - 1),
                            random.integer(-5, frame.height - 1)};
      const CellIndex last{first.x + random.integer(0, 30), first.y + random.integer(0, 30)};
      const double density = random.uniform(-0.3, 0.5);  // often none, so that obstacles disappear
      for (int y = std::max(0, first.y); y <= std::min(last.y, frame.height - 1); ++y) {
        for (int x = std::max(0, first.x); x <= std::min(last.x, frame.width - 1); ++x)
          obstacles.set({x, y}, random.chance(density));
      }
      field.update(obstacles, {.first = first, .last = last});
      ASSERT_TRUE(std::ranges::equal(field.cells(), DistanceField(obstacles).cells()));
    }
  }
}

// Some cells are further from every obstacle than the trial of near columns reaches.
TEST(DistanceField, IsExactInOpenSpaces) {
  test::Random random(16);
  for (int trial = 0; trial < 4; ++trial) {
    BitGrid obstacles({.width = 260, .height = 230, .resolution = 0.1, .origin = {}}, false);
    for (int i = 0; i < trial; ++i)
      obstacles.set({random.integer(0, 259), random.integer(0, 229)}, true);
    DistanceField field(obstacles);
    for (int y = 0; y < 230; y += 7) {
      for (int x = 0; x < 260; ++x) {
        const double expected = test::distance_to_blocked(obstacles, {x, y});
        ASSERT_NEAR(field.at({x, y}), expected, kRounding * expected) << x << ", " << y;
      }
    }
    const CellIndex cell{random.integer(0, 259), random.integer(0, 229)};
    for (const bool blocked : {true, false}) {
      obstacles.set(cell, blocked);
      field.update(obstacles, {.first = cell, .last = cell});
      ASSERT_TRUE(std::ranges::equal(field.cells(), DistanceField(obstacles).cells()));
    }
  }
}

TEST(DistanceField, WithAReachGivesTheSameBitsUpToIt) {
  test::Random random(15);
  for (int trial = 0; trial < 60; ++trial) {
    BitGrid obstacles(test::random_world(random, 150));
    const GridFrame& frame = obstacles.frame();
    const double reach = random.uniform(0.2, DistanceField::kMostReach) * frame.resolution;
    DistanceField near;
    near.set_reach(reach);
    near.update(obstacles);
    for (int change = 0; change < 4; ++change) {
      const DistanceField all(obstacles);
      for (std::size_t i = 0; i < all.cells().size(); ++i)
        ASSERT_EQ(near.cells()[i], std::min(all.cells()[i], static_cast<float>(reach)));
      const CellIndex cell{random.integer(0, frame.width - 1), random.integer(0, frame.height - 1)};
      obstacles.set(cell, !obstacles.blocked(cell));
      near.update(obstacles, {.first = cell, .last = cell});
    }
  }
}

// Only some cells of the window differ, or none, and some changes are far from the cells that they
// concern.
TEST(DistanceField, AWindowMayBeLargerThanTheChange) {
  test::Random random(17);
  for (int trial = 0; trial < 60; ++trial) {
    const int width = random.integer(100, 300);
    BitGrid obstacles({.width = width, .height = 120, .resolution = 0.1, .origin = {}}, false);
    for (int i = random.integer(0, 60); i > 0; --i)
      obstacles.set({random.integer(0, width - 1), random.integer(0, 119)}, true);
    DistanceField field;
    if (trial % 3 == 0) field.set_reach(random.uniform(0.5, 5.0));
    field.update(obstacles);
    for (int change = 0; change < 6; ++change) {
      for (int i = random.integer(0, 4); i > 0; --i) {
        const CellIndex cell{random.integer(10, width - 20), random.integer(5, 110)};
        obstacles.set(cell, !obstacles.blocked(cell));
      }
      field.update(obstacles, {.first = {10, 5}, .last = {width - 20, 110}});
      DistanceField all;
      all.set_reach(field.reach());
      all.update(obstacles);
      ASSERT_TRUE(std::ranges::equal(field.cells(), all.cells()));
    }
  }
}

TEST(DistanceField, AnEmptyWindowChangesNothing) {
  BitGrid obstacles({.width = 20, .height = 20, .resolution = 0.5, .origin = {}}, false);
  DistanceField field(obstacles);
  const std::vector<float> before(field.cells().begin(), field.cells().end());
  field.update(obstacles, {.first = {5, 5}, .last = {4, 9}});
  field.update(obstacles, {.first = {25, 5}, .last = {30, 9}});
  EXPECT_TRUE(std::ranges::equal(field.cells(), before));
}

}  // namespace
}  // namespace fairway
