// SPDX-License-Identifier: Apache-2.0
#include "fairway/map/free_space.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "support/geometry_oracle.hpp"
#include "support/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

OrientedRectangle random_region(test::Random& random, const GridFrame& frame) {
  const double size = 20.0 * frame.resolution;
  OrientedRectangle r;
  r.seed = frame.to_world({random.uniform(0, frame.width), random.uniform(0, frame.height)});
  r.orientation = random.chance(0.3) ? frame.origin.heading : random.uniform(-4, 4);
  r.min = Vector2d(-random.uniform(0, size), -random.uniform(0, size));
  r.max = Vector2d(random.uniform(0, size), random.uniform(0, size));
  if (random.chance(0.2)) r.max.y() = r.min.y();  // a segment
  if (random.chance(0.1)) r.max = r.min;          // a point
  return r;
}

TEST(FreeSpace, AgreesWithTheDistanceToEveryCell) {
  test::Random random(7);
  int free = 0;
  int blocked = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const BitGrid obstacles(test::random_world(random, 60));
    for (int i = 0; i < 40; ++i) {
      const OrientedRectangle r = random_region(random, obstacles.frame());
      const double room = test::clearance(obstacles, r);
      // Ask just below and just above the true clearance: the sharpest question there is.
      if (room > 3.0 * kFreeSpaceSkin) {
        EXPECT_TRUE(is_free(obstacles, r, room - 2.0 * kFreeSpaceSkin));
        ++free;
      }
      EXPECT_FALSE(is_free(obstacles, r, room));
      ++blocked;
      const auto cell = find_blocked_cell(obstacles, r, room + 0.1 * obstacles.frame().resolution);
      ASSERT_TRUE(cell.has_value());
      EXPECT_TRUE(obstacles.blocked(*cell));
    }
  }
  EXPECT_GT(free, 200);
  EXPECT_GT(blocked, 200);
}

TEST(FreeSpace, SeesASinglePostAndADiagonalLineOfCells) {
  BitGrid obstacles(GridFrame{.width = 100, .height = 100, .resolution = 0.05, .origin = {}},
                    false);
  const OrientedRectangle r{.seed = {2.5, 2.5}, .orientation = 0.7, .min = {-1, -1}, .max = {1, 1}};
  EXPECT_TRUE(is_free(obstacles, r, 0.3));
  obstacles.set({50, 50}, true);
  EXPECT_FALSE(is_free(obstacles, r, 0.0));
  obstacles.set({50, 50}, false);
  for (int i = 0; i < 100; ++i)
    obstacles.set({i, i}, true);
  EXPECT_FALSE(is_free(obstacles, Vector2d(2.0, 3.0), Vector2d(3.0, 2.0), 0.0));
  EXPECT_FALSE(is_free(obstacles, Vector2d(2.0, 2.98), Vector2d(2.98, 2.02), 0.0))
      << "no slipping between two cells that touch at a corner";
}

TEST(FreeSpace, TouchingIsNotFree) {
  BitGrid obstacles(GridFrame{.width = 10, .height = 10, .resolution = 1.0, .origin = {}}, false);
  obstacles.set({5, 5}, true);
  const OrientedRectangle r{.seed = {4, 5.5}, .orientation = 0, .min = {-1, -0.1}, .max = {1, 0.1}};
  EXPECT_FALSE(is_free(obstacles, r, 0.0));
  OrientedRectangle gap = r;
  gap.max.x() -= 1e-5;
  EXPECT_TRUE(is_free(obstacles, gap, 0.0));
}

TEST(FreeSpace, TheOutsideOfTheMapIsBlocked) {
  const BitGrid obstacles(GridFrame{.width = 10, .height = 10, .resolution = 1.0, .origin = {}},
                          false);
  EXPECT_FALSE(is_free(obstacles, Vector2d(0.2, 5), Vector2d(5, 5), 0.3));
  EXPECT_TRUE(is_free(obstacles, Vector2d(0.4, 5), Vector2d(5, 5), 0.3));
  EXPECT_FALSE(is_free(obstacles, Vector2d(-3, 5), Vector2d(5, 5), 0.0));
  EXPECT_FALSE(is_free(obstacles, Vector2d(std::nan(""), 5), Vector2d(5, 5), 0.0));
  EXPECT_FALSE(is_free(obstacles, Vector2d(1e200, 5), Vector2d(5, 5), 0.0));
  EXPECT_FALSE(is_free(BitGrid(), Vector2d(1, 1), Vector2d(1, 1), 0.0));
}

TEST(FreeSpace, DistanceToBlockedAgreesWithEveryCell) {
  test::Random random(8);
  for (int trial = 0; trial < 30; ++trial) {
    const BitGrid obstacles(test::random_world(random, 60));
    const GridFrame& frame = obstacles.frame();
    for (int i = 0; i < 30; ++i) {
      const Vector2d p =
          frame.to_world({random.uniform(0, frame.width), random.uniform(0, frame.height)});
      const double room = test::clearance(obstacles, segment_rectangle(p, p));
      const double limit = random.uniform(0.0, 2.0);
      EXPECT_NEAR(distance_to_blocked(obstacles, p, limit), std::min(room, limit), 1e-9);
    }
  }
  EXPECT_EQ(distance_to_blocked(BitGrid(), {0, 0}, 1.0), 0.0);
}

}  // namespace
}  // namespace fairway
