// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/physics/cell_boxes.hpp"

#include <gtest/gtest.h>

#include "support/random/random_world.hpp"

namespace fairway {
namespace {

TEST(CellBoxes, CoverExactlyTheBlockedCellsOnce) {
  test::Random random(1);
  for (int trial = 0; trial < 30; ++trial) {
    const BitGrid obstacles(test::random_world(random));
    BitGrid covered(obstacles.frame(), false);
    for (const CellWindow& box : cover_with_boxes(obstacles)) {
      for (int y = box.first.y; y <= box.last.y; ++y) {
        for (int x = box.first.x; x <= box.last.x; ++x) {
          ASSERT_TRUE(obstacles.blocked({x, y}));
          ASSERT_FALSE(covered.blocked({x, y})) << "covered twice";
          covered.set({x, y}, true);
        }
      }
    }
    for (int y = 0; y < obstacles.frame().height; ++y) {
      for (int x = 0; x < obstacles.frame().width; ++x)
        ASSERT_EQ(covered.blocked({x, y}), obstacles.blocked({x, y}));
    }
  }
}

TEST(CellBoxes, ABlockIsOneBox) {
  BitGrid obstacles(GridFrame{.width = 200, .height = 50, .resolution = 0.05, .origin = {}}, false);
  for (int y = 10; y < 30; ++y) {
    for (int x = 20; x < 150; ++x)
      obstacles.set({x, y}, true);
  }
  EXPECT_EQ(cover_with_boxes(obstacles).size(), 1U);
  EXPECT_EQ(cover_with_boxes(BitGrid(obstacles.frame(), true)).size(), 1U);
  EXPECT_TRUE(cover_with_boxes(BitGrid(obstacles.frame(), false)).empty());
}

}  // namespace
}  // namespace fairway
