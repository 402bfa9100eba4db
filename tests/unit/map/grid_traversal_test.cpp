// SPDX-License-Identifier: Apache-2.0
#include "fairway/map/grid_traversal.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "support/oracles/cell_oracle.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

struct Visit {
  CellIndex cell;
  double share;
};

std::vector<Visit> visits(const Vector2d& from, const Vector2d& to) {
  std::vector<Visit> all;
  walk_cells(from, to, [&](CellIndex cell, double share) {
    all.push_back({cell, share});
    return true;
  });
  return all;
}

TEST(GridTraversal, VisitsExactlyTheCellsThatTheSegmentCrosses) {
  test::Random random(1);
  for (int trial = 0; trial < 400; ++trial) {
    Vector2d from(random.uniform(-9, 9), random.uniform(-9, 9));
    Vector2d to(random.uniform(-9, 9), random.uniform(-9, 9));
    if (random.chance(0.2)) to.x() = from.x();
    if (random.chance(0.2)) to.y() = from.y();
    if (random.chance(0.2)) from = from.array().round();
    if (random.chance(0.2)) to = to.array().round();
    const std::vector<Visit> seen = visits(from, to);
    for (const Visit& visit : seen) {
      const auto crossing = test::cross_cell(from, to, visit.cell);
      ASSERT_TRUE(crossing) << "a cell that the segment misses";
      EXPECT_NEAR(visit.share, crossing->enter, 1e-9);
    }
    for (int y = -12; y <= 12; ++y) {
      for (int x = -12; x <= 12; ++x) {
        const auto crossing = test::cross_cell(from, to, {.x = x, .y = y});
        if (!crossing || crossing->leave - crossing->enter < 1e-9) continue;
        // A segment on an edge belongs to the cell above or to the right.
        const Vector2d middle = from + 0.5 * (crossing->enter + crossing->leave) * (to - from);
        if (std::floor(middle.x()) != x || std::floor(middle.y()) != y) continue;
        EXPECT_EQ(std::count_if(seen.begin(), seen.end(),
                                [&](const Visit& v) {
                                  return v.cell == CellIndex{x, y};
                                }),
                  1);
      }
    }
  }
}

TEST(GridTraversal, EveryCellIsANeighbourOfTheOneBefore) {
  test::Random random(2);
  for (int trial = 0; trial < 200; ++trial) {
    const Vector2d from(random.uniform(-50, 50), random.uniform(-50, 50));
    const Vector2d to(random.uniform(-50, 50), random.uniform(-50, 50));
    const std::vector<Visit> seen = visits(from, to);
    EXPECT_EQ(seen.front().cell.x, static_cast<int>(std::floor(from.x())));
    EXPECT_EQ(seen.back().cell.y, static_cast<int>(std::floor(to.y())));
    for (std::size_t i = 1; i < seen.size(); ++i) {
      EXPECT_EQ(std::abs(seen[i].cell.x - seen[i - 1].cell.x) +
                    std::abs(seen[i].cell.y - seen[i - 1].cell.y),
                1);
      EXPECT_GE(seen[i].share, seen[i - 1].share);
    }
  }
}

TEST(GridTraversal, StopsOnRequest) {
  int count = 0;
  walk_cells({0.5, 0.5}, {9.5, 0.5}, [&](CellIndex, double) { return ++count < 3; });
  EXPECT_EQ(count, 3);
}

TEST(GridTraversal, APointIsInOneCell) { EXPECT_EQ(visits({2.5, -0.5}, {2.5, -0.5}).size(), 1U); }

}  // namespace
}  // namespace fairway
