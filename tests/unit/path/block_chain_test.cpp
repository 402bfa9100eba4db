// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/block_chain.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "fairway/path/search_grid.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

// A random allowed cell, or none after many attempts.
std::vector<Terminal> random_terminal(const TravelCost& costs, test::Random& random) {
  const GridFrame& frame = costs.frame();
  for (int attempt = 0; attempt < 200; ++attempt) {
    const CellIndex cell{random.integer(0, frame.width - 1), random.integer(0, frame.height - 1)};
    if (costs.is_allowed(cell)) return {{.node = cell, .cost = 0}};
  }
  return {};
}

TEST(BlockChain, LeadsThroughEveryBlockAndFitsWhereItIsFound) {
  test::Random random(61);
  int searched = 0;
  int found = 0;
  double sum = 0.0;
  for (int trial = 0; trial < 200; ++trial) {
    const BitGrid obstacles(test::random_world(random, 160));
    const DistanceField distances(obstacles);
    const double cell = obstacles.frame().resolution;
    const PathSettings settings{.margin = 0.0, .comfort_distance = 6 * cell};
    const TravelCost costs(obstacles, distances, random.uniform(1.0, 3.0) * cell, settings);
    const std::vector<Terminal> start = random_terminal(costs, random);
    const std::vector<Terminal> goal = random_terminal(costs, random);
    if (start.empty() || goal.empty()) continue;
    const Terminal from{.node = BlockGrid::block_of(start[0].node), .cost = 0};
    const Terminal to{.node = BlockGrid::block_of(goal[0].node), .cost = 0};
    BlockGrid blocks;
    blocks.begin(costs);
    GridSearch search;
    if (!search.find(blocks, {&from, 1}, {&to, 1}) || search.nodes().size() < 10) continue;
    ++searched;
    BlockChain chain;
    if (!chain.find(costs, search.nodes(), start, goal)) continue;
    ++found;
    const std::span<const Vector2d> points = chain.points();
    ASSERT_EQ(points.size(), search.nodes().size());
    double cost = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const CellIndex at{static_cast<int>(points[i].x()), static_cast<int>(points[i].y())};
      EXPECT_EQ(BlockGrid::block_of(at), search.nodes()[i]);
      EXPECT_TRUE(costs.is_allowed(at));
      if (i == 0) continue;
      EXPECT_TRUE(costs.fits(points[i - 1], points[i]));
      cost += costs.line(points[i - 1], points[i]).cost;
    }
    EXPECT_NEAR(chain.cost(), cost, 1e-9);
    // The cheapest chain of cells on the same map; a chain of points is often cheaper.
    CellGrid cells;
    cells.begin(costs);
    GridSearch fine;
    ASSERT_TRUE(fine.find(cells, start, goal));
    sum += cost * GridSearch::kStep * cells.unit() / fine.cost();
  }
  EXPECT_GT(searched, 80);
  EXPECT_GT(found, 0.8 * searched);
  EXPECT_LT(sum / found, 1.03);
}

// Two rooms of one block each beside a wall, with a passage that is narrower than a block.
TEST(BlockChain, AvoidsALineOnWhichTheRobotDoesNotFit) {
  BitGrid obstacles({.width = 24, .height = 12, .resolution = 0.1, .origin = {}}, false);
  for (int y = 0; y < 12; ++y) {
    if (y != 6) obstacles.set({11, y}, true);
  }
  const DistanceField distances(obstacles);
  const PathSettings settings{.margin = 0.0, .comfort_distance = 0.1};
  const TravelCost costs(obstacles, distances, 0.02, settings);
  const std::vector<CellIndex> blocks = {{1, 1}, {2, 1}, {3, 1}, {4, 1}};
  const std::vector<Terminal> start = {{.node = {6, 6}, .cost = 58}};
  const std::vector<Terminal> goal = {{.node = {18, 6}, .cost = 116}};
  BlockChain chain;
  ASSERT_TRUE(chain.find(costs, blocks, start, goal));
  for (std::size_t i = 1; i < chain.points().size(); ++i)
    EXPECT_TRUE(costs.fits(chain.points()[i - 1], chain.points()[i]));
  EXPECT_GE(chain.cost(), 12.0 + 3.0 / SearchGrid::unit_for(costs));
  // Nothing leads through the wall beside the passage.
  const std::vector<CellIndex> blocked = {{1, 0}, {2, 0}, {3, 0}, {4, 0}};
  const std::vector<Terminal> below = {{.node = {6, 2}, .cost = 0}};
  const std::vector<Terminal> beyond = {{.node = {18, 2}, .cost = 0}};
  EXPECT_FALSE(chain.find(costs, blocked, below, beyond));
}

}  // namespace
}  // namespace fairway
