// SPDX-License-Identifier: Apache-2.0
#include "fairway/map/free_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <gtest/gtest.h>

#include "support/oracles/geometry_oracle.hpp"
#include "support/random/random_world.hpp"

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
      // Test just below and just above the true clearance, which is hardest.
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

// The distance from column `middle` to the nearest cell of row `y` that is at most `radius` [cells]
// from `region`; -1 when there is none. Tests cell by cell.
int nearest_in_row(
    const BitGrid& obstacles, const OrientedRectangle& region, double radius, int y, int middle) {
  const GridFrame& frame = obstacles.frame();
  int nearest = -1;
  for (int x = 0; x < frame.width; ++x) {
    const bool near =
        obstacles.blocked({x, y}) &&
        test::distance(region, test::cell_rectangle(frame, {x, y})) <= radius * frame.resolution;
    if (near && (nearest < 0 || std::abs(x - middle) < nearest)) nearest = std::abs(x - middle);
  }
  return nearest;
}

TEST(FreeSpace, FindsTheNearestBlockedCellOfEveryRow) {
  test::Random random(9);
  int rows = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const BitGrid obstacles(test::random_world(random, 60));
    const GridFrame& frame = obstacles.frame();
    const TurnedBox box{.origin = {random.uniform(0, frame.width), random.uniform(0, frame.height)},
                        .along = direction(random.uniform(-4, 4)),
                        .min = {-random.uniform(0, 20), -random.uniform(0, 20)},
                        .max = {random.uniform(0, 20), random.uniform(0, 20)}};
    const double radius = random.chance(0.5) ? 1e-5 : random.uniform(0.0, 6.0);
    const OrientedRectangle region{
        .seed = frame.to_world(box.origin),
        .orientation = frame.origin.heading + std::atan2(box.along.y(), box.along.x()),
        .min = box.min * frame.resolution,
        .max = box.max * frame.resolution};
    std::array<CellIndex, 100> cells;
    const BlockedCells blocked = find_blocked_cells(obstacles, box, radius, box.origin, cells);
    EXPECT_EQ(is_free(obstacles, box, radius), blocked.count == 0 && !blocked.outside_map);
    const int middle = std::clamp(static_cast<int>(box.origin.x()), 0, frame.width - 1);
    const std::span<const CellIndex> found(cells.data(), blocked.count);
    std::size_t expected = 0;
    for (int y = 0; y < frame.height; ++y) {
      const int nearest = nearest_in_row(obstacles, region, radius, y, middle);
      if (nearest < 0) continue;
      ++expected;
      const auto at = std::find_if(found.begin(), found.end(),
                                   [&](const CellIndex& cell) { return cell.y == y; });
      ASSERT_NE(at, found.end()) << "trial " << trial << " row " << y;
      EXPECT_TRUE(obstacles.blocked(*at));
      EXPECT_EQ(std::abs(at->x - middle), nearest) << "trial " << trial << " row " << y;
    }
    EXPECT_EQ(found.size(), expected);
    rows += static_cast<int>(expected);
  }
  EXPECT_GT(rows, 500);
}

TEST(FreeSpace, DetectsASinglePostAndADiagonalLineOfCells) {
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
      << "two cells that touch at a corner leave no gap";
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
