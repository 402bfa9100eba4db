// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/path_planner.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "support/worlds/path_check.hpp"
#include "support/worlds/path_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;
using World = test::PathWorld;

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

TEST(PathPlanner, FreeSpaceGivesOneStraightLine) {
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

TEST(PathPlanner, KeepsADistanceFromACornerThatTheShortestPathTouches) {
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

TEST(PathPlanner, ReportsEndsOutsideTheMap) {
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

TEST(PathPlanner, ReportsBlockedEnds) {
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

TEST(PathPlanner, ReportsThatThereIsNoPath) {
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
  // A passage so narrow that only the cells of its middle row have enough clearance.
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

TEST(PathPlanner, BetweenRowsOfCellsOnlyTheStraightLineHasClearance) {
  // 8 free rows: the middle lies on an edge between cells, and no centre has enough clearance.
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

}  // namespace
}  // namespace fairway
