// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include <gtest/gtest.h>

#include "fairway/perception/rolling_grid.hpp"
#include "small_window.hpp"

namespace fairway {
namespace {

using test::beam;
using test::small_window;

TEST(RollingGrid, ADoubtedObstacleIsUnknownForPathsUntilABeamReachesIt) {
  const std::vector<Beam> wall = {beam({0, 0.01}, {1.01, 0.01})};
  const std::vector<Beam> elsewhere = {beam({0, 0.01}, {-1.01, 0.01})};
  const std::vector<Beam> past = {beam({0, 0.01}, {2.01, 0.01})};
  RollingGrid grid(small_window(), {0, 0});
  const CellIndex cell = grid.frame().cell_at({1.01, 0.01});
  for (int n = 0; n < 10; ++n)
    grid.insert(wall, {0, 0}, 0.2);
  for (int n = 0; n < 5; ++n)
    grid.insert(elsewhere, {0, 0}, 0.2);
  EXPECT_TRUE(is_empty(grid.doubt_unseen(6)));
  EXPECT_TRUE(grid.occupied().blocked(cell));
  const CellWindow changed = grid.doubt_unseen(5);
  EXPECT_EQ(changed.first, cell);
  EXPECT_EQ(changed.last, cell);
  EXPECT_FALSE(grid.occupied().blocked(cell));
  EXPECT_TRUE(grid.not_seen_free().blocked(cell));
  // One beam through a surely occupied cell does not clear it: it is an obstacle again.
  grid.insert(past, {0, 0}, 0.2);
  EXPECT_TRUE(grid.occupied().blocked(cell));
  EXPECT_EQ(grid.changed().first, cell);
}

TEST(RollingGrid, ADoubtedObstacleThatHasGoneIsCleared) {
  RollingGrid grid(small_window(), {0, 0});
  const CellIndex cell = grid.frame().cell_at({1.01, 0.01});
  grid.insert(std::vector<Beam>{beam({0, 0.01}, {1.01, 0.01})}, {0, 0}, 0.2);
  grid.insert({}, {0, 0}, 0.2);
  EXPECT_FALSE(is_empty(grid.doubt_unseen(1)));
  for (int n = 0; n < small_window().most_evidence; ++n)
    grid.insert(std::vector<Beam>{beam({0, 0.01}, {2.01, 0.01})}, {0, 0}, 0.2);
  EXPECT_EQ(grid.at(cell), CellState::Free);
  EXPECT_FALSE(grid.occupied().blocked(cell));
  EXPECT_FALSE(grid.not_seen_free().blocked(cell));
}

TEST(RollingGrid, KnowsWhatWasSeenLatelyBeyondTheEndOfTheScanNumbers) {
  RollingGrid grid(small_window(), {0, 0});
  const std::vector<Beam> old = {beam({0, 0.01}, {1.01, 0.01})};
  const std::vector<Beam> lately = {beam({0, 0.01}, {-1.01, 0.01})};
  grid.insert(old, {0, 0}, 0.2);
  for (int n = 0; n < 70000; ++n)
    grid.insert(n % 1000 == 0 || n == 69999 ? lately : std::vector<Beam>{}, {0, 0}, 0.2);
  EXPECT_FALSE(is_empty(grid.doubt_unseen(1000)));
  EXPECT_FALSE(grid.occupied().blocked(grid.frame().cell_at({1.01, 0.01})));
  EXPECT_TRUE(grid.occupied().blocked(grid.frame().cell_at({-1.01, 0.01})));
}

}  // namespace
}  // namespace fairway
