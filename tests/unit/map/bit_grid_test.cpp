// SPDX-License-Identifier: Apache-2.0
#include "fairway/map/bit_grid.hpp"

#include <gtest/gtest.h>

#include "support/random_world.hpp"

namespace fairway {
namespace {

TEST(BitGrid, AgreesWithTheOccupancyGridInEveryCell) {
  test::Random random(1);
  for (int trial = 0; trial < 20; ++trial) {
    OccupancyGrid grid = test::random_world(random, 200);
    grid.set({3, 4}, CellState::Unknown);
    const BitGrid unknown_blocked(grid);
    const BitGrid unknown_free(grid, UnknownCells::Free);
    for (int y = -1; y <= grid.frame().height; ++y) {
      for (int x = -1; x <= grid.frame().width; ++x) {
        const CellState state = grid.at({x, y});
        EXPECT_EQ(unknown_blocked.blocked({x, y}), state != CellState::Free);
        EXPECT_EQ(unknown_free.blocked({x, y}), state == CellState::Occupied);
      }
    }
  }
}

TEST(BitGrid, FirstBlockedAgreesWithALoop) {
  test::Random random(2);
  for (int trial = 0; trial < 20; ++trial) {
    const BitGrid bits(test::random_world(random, 200));
    for (int i = 0; i < 500; ++i) {
      const int y = random.integer(0, bits.frame().height - 1);
      const int first = random.integer(0, bits.frame().width - 1);
      const int last = random.integer(0, bits.frame().width - 1);
      int expected = -1;
      for (int x = first; x <= last && expected < 0; ++x) {
        if (bits.blocked({x, y})) expected = x;
      }
      ASSERT_EQ(bits.first_blocked(y, first, last), expected);
    }
  }
}

TEST(BitGrid, SetChangesOneCellOnly) {
  BitGrid bits(GridFrame{.width = 130, .height = 3, .resolution = 1.0, .origin = {}}, true);
  bits.set({64, 1}, false);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 130; ++x)
      EXPECT_EQ(bits.blocked({x, y}), !(x == 64 && y == 1));
  }
  EXPECT_EQ(bits.row(0).back(), 0x3U) << "bits past the width stay 0";
}

TEST(BitGrid, WithoutCellsEverythingIsBlocked) { EXPECT_TRUE(BitGrid().blocked({0, 0})); }

}  // namespace
}  // namespace fairway
