// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include <gtest/gtest.h>

#include "fairway/perception/rolling_grid.hpp"
#include "small_window.hpp"

namespace fairway {
namespace {

using test::beam;
using test::small_window;

TEST(RollingGrid, AnObstacleThatWasNeverFreeIsStatic) {
  RollingGrid grid(small_window(), {0, 0});
  const std::vector<Beam> hit = {beam({0, 0.01}, {1.01, 0.01})};
  const CellIndex cell = grid.frame().cell_at({1.01, 0.01});
  EXPECT_FALSE(grid.is_static_near(cell));
  grid.insert(hit, {0, 0}, 0.2);
  EXPECT_TRUE(grid.is_static_near(cell));
  EXPECT_TRUE(grid.is_static_near({cell.x + 1, cell.y - 1}));
  EXPECT_FALSE(grid.is_static_near({cell.x + 2, cell.y}));
  EXPECT_TRUE(grid.is_static_near({cell.x + 2, cell.y}, 2));
  EXPECT_FALSE(grid.is_static_near({-5, 3}));
  // Once it is surely free, it has to be hit for a while.
  for (int n = 0; n < 20; ++n)
    grid.insert(std::vector<Beam>{beam({0, 0.01}, {2.01, 0.01})}, {0, 0}, 0.2);
  for (int n = 0; n < RollingGrid::kNewScans; ++n) {
    EXPECT_FALSE(grid.is_static_near(cell)) << n;
    grid.insert(hit, {0, 0}, 0.2);
  }
  EXPECT_TRUE(grid.is_static_near(cell));
}

TEST(RollingGrid, TheCellUnderAMovingObjectStaysUnknown) {
  RollingGrid grid(small_window(), {0, 0});
  Beam moving = beam({0, 0.01}, {1.01, 0.01});
  moving.moving = true;
  grid.insert(std::vector<Beam>{moving}, {0, 0}, 0.2);
  EXPECT_EQ(grid.at(grid.frame().cell_at({1.01, 0.01})), CellState::Unknown);
  EXPECT_EQ(grid.at(grid.frame().cell_at({0.81, 0.01})), CellState::Free);
  // A known obstacle in its place is cleared.
  for (int n = 0; n < 5; ++n)
    grid.insert(std::vector<Beam>{beam({0, 0.01}, {1.01, 0.01})}, {0, 0}, 0.2);
  for (int n = 0; n < small_window().most_evidence; ++n)
    grid.insert(std::vector<Beam>{moving}, {0, 0}, 0.2);
  EXPECT_EQ(grid.at(grid.frame().cell_at({1.01, 0.01})), CellState::Free);
}

TEST(RollingGrid, AnObstacleIsProvenStaticAfterSomeScans) {
  RollingGrid grid(small_window(), {0, 0});
  const std::vector<Beam> hit = {beam({0, 0.01}, {1.01, 0.01})};
  const CellIndex cell = grid.frame().cell_at({1.01, 0.01});
  for (int n = 0; n <= RollingGrid::kProofScans; ++n) {
    EXPECT_FALSE(grid.is_proven_static(cell)) << n;
    grid.insert(hit, {0, 0}, 0.2);
  }
  EXPECT_TRUE(grid.is_proven_static(cell));
  EXPECT_TRUE(grid.is_proven_static({cell.x - 1, cell.y + 1}));
  EXPECT_FALSE(grid.is_proven_static({cell.x - 2, cell.y}));
  EXPECT_FALSE(grid.would_be_new(cell));
}

}  // namespace
}  // namespace fairway
