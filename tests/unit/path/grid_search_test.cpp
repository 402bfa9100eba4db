// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/grid_search.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "support/oracles/path_oracle.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

unsigned direction_of(CellIndex from, CellIndex to) {
  unsigned direction = 0;
  while (from.x + kStepX[direction] != to.x || from.y + kStepY[direction] != to.y)
    ++direction;
  return direction;
}

template <typename Grid>
void make_all_known(Grid& grid) {
  std::vector<std::uint32_t> so_far(static_cast<std::size_t>(grid.stride()) *
                                    (static_cast<std::size_t>(grid.height()) + 2));
  grid.prepare_rows(-1, grid.height(), so_far.data());
}

struct Tally {
  int found = 0;
  int none = 0;
};

// Compares one search with the oracle on the same grid, which must have been started.
template <typename Grid>
void expect_cheapest(Grid& grid, GridSearch& search, Terminal start, Terminal goal, Tally& tally) {
  const bool found = search.find(grid, {&start, 1}, {&goal, 1});
  make_all_known(grid);
  const auto cost = [&](CellIndex node) {
    return grid.nodes()[grid.index(node)] & SearchGrid::kCost;
  };
  const auto ways = test::cheapest_ways(
      grid.width(), grid.height(), start.node, cost,
      [&](CellIndex a, CellIndex b) { return grid.linked(a, direction_of(a, b)); });
  const std::uint64_t expected =
      ways[static_cast<std::size_t>(goal.node.y * grid.width() + goal.node.x)];
  ASSERT_EQ(found, expected != test::kNoWay);
  if (!found) {
    ++tally.none;
    return;
  }
  ++tally.found;
  ASSERT_EQ(search.cost(), expected + start.cost + goal.cost);
  std::uint64_t sum = start.cost + goal.cost;
  const auto nodes = search.nodes();
  EXPECT_EQ(nodes.front(), start.node);
  EXPECT_EQ(nodes.back(), goal.node);
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const unsigned d = direction_of(nodes[i - 1], nodes[i]);
    EXPECT_TRUE(grid.linked(nodes[i - 1], d));
    sum +=
        (d % 2 == 0 ? 29U : 41U) * static_cast<std::uint64_t>(cost(nodes[i - 1]) + cost(nodes[i]));
  }
  EXPECT_EQ(sum, search.cost()) << "the reported cost is that of the path";
}

PathSettings random_settings(test::Random& random) {
  PathSettings settings;
  settings.comfort_weight = random.chance(0.3) ? 0.0 : random.uniform(0.0, 6.0);
  settings.comfort_distance = random.uniform(0.0, 1.0);
  return settings;
}

TEST(GridSearch, HasTheCostOfDijkstrasAlgorithm) {
  test::Random random(21);
  GridSearch search;
  BlockGrid blocks;
  CellGrid cells;
  Tally tally;
  for (int trial = 0; trial < 150; ++trial) {
    const BitGrid obstacles(test::random_world(random, 90));
    const DistanceField distances(obstacles);
    const GridFrame& frame = obstacles.frame();
    const double radius = random.uniform(0.0, 3.0) * frame.resolution;
    const TravelCost costs(obstacles, distances, radius, random_settings(random));
    const CellIndex start{random.integer(0, frame.width - 1), random.integer(0, frame.height - 1)};
    const CellIndex goal{random.integer(0, frame.width - 1), random.integer(0, frame.height - 1)};
    cells.begin(costs);
    expect_cheapest(cells, search, {start, 7}, {goal, 11}, tally);
    blocks.begin(costs);
    expect_cheapest(blocks, search, {BlockGrid::block_of(start), 3}, {BlockGrid::block_of(goal), 5},
                    tally);
  }
  EXPECT_GT(tally.found, 100);
  EXPECT_GT(tally.none, 50);
}

TEST(GridSearch, FurtherGoalsGiveThePathsOfNewSearches) {
  test::Random random(22);
  int found = 0;
  int none = 0;
  long further_nodes = 0;
  long new_nodes = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const BitGrid obstacles(test::random_world(random, 200));
    const DistanceField distances(obstacles);
    const double radius = random.uniform(0.0, 3.0) * obstacles.frame().resolution;
    const TravelCost costs(obstacles, distances, radius, random_settings(random));
    BlockGrid grid;
    grid.begin(costs);
    const auto terminals = [&](int count) {
      std::vector<Terminal> nodes;
      const CellIndex first{random.integer(0, grid.width() - 1),
                            random.integer(0, grid.height() - 1)};
      for (int i = 0; i < count; ++i) {
        const CellIndex node{std::min(first.x + i, grid.width() - 1), first.y};
        nodes.push_back({.node = node, .cost = static_cast<std::uint32_t>(random.integer(0, 900))});
      }
      return nodes;
    };
    GridSearch search;
    for (int start = 0; start < 2; ++start) {
      const std::vector<Terminal> starts = terminals(3);
      for (int i = 0; i < 10; ++i) {
        const std::vector<Terminal> goals = terminals(2);
        const bool same = search.find_further(grid, starts, goals);
        BlockGrid fresh_grid;
        fresh_grid.begin(costs);
        GridSearch fresh;
        ASSERT_EQ(fresh.find(fresh_grid, starts, goals), same);
        (same ? found : none) += 1;
        new_nodes += fresh.expanded();
        further_nodes += search.expanded();
        if (!same) continue;
        EXPECT_EQ(fresh.cost(), search.cost());
        ASSERT_EQ(fresh.nodes().size(), search.nodes().size());
        EXPECT_TRUE(std::equal(fresh.nodes().begin(), fresh.nodes().end(), search.nodes().begin()));
      }
    }
  }
  EXPECT_GT(found, 200);
  EXPECT_GT(none, 50);
  EXPECT_LT(2 * further_nodes, new_nodes);
}

TEST(GridSearch, FindsTheBestOfSeveralStartsAndGoals) {
  const BitGrid obstacles({.width = 60, .height = 20, .resolution = 1.0, .origin = {}}, false);
  const DistanceField distances(obstacles);
  PathSettings settings;
  settings.comfort_weight = 0.0;
  const TravelCost costs(obstacles, distances, 0.0, settings);
  CellGrid grid;
  grid.begin(costs);
  const auto steps = [&](int n) {
    return static_cast<std::uint32_t>(n * GridSearch::kStep * grid.unit());
  };
  GridSearch search;
  const std::vector<Terminal> starts{{{5, 10}, steps(20)}, {{8, 10}, 0}};
  const std::vector<Terminal> goals{{{20, 10}, steps(30)}, {{40, 10}, steps(1)}};
  ASSERT_TRUE(search.find(grid, starts, goals));
  EXPECT_EQ(search.nodes().front(), (CellIndex{8, 10}));
  EXPECT_EQ(search.nodes().back(), (CellIndex{40, 10}));
  EXPECT_EQ(search.cost(), steps(33));
}

TEST(GridSearch, GivesNoPathWithoutStartOrGoal) {
  const BitGrid obstacles({.width = 9, .height = 9, .resolution = 1.0, .origin = {}}, false);
  const DistanceField distances(obstacles);
  const TravelCost costs(obstacles, distances, 0.0, {});
  CellGrid grid;
  grid.begin(costs);
  GridSearch search;
  const Terminal terminal{{4, 4}, 0};
  EXPECT_FALSE(search.find(grid, {}, {&terminal, 1}));
  EXPECT_FALSE(search.find(grid, {&terminal, 1}, {}));
  EXPECT_TRUE(search.find(grid, {&terminal, 1}, {&terminal, 1}));
  EXPECT_EQ(search.cost(), 0U);
}

TEST(GridSearch, AGoalInASmallPocketIsDetectedWithoutSearchingTheMap) {
  BitGrid obstacles({.width = 400, .height = 400, .resolution = 0.05, .origin = {}}, false);
  for (int i = 0; i <= 20; ++i) {
    for (const CellIndex cell : {CellIndex{300 + i, 300}, CellIndex{300 + i, 320},
                                 CellIndex{300, 300 + i}, CellIndex{320, 300 + i}})
      obstacles.set(cell, true);
  }
  const DistanceField distances(obstacles);
  const TravelCost costs(obstacles, distances, 0.1, {});
  BlockGrid grid;
  GridSearch search;
  grid.begin(costs);
  const Terminal start{BlockGrid::block_of({40, 40}), 0};
  const Terminal goal{BlockGrid::block_of({310, 310}), 0};
  EXPECT_FALSE(search.find(grid, {&start, 1}, {&goal, 1}));
  EXPECT_LE(search.expanded(), 1000);
}

TEST(BlockGrid, IsConnectedWhereverTheMapIs) {
  test::Random random(22);
  GridSearch search;
  BlockGrid grid;
  int connected = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const BitGrid obstacles(test::random_world(random, 60));
    const DistanceField distances(obstacles);
    const GridFrame& frame = obstacles.frame();
    const double radius = random.uniform(0.0, 3.0) * frame.resolution;
    const TravelCost costs(obstacles, distances, radius, {});
    const CellIndex start{random.integer(0, frame.width - 1), random.integer(0, frame.height - 1)};
    const CellIndex goal{random.integer(0, frame.width - 1), random.integer(0, frame.height - 1)};
    if (!test::is_connected(obstacles, radius, start, goal)) continue;
    ++connected;
    grid.begin(costs);
    const Terminal from{BlockGrid::block_of(start), 0};
    const Terminal to{BlockGrid::block_of(goal), 0};
    EXPECT_TRUE(search.find(grid, {&from, 1}, {&to, 1}));
  }
  EXPECT_GT(connected, 15);
}

}  // namespace
}  // namespace fairway
