// SPDX-License-Identifier: Apache-2.0
#include "fairway/map/occupancy_grid.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "support/random/random_world.hpp"

namespace fairway {
namespace {

TEST(OccupancyGrid, OutsideIsOccupied) {
  const OccupancyGrid grid({.width = 2, .height = 2, .resolution = 0.5, .origin = {}});
  EXPECT_EQ(grid.at({0, 0}), CellState::Free);
  EXPECT_EQ(grid.at({2, 0}), CellState::Occupied);
  EXPECT_EQ(grid.at({0, -1}), CellState::Occupied);
}

TEST(OccupancyGrid, RefusesInvalidSizesAndNumbers) {
  const GridFrame good{.width = 2, .height = 2, .resolution = 0.5, .origin = {}};
  for (const double resolution : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    GridFrame bad = good;
    bad.resolution = resolution;
    EXPECT_THROW(OccupancyGrid{bad}, std::invalid_argument);
  }
  for (const int side : {0, -1, OccupancyGrid::kMaxSide + 1}) {
    GridFrame bad = good;
    bad.width = side;
    EXPECT_THROW(OccupancyGrid{bad}, std::invalid_argument);
  }
  GridFrame bad = good;
  bad.origin.heading = std::nan("");
  EXPECT_THROW(OccupancyGrid{bad}, std::invalid_argument);
}

TEST(GridFrame, CellCentresAndWorldPointsAgreeInTurnedMaps) {
  test::Random random(5);
  for (int trial = 0; trial < 50; ++trial) {
    const GridFrame frame = test::random_world(random).frame();
    const CellIndex cell{random.integer(0, frame.width - 1), random.integer(0, frame.height - 1)};
    EXPECT_EQ(frame.cell_at(frame.center(cell)), cell);
    const Eigen::Vector2d p(random.uniform(-9, 9), random.uniform(-9, 9));
    EXPECT_LT((frame.to_world(frame.to_grid(p)) - p).norm(), 1e-11);
  }
}

TEST(GridFrame, FarOrNonFinitePointsLieOutside) {
  const GridFrame frame{.width = 2, .height = 2, .resolution = 0.5, .origin = {}};
  EXPECT_FALSE(frame.contains(frame.cell_at({1e300, 0})));
  EXPECT_FALSE(frame.contains(frame.cell_at({std::nan(""), 0.1})));
}

}  // namespace
}  // namespace fairway
