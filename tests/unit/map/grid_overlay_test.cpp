// SPDX-License-Identifier: Apache-2.0
#include "fairway/map/grid_overlay.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace fairway {
namespace {

BitGrid free_grid(int width, int height, double resolution, const Pose2& origin) {
  return {GridFrame{.width = width, .height = height, .resolution = resolution, .origin = origin},
          false};
}

int num_blocked(const BitGrid& grid) {
  int count = 0;
  for (int y = 0; y < grid.frame().height; ++y) {
    for (int x = 0; x < grid.frame().width; ++x)
      count += grid.blocked({x, y}) ? 1 : 0;
  }
  return count;
}

TEST(GridOverlay, KeepsCellsOfTheSameRaster) {
  BitGrid onto = free_grid(200, 100, 0.05, {});
  BitGrid from = free_grid(70, 70, 0.05, {.position = {1.0, 2.0}, .heading = 0.0});
  from.set({3, 4}, true);
  from.set({69, 5}, true);
  add_obstacles(from, onto);
  EXPECT_TRUE(onto.blocked({23, 44}));
  EXPECT_TRUE(onto.blocked({89, 45}));
  EXPECT_EQ(num_blocked(onto), 2);
}

TEST(GridOverlay, KeepsEarlierCells) {
  BitGrid onto = free_grid(10, 10, 0.1, {});
  onto.set({1, 1}, true);
  add_obstacles(free_grid(10, 10, 0.1, {}), onto);
  EXPECT_TRUE(onto.blocked({1, 1}));
  EXPECT_EQ(num_blocked(onto), 1);
}

TEST(GridOverlay, LeavesNoHoleUnderLargerCells) {
  BitGrid onto = free_grid(100, 100, 0.05, {});
  BitGrid from = free_grid(4, 4, 0.5, {.position = {1.0, 1.0}, .heading = 0.0});
  from.set({1, 1}, true);
  add_obstacles(from, onto);
  EXPECT_EQ(num_blocked(onto), 100);
  EXPECT_TRUE(onto.blocked({30, 30}));
  EXPECT_TRUE(onto.blocked({39, 39}));
  EXPECT_FALSE(onto.blocked({40, 39}));
}

TEST(GridOverlay, FollowsTurnedGridsAndDropsOutsideCells) {
  BitGrid onto = free_grid(40, 40, 0.1, {});
  BitGrid from =
      free_grid(30, 30, 0.1, {.position = {2.0, 1.0}, .heading = 0.5 * std::numbers::pi});
  from.set({5, 2}, true);    // world (2 - 0.25, 1 + 0.55)
  from.set({29, 29}, true);  // world (2 - 2.95, ...): left of the map
  add_obstacles(from, onto);
  EXPECT_TRUE(onto.blocked({17, 15}));
  EXPECT_EQ(num_blocked(onto), 1);
}

TEST(GridOverlay, DoesNotChangeAnEmptyGrid) {
  BitGrid nothing;
  BitGrid onto = free_grid(3, 3, 0.1, {});
  add_obstacles(nothing, onto);
  EXPECT_EQ(num_blocked(onto), 0);
}

}  // namespace
}  // namespace fairway
