// SPDX-License-Identifier: Apache-2.0
// Properties of every path on every map, tested on random worlds.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "support/oracles/path_oracle.hpp"
#include "support/random/random_world.hpp"
#include "support/worlds/path_check.hpp"
#include "support/worlds/path_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;
using World = test::PathWorld;

TEST(PathLaws, FindsAPathWhereverTheCellsConnectAndNoUnsoundOneElsewhere) {
  test::Random random(41);
  PathPlanner planner;
  int found = 0;
  int none = 0;
  for (int trial = 0; trial < 300; ++trial) {
    BitGrid grid(test::random_world(random, 60));
    const int wall = random.integer(0, grid.frame().height - 1);
    const int gap = random.integer(0, grid.frame().width - 1);
    const int gap_width = random.integer(0, 8);
    for (int x = 0; x < grid.frame().width; ++x) {
      if (x < gap || x >= gap + gap_width) grid.set({x, wall}, true);
    }
    const World world(std::move(grid));
    const GridFrame& frame = world.obstacles.frame();
    const double radius = random.uniform(0.0, 3.0) * frame.resolution;
    PathSettings settings;
    settings.margin = random.uniform(0.0, 1.0) * frame.resolution;
    const double required = radius + settings.margin;
    const CellIndex a{random.integer(0, frame.width - 1), random.integer(0, frame.height - 1)};
    const CellIndex b{random.integer(0, frame.width - 1), random.integer(0, frame.height - 1)};
    const Vector2d start = frame.center(a);
    const Vector2d goal = frame.center(b);
    if (!is_free(world.obstacles, start, start, required)) continue;
    if (!is_free(world.obstacles, goal, goal, required)) continue;
    const PathResult result =
        planner.find(world.obstacles, world.distances, start, goal, radius, settings);
    if (test::is_connected(world.obstacles, required, a, b)) {
      ++found;
      test::expect_sound(world.obstacles, result, start, goal, radius, settings.margin);
    } else if (result.status == PathStatus::Found) {
      // Between the cells' centres there may be a path where they do not connect.
      test::expect_sound(world.obstacles, result, start, goal, radius, settings.margin);
    } else {
      ++none;
      EXPECT_EQ(result.status, PathStatus::NoConnection);
      EXPECT_TRUE(result.path.waypoints.empty());
    }
  }
  EXPECT_GT(found, 30);
  EXPECT_GT(none, 10);
}

TEST(PathLaws, EveryPathKeepsItsClearance) {
  test::Random random(42);
  PathPlanner planner;
  int found = 0;
  int tight = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const World world{BitGrid(test::random_world(random, 120))};
    const GridFrame& frame = world.obstacles.frame();
    const double radius = random.uniform(0.0, 3.0) * frame.resolution;
    PathSettings settings;
    settings.margin = random.uniform(0.0, 2.0) * frame.resolution;
    settings.any_angle = random.chance(0.8);
    for (int i = 0; i < 5; ++i) {
      const auto point = [&] {
        return frame.to_world({random.uniform(0, frame.width), random.uniform(0, frame.height)});
      };
      const Vector2d start = point();
      const Vector2d goal = point();
      const PathResult result =
          planner.find(world.obstacles, world.distances, start, goal, radius, settings);
      if (result.status != PathStatus::Found) continue;
      ++found;
      tight += is_free(world.obstacles, start, start, radius + settings.margin) ? 0 : 1;
      test::expect_sound(world.obstacles, result, start, goal, radius, settings.margin);
    }
  }
  EXPECT_GT(found, 150);
  EXPECT_GT(tight, 10);
}

TEST(PathLaws, CostsLittleMoreThanTheCheapestPathOverAllCells) {
  test::Random random(43);
  PathPlanner planner;
  int compared = 0;
  double worst = 1.0;
  double sum = 0.0;
  for (int trial = 0; trial < 100; ++trial) {
    const World world{BitGrid(test::random_world(random, 120))};
    const GridFrame& frame = world.obstacles.frame();
    const double radius = 2.0 * frame.resolution;
    const PathSettings settings{.margin = 0.0, .comfort_distance = 6.0 * frame.resolution};
    const Vector2d start =
        frame.to_world({random.uniform(0, frame.width), random.uniform(0, frame.height)});
    const Vector2d goal =
        frame.to_world({random.uniform(0, frame.width), random.uniform(0, frame.height)});
    const PathResult result =
        planner.find(world.obstacles, world.distances, start, goal, radius, settings);
    if (result.status != PathStatus::Found || (start - goal).norm() < 20 * frame.resolution)
      continue;
    // The true optimum over all cells, from the same ends.
    const TravelCost costs(world.obstacles, world.distances, radius, settings);
    CellGrid grid;
    grid.begin(costs);
    GridSearch search;
    const Terminal from{frame.cell_at(start), 0};
    const Terminal to{frame.cell_at(goal), 0};
    if (!search.find(grid, {&from, 1}, {&to, 1})) continue;
    const double best = search.cost() * frame.resolution / (GridSearch::kStep * grid.unit());
    // The ends differ by less than a cell each.
    const double ends = 2.0 * frame.resolution * static_cast<double>(costs.greatest_cost());
    const double ratio = (result.cost - ends) / best;
    worst = std::max(worst, ratio);
    sum += ratio;
    ++compared;
  }
  EXPECT_GT(compared, 30);
  EXPECT_LT(worst, 1.15);
  EXPECT_LT(sum / compared, 1.01);
}

TEST(PathLaws, StraighteningNeverCostsMoreThanTheSearch) {
  test::Random random(44);
  PathPlanner planner;
  int turns = 0;
  int cells = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const World world{BitGrid(test::random_world(random, 160))};
    const GridFrame& frame = world.obstacles.frame();
    const double radius = 2.0 * frame.resolution;
    PathSettings settings{.margin = 0.0, .comfort_distance = 6.0 * frame.resolution};
    const Vector2d start =
        frame.to_world({random.uniform(0, frame.width), random.uniform(0, frame.height)});
    const Vector2d goal =
        frame.to_world({random.uniform(0, frame.width), random.uniform(0, frame.height)});
    const auto cost = [&](const Path& path) {
      const TravelCost costs(world.obstacles, world.distances, radius, settings);
      double sum = 0.0;
      for (std::size_t i = 1; i < path.waypoints.size(); ++i)
        sum +=
            costs.line(frame.to_grid(path.waypoints[i - 1]), frame.to_grid(path.waypoints[i])).cost;
      return sum;
    };
    const auto find = [&] {
      return planner.find(world.obstacles, world.distances, start, goal, radius, settings);
    };
    const PathResult straight = find();
    if (straight.status != PathStatus::Found) continue;
    settings.any_angle = false;
    const PathResult chain = find();
    ASSERT_EQ(chain.status, PathStatus::Found);
    EXPECT_LE(cost(straight.path), cost(chain.path) + 1e-6);
    turns += static_cast<int>(straight.path.waypoints.size()) - 2;
    cells += static_cast<int>(chain.path.waypoints.size());
  }
  EXPECT_GT(cells, 1000);
  EXPECT_LT(turns * 8, cells) << "the path does not follow the grid";
}

TEST(PathLaws, ShiftingTheWorldShiftsThePath) {
  test::Random random(45);
  PathPlanner planner;
  int found = 0;
  for (int trial = 0; trial < 40; ++trial) {
    BitGrid grid(test::random_world(random, 80));
    GridFrame frame = grid.frame();
    frame.origin = {};
    frame.resolution = 0.0625;  // sums of cells are exact
    // The same obstacles in a frame of blocked cells, shifted by whole blocks of the search.
    const int dx = BlockGrid::kSide * random.integer(0, 4);
    const int dy = BlockGrid::kSide * random.integer(0, 4);
    BitGrid first(frame, false);
    GridFrame larger = frame;
    larger.width += 20;
    larger.height += 20;
    BitGrid second(larger, true);
    for (int y = 0; y < frame.height; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        first.set({x, y}, grid.blocked({x, y}));
        second.set({x + dx, y + dy}, grid.blocked({x, y}));
      }
    }
    const Vector2d shift = Vector2d(dx, dy) * frame.resolution;
    const auto coordinate = [&](int cells) {
      return random.integer(0, 16 * cells) * frame.resolution / 16.0;
    };
    const Vector2d start(coordinate(frame.width - 1), coordinate(frame.height - 1));
    const Vector2d goal(coordinate(frame.width - 1), coordinate(frame.height - 1));
    const PathSettings settings{.margin = 0.02};
    const PathResult a = planner.find(first, DistanceField(first), start, goal, 0.1, settings);
    const PathResult b =
        planner.find(second, DistanceField(second), start + shift, goal + shift, 0.1, settings);
    ASSERT_EQ(a.status, b.status);
    ASSERT_EQ(a.path.waypoints.size(), b.path.waypoints.size());
    found += a.status == PathStatus::Found ? 1 : 0;
    for (std::size_t i = 0; i < a.path.waypoints.size(); ++i)
      EXPECT_LT((a.path.waypoints[i] + shift - b.path.waypoints[i]).norm(), 1e-6);
  }
  EXPECT_GT(found, 10);
}

TEST(PathLaws, EqualInputGivesEqualBitsAfterAnyEarlierPlan) {
  test::Random random(46);
  PathPlanner used;
  for (int trial = 0; trial < 60; ++trial) {
    const World world{BitGrid(test::random_world(random, random.integer(40, 150)))};
    const GridFrame& frame = world.obstacles.frame();
    const Vector2d start =
        frame.to_world({random.uniform(0, frame.width), random.uniform(0, frame.height)});
    const Vector2d goal =
        frame.to_world({random.uniform(0, frame.width), random.uniform(0, frame.height)});
    const double radius = random.uniform(0.0, 2.0) * frame.resolution;
    PathSettings settings;
    settings.comfort_weight = random.uniform(0.0, 5.0);
    const PathResult fresh = world.find(start, goal, radius, settings);
    const PathResult again =
        used.find(world.obstacles, world.distances, start, goal, radius, settings);
    EXPECT_EQ(fresh.status, again.status);
    EXPECT_EQ(fresh.cost, again.cost);
    EXPECT_EQ(fresh.expanded, again.expanded);
    EXPECT_EQ(fresh.path.waypoints, again.path.waypoints);
  }
}

// A planner that keeps what it knows of a map must notice every change of it.
TEST(PathLaws, FurtherPlansAreThoseOfANewPlannerAlsoAfterTheMapChanged) {
  test::Random random(47);
  PathPlanner used;
  int found = 0;
  for (int trial = 0; trial < 25; ++trial) {
    World world{BitGrid(test::random_world(random, 120))};
    const GridFrame frame = world.obstacles.frame();
    const auto point = [&] {
      return frame.to_world({random.uniform(0, frame.width), random.uniform(0, frame.height)});
    };
    Vector2d start = point();
    double radius = frame.resolution;
    for (int plan = 0; plan < 12; ++plan) {
      if (random.chance(0.2)) start = point();
      if (random.chance(0.1)) radius = random.uniform(0.0, 2.0) * frame.resolution;
      if (random.chance(0.3)) {
        const CellIndex cell{random.integer(0, frame.width - 1),
                             random.integer(0, frame.height - 1)};
        world.obstacles.set(cell, !world.obstacles.blocked(cell));
        world.distances.update(world.obstacles, {.first = cell, .last = cell});
      }
      const Vector2d goal = point();
      const PathResult fresh = world.find(start, goal, radius);
      const PathResult again =
          used.find(world.obstacles, world.distances, start, goal, radius, PathSettings{});
      EXPECT_EQ(fresh.status, again.status);
      EXPECT_EQ(fresh.cost, again.cost);
      EXPECT_EQ(fresh.path.waypoints, again.path.waypoints);
      found += fresh.status == PathStatus::Found ? 1 : 0;
    }
  }
  EXPECT_GT(found, 60);
}

}  // namespace
}  // namespace fairway
