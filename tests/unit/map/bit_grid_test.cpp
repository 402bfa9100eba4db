// SPDX-License-Identifier: Apache-2.0
#include "fairway/map/bit_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include <gtest/gtest.h>

#include "support/random/random_world.hpp"

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
  EXPECT_EQ(bits.row(0).back(), 0x3U) << "bits beyond the width stay 0";
}

void expect_bands_to_be_their_rows(const BitGrid& bits) {
  const int height = bits.frame().height;
  for (int first = 0; first < height; first += BitGrid::kBandRows) {
    const int b = first / BitGrid::kBandRows;
    for (std::size_t w = 0; w < bits.row(0).size(); ++w) {
      std::uint64_t rows = 0;
      for (int y = first; y < std::min(height, first + BitGrid::kBandRows); ++y)
        rows |= bits.row(y)[w];
      ASSERT_EQ(bits.band(b)[w], rows) << "band " << b << " word " << w;
    }
  }
}

TEST(BitGrid, BandsAreTheUnionOfTheirRowsAfterAnyWrite) {
  test::Random random(3);
  for (int trial = 0; trial < 10; ++trial) {
    const OccupancyGrid world = test::random_world(random, 150);
    BitGrid bits(world.frame(), random.chance(0.5));
    expect_bands_to_be_their_rows(bits);
    for (int i = 0; i < 3000; ++i) {
      bits.set({.x = random.integer(0, world.frame().width - 1),
                .y = random.integer(0, world.frame().height - 1)},
               random.chance(0.5));
    }
    expect_bands_to_be_their_rows(bits);
    bits.assign(world);
    expect_bands_to_be_their_rows(bits);
    bits.rewrite([](const auto& words_of_row) {
      words_of_row(2)[0] = 0x5;
      words_of_row(9)[0] = 0;
    });
    expect_bands_to_be_their_rows(bits);
    EXPECT_TRUE(bits.blocked({2, 2}));
  }
}

TEST(BitGrid, AnyBlockedAgreesWithALoop) {
  test::Random random(4);
  for (int trial = 0; trial < 20; ++trial) {
    const BitGrid bits(test::random_world(random, 200));
    const GridFrame& frame = bits.frame();
    for (int i = 0; i < 300; ++i) {
      const int y = random.integer(0, frame.height - 1);
      const int first = random.integer(0, frame.width - 1);
      const int last = random.integer(0, frame.width - 1);
      const int b = y / BitGrid::kBandRows;
      bool in_row = false;
      bool in_band = false;
      for (int x = first; x <= last; ++x) {
        in_row = in_row || bits.blocked({x, y});
        for (int k = 0; k < BitGrid::kBandRows; ++k) {
          const CellIndex cell{.x = x, .y = b * BitGrid::kBandRows + k};
          in_band = in_band || (frame.contains(cell) && bits.blocked(cell));
        }
      }
      ASSERT_EQ(bits.any_blocked(y, first, last), in_row);
      ASSERT_EQ(bits.any_blocked_in_band(b, first, last), in_band);
    }
  }
}

TEST(BitGrid, CopiesAWindowAndItsBands) {
  test::Random random(15);
  for (int trial = 0; trial < 40; ++trial) {
    BitGrid to(test::random_world(random, 200));
    const GridFrame frame = to.frame();
    BitGrid from(frame, false);
    BitGrid expected = to;
    const CellIndex first{random.integer(0, frame.width - 1), random.integer(0, frame.height - 1)};
    const CellIndex last{random.integer(first.x, frame.width - 1),
                         random.integer(first.y, frame.height - 1)};
    for (int y = 0; y < frame.height; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        from.set({x, y}, random.chance(0.2));
        const bool inside = x >= first.x && x <= last.x && y >= first.y && y <= last.y;
        if (inside) expected.set({x, y}, from.blocked({x, y}));
      }
    }
    to.copy(from, {.first = first, .last = last});
    for (int y = 0; y < frame.height; ++y) {
      ASSERT_TRUE(std::ranges::equal(to.row(y), expected.row(y)));
      const int b = y / BitGrid::kBandRows;
      ASSERT_TRUE(std::ranges::equal(to.band(b), expected.band(b)));
    }
  }
}

TEST(BitGrid, APartHasTheSameCellsAtTheSamePlaces) {
  test::Random random(12);
  for (int round = 0; round < 300; ++round) {
    const GridFrame frame{.width = random.integer(1, 150),
                          .height = random.integer(1, 30),
                          .resolution = 0.05,
                          .origin = {{random.uniform(-9, 9), 2.0}, random.uniform(-3, 3)}};
    BitGrid grid(frame, false);
    for (int y = 0; y < frame.height; ++y) {
      for (int x = 0; x < frame.width; ++x)
        grid.set({x, y}, random.chance(0.3));
    }
    const CellWindow window{.first = {random.integer(-5, 150), random.integer(-5, 30)},
                            .last = {random.integer(-5, 155), random.integer(-5, 35)}};
    const BitGrid part = grid.part(window);
    const CellWindow inside = clipped(window, frame);
    EXPECT_EQ(part.frame().width, std::max(0, inside.last.x - inside.first.x + 1) *
                                      static_cast<int>(!is_empty(inside)));
    for (int y = 0; y < part.frame().height; ++y) {
      for (int x = 0; x < part.frame().width; ++x) {
        const CellIndex cell{inside.first.x + x, inside.first.y + y};
        ASSERT_EQ(part.blocked({x, y}), grid.blocked(cell));
        ASSERT_LT((part.frame().center({x, y}) - frame.center(cell)).norm(), 1e-12);
        ASSERT_EQ(part.any_blocked_in_band(y / BitGrid::kBandRows, x, x), [&] {
          const int first = y / BitGrid::kBandRows * BitGrid::kBandRows;
          for (int i = first; i < std::min(first + 8, part.frame().height); ++i) {
            if (part.blocked({x, i})) return true;
          }
          return false;
        }());
      }
    }
    // Bits past the width stay 0.
    for (int y = 0; y < part.frame().height; ++y) {
      int ones = 0;
      for (const std::uint64_t word : part.row(y))
        ones += std::popcount(word);
      int blocked = 0;
      for (int x = 0; x < part.frame().width; ++x)
        blocked += static_cast<int>(part.blocked({x, y}));
      ASSERT_EQ(ones, blocked);
    }
  }
}

TEST(BitGrid, WithoutCellsEverythingIsBlocked) { EXPECT_TRUE(BitGrid().blocked({0, 0})); }

TEST(BitGrid, RefusesAFrameThatCannotBe) {
  const GridFrame good{.width = 4, .height = 3, .resolution = 0.1, .origin = {}};
  EXPECT_NO_THROW(BitGrid(good, false));
  for (const auto spoil :
       {+[](GridFrame& f) { f.width = -1; }, +[](GridFrame& f) { f.height = 40000; },
        +[](GridFrame& f) { f.resolution = 0.0; },
        +[](GridFrame& f) { f.resolution = std::nan(""); },
        +[](GridFrame& f) { f.origin.heading = INFINITY; }}) {
    GridFrame bad = good;
    spoil(bad);
    EXPECT_THROW(BitGrid(bad, false), std::invalid_argument);
  }
}

}  // namespace
}  // namespace fairway
