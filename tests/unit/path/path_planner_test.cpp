// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/path_planner.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "support/path_check.hpp"
#include "support/path_oracle.hpp"
#include "support/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

struct World {
  explicit World(BitGrid grid) : obstacles(std::move(grid)), distances(obstacles) {}

  [[nodiscard]] PathResult find(const Vector2d& start,
                                const Vector2d& goal,
                                double radius,
                                const PathSettings& settings = {}) const {
    PathPlanner planner;
    return planner.find(obstacles, distances, start, goal, radius, settings);
  }

  BitGrid obstacles;
  DistanceField distances;
};

BitGrid empty_grid(int width, int height, double resolution = 0.05) {
  return BitGrid({.width = width, .height = height, .resolution = resolution, .origin = {}}, false);
}

// 10 m x 10 m with a wall at x = 5 m that has a gap around y = `middle`, `width` wide [cells].
World walled_world(int middle, int width) {
  BitGrid grid = empty_grid(200, 200);
  for (int y = 0; y < 200; ++y) {
    if (y < middle - width / 2 || y >= middle - width / 2 + width) grid.set({100, y}, true);
  }
  return World(std::move(grid));
}

TEST(PathPlanner, FindsAPathExactlyWhereTheCellsConnect) {
  test::Random random(41);
  PathPlanner planner;
  int found = 0;
  int none = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const World world{BitGrid(test::random_world(random, 60))};
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
    } else if (!is_free(world.obstacles, start, goal, required)) {
      ++none;
      EXPECT_EQ(result.status, PathStatus::NoConnection);
      EXPECT_TRUE(result.path.waypoints.empty());
    }
  }
  EXPECT_GT(found, 30);
  EXPECT_GT(none, 10);
}

TEST(PathPlanner, EveryPathKeepsItsClearanceFromAnywhereToAnywhere) {
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

TEST(PathPlanner, CostsHardlyMoreThanTheCheapestWayOverAllCells) {
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
    const double ends = 2.0 * frame.resolution * static_cast<double>(costs.dearest());
    const double ratio = (result.cost - ends) / best;
    worst = std::max(worst, ratio);
    sum += ratio;
    ++compared;
  }
  EXPECT_GT(compared, 30);
  EXPECT_LT(worst, 1.15);
  EXPECT_LT(sum / compared, 1.01);
}

TEST(PathPlanner, StraightensWithoutGivingUpWhatTheSearchPaidFor) {
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
  EXPECT_LT(turns * 8, cells) << "the grid's wiggle is gone";
}

TEST(PathPlanner, AnOpenWayIsOneStraightLine) {
  const World world(empty_grid(200, 200));
  const Vector2d start(1.013, 1.507);
  const Vector2d goal(8.71, 6.23);
  const PathResult result = world.find(start, goal, 0.3);
  ASSERT_EQ(result.status, PathStatus::Found);
  EXPECT_EQ(result.path.waypoints.size(), 2U);
  EXPECT_EQ(result.path.length(), (goal - start).norm());
}

TEST(PathPlanner, StartIsGoal) {
  const World world(empty_grid(40, 40));
  const PathResult result = world.find({1.0, 1.0}, {1.0, 1.0}, 0.2);
  ASSERT_EQ(result.status, PathStatus::Found);
  EXPECT_EQ(result.path.waypoints.size(), 2U);
  EXPECT_EQ(result.path.length(), 0.0);
}

TEST(PathPlanner, KeepsAwayFromACornerThatTheShortestWayTouches) {
  BitGrid grid = empty_grid(200, 200);
  for (int y = 0; y < 100; ++y)
    grid.set({100, y}, true);
  const World world(std::move(grid));
  PathSettings settings;
  const Vector2d start(3.0, 3.5);
  const Vector2d goal(7.0, 3.5);
  const auto nearest = [&](const PathResult& result) {
    double clearance = 0.0;
    for (const double ask : {0.35, 0.45, 0.55}) {
      bool free = true;
      for (std::size_t i = 1; i < result.path.waypoints.size(); ++i) {
        free = free && is_free(world.obstacles, result.path.waypoints[i - 1],
                               result.path.waypoints[i], ask);
      }
      if (free) clearance = ask;
    }
    return clearance;
  };
  const PathResult careful = world.find(start, goal, 0.3, settings);
  settings.comfort_weight = 0.0;
  const PathResult shortest = world.find(start, goal, 0.3, settings);
  EXPECT_LT(nearest(shortest), 0.35);
  EXPECT_GT(nearest(careful), 0.4);
  EXPECT_LT(shortest.path.length(), careful.path.length());
}

TEST(PathPlanner, TellsWhatIsOutsideTheMap) {
  const World world(empty_grid(40, 40));
  const Vector2d inside(1.0, 1.0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Vector2d& bad : {Vector2d(-0.1, 1.0), Vector2d(1.0, 2.1), Vector2d(nan, 1.0),
                              Vector2d(1.0, infinity), Vector2d(1e300, 1.0)}) {
    EXPECT_EQ(world.find(bad, inside, 0.1).status, PathStatus::StartOutsideMap);
    EXPECT_EQ(world.find(inside, bad, 0.1).status, PathStatus::GoalOutsideMap);
  }
  const World nothing{BitGrid()};
  EXPECT_EQ(nothing.find(inside, inside, 0.1).status, PathStatus::StartOutsideMap);
}

TEST(PathPlanner, TellsWhatIsBlocked) {
  BitGrid grid = empty_grid(100, 100);
  grid.set({50, 50}, true);
  const World world(std::move(grid));
  const Vector2d wall(2.6, 2.6);
  const Vector2d open(1.0, 1.0);
  EXPECT_EQ(world.find(wall, open, 0.2).status, PathStatus::StartBlocked);
  EXPECT_EQ(world.find(open, wall, 0.2).status, PathStatus::GoalBlocked);
  EXPECT_EQ(world.find(open, {4.95, 4.0}, 0.2).status, PathStatus::GoalBlocked)
      << "the outside is an obstacle";
}

TEST(PathPlanner, TellsThatThereIsNoWay) {
  const World closed = walled_world(100, 0);
  EXPECT_EQ(closed.find({2, 2}, {8, 2}, 0.3).status, PathStatus::NoConnection);
  const World gap = walled_world(100, 12);  // 0.6 m
  EXPECT_EQ(gap.find({2, 2}, {8, 2}, 0.25).status, PathStatus::Found);
  EXPECT_EQ(gap.find({2, 2}, {8, 2}, 0.3).status, PathStatus::NoConnection);
}

TEST(PathPlanner, ASmallerMarginOpensAGap) {
  const World gap = walled_world(100, 13);  // 0.65 m, centred on a row of cells
  PathSettings settings;
  settings.margin = 0.04;
  EXPECT_EQ(gap.find({2, 2}, {8, 2}, 0.3, settings).status, PathStatus::NoConnection);
  settings.margin = 0.012;
  const PathResult result = gap.find({2, 2}, {8, 2}, 0.3, settings);
  test::expect_sound(gap.obstacles, result, {2, 2}, {8, 2}, 0.3, 0.012);
}

TEST(PathPlanner, LeadsOutOfTheMarginFirstAndIntoItLast) {
  BitGrid grid = empty_grid(200, 200);
  for (int x = 40; x < 160; ++x)
    grid.set({x, 100}, true);
  const World world(std::move(grid));
  PathSettings settings;
  for (const double margin : {0.02, 0.1, 0.3}) {
    settings.margin = margin;
    const Vector2d start(5.012, 5.05 + 0.3005);  // half a millimetre from contact
    const Vector2d goal(5.012, 5.0 - 0.3005);
    const PathResult result = world.find(start, goal, 0.3, settings);
    test::expect_sound(world.obstacles, result, start, goal, 0.3, margin);
    EXPECT_GE(result.path.waypoints.size(), 4U);
  }
}

TEST(PathPlanner, LeadsOutOfACornerOfARoom) {
  BitGrid grid = empty_grid(120, 120);
  for (int i = 0; i < 120; ++i) {
    grid.set({i, 3}, true);
    grid.set({3, i}, true);
  }
  const World world(std::move(grid));
  PathSettings settings;
  settings.margin = 0.25;
  const Vector2d start(0.2 + 0.301, 0.2 + 0.301);
  const PathResult result = world.find(start, {4, 4}, 0.3, settings);
  test::expect_sound(world.obstacles, result, start, {4, 4}, 0.3, settings.margin);
}

TEST(PathPlanner, JoinsPointsAnywhereInTheirCells) {
  // A corridor so narrow that only the cells of its middle row have room.
  BitGrid grid = empty_grid(100, 60);
  for (int x = 0; x < 100; ++x) {
    grid.set({x, 20}, true);
    grid.set({x, 30}, true);
  }
  const World world(std::move(grid));
  const double half_width = 0.225;  // 9 free rows
  PathSettings settings;
  settings.margin = 0.0;
  for (const double offset : {-0.0049, 0.0, 0.0049}) {
    const Vector2d start(0.512, 1.275 + offset);
    const Vector2d goal(4.447, 1.275 - offset);
    const PathResult result = world.find(start, goal, half_width - 0.005, settings);
    test::expect_sound(world.obstacles, result, start, goal, half_width - 0.005, 0.0);
  }
}

TEST(PathPlanner, BetweenRowsOfCellsOnlyTheStraightLineHasRoom) {
  // 8 free rows: the middle lies on an edge between cells, no centre has room.
  BitGrid grid = empty_grid(100, 60);
  for (int x = 0; x < 100; ++x) {
    grid.set({x, 20}, true);
    grid.set({x, 29}, true);
  }
  const World world(std::move(grid));
  PathSettings settings;
  settings.margin = 0.0;
  const PathResult result = world.find({0.5, 1.25}, {4.4, 1.25}, 0.19, settings);
  test::expect_sound(world.obstacles, result, {0.5, 1.25}, {4.4, 1.25}, 0.19, 0.0);
}

TEST(PathPlanner, ShiftingTheWorldShiftsThePath) {
  test::Random random(45);
  PathPlanner planner;
  int found = 0;
  for (int trial = 0; trial < 40; ++trial) {
    BitGrid grid(test::random_world(random, 80));
    GridFrame frame = grid.frame();
    frame.origin = {};
    frame.resolution = 0.0625;  // sums of cells are exact
    // The same obstacles in a frame of blocked cells, moved by whole cells, odd numbers too.
    const int dx = random.integer(1, 9);
    const int dy = random.integer(1, 9);
    BitGrid first(frame, false);
    GridFrame larger = frame;
    larger.width += 20;
    larger.height += 20;
    BitGrid second(larger, true);
    for (int y = 0; y < frame.height; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        first.set({x, y}, grid.blocked({x, y}));
        second.set({x + dx - dx % 2, y + dy - dy % 2}, grid.blocked({x, y}));
      }
    }
    const Vector2d shift = Vector2d(dx - dx % 2, dy - dy % 2) * frame.resolution;
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

TEST(PathPlanner, EqualInputGivesEqualBitsWhateverWasPlannedBefore) {
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

}  // namespace
}  // namespace fairway
