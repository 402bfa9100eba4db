// SPDX-License-Identifier: Apache-2.0
#include "nav2_fairway_controller/following/path_piece.hpp"

#include <gtest/gtest.h>

#include "fairway/map/free_space.hpp"
#include "nav2_fairway_controller/following/stop_reason.hpp"

namespace fairway::nav2 {
namespace {

using Eigen::Vector2d;

// A free map of 6 m x 6 m.
BitGrid free_map() {
  return BitGrid({.width = 120, .height = 120, .resolution = 0.05, .origin = {}}, false);
}

PathProgress started(std::vector<Vector2d> waypoints, const Vector2d& robot) {
  PathProgress path({.waypoints = std::move(waypoints)});
  path.start(robot);
  return path;
}

TEST(PathProgress, StartsAtTheEarliestPositionThatIsNearlyTheNearest) {
  const PathProgress path = started({{0, 0}, {5, 0}, {5, 0.2}, {0, 0.2}}, {2.0, 0.15});
  EXPECT_NEAR(path.arc(), 2.0, 1e-9);
  EXPECT_NEAR(path.deviation(), 0.15, 1e-9);
  EXPECT_NEAR(started({{0, 0}, {5, 0}}, {4.0, 1.0}).arc(), 4.0, 0.8);
}

TEST(PathProgress, AdvancesOnlyInsideItsWindow) {
  PathProgress path = started({{0, 0}, {5, 0}, {5, 0.2}, {0, 0.2}}, {2.0, 0.0});
  path.advance({2.1, 0.2}, 4.0);  // the later lane is nearer
  EXPECT_NEAR(path.arc(), 2.1, 1e-9);
  path.advance({1.0, 0.0}, 4.0);
  EXPECT_NEAR(path.arc(), 1.8, 1e-9) << "one small step back at most";
  path.reached(5.0);
  path.advance({4.5, 0.0}, 8.0);
  EXPECT_GE(path.arc(), 5.0) << "never behind a place that was reached";
}

TEST(PathProgress, IgnoresRepeatedPoints) {
  const PathProgress path = started({{1, 1}, {1, 1}, {1, 1}, {2, 1}, {2, 1}}, {1.5, 1.0});
  EXPECT_NEAR(path.length(), 1.0, 1e-12);
  EXPECT_NEAR(path.arc(), 0.5, 1e-9);
  const PathProgress point = started({{1, 1}}, {0, 0});
  EXPECT_EQ(point.length(), 0.0);
  EXPECT_EQ(point.at(0.5), Vector2d(1, 1));
}

TEST(PathPiece, EndsWhereThePathOrTheMapOrTheNeedEnds) {
  const BitGrid map = free_map();
  const PathPiece whole = choose_piece(started({{1, 1}, {3, 1}}, {1, 1}), {}, map, {});
  EXPECT_EQ(whole.end, PieceEnd::PathEnd);
  EXPECT_EQ(whole.to, 2.0);
  const PathPiece edge = choose_piece(started({{3, 1}, {9, 1}}, {3, 1}), {}, map, {});
  EXPECT_EQ(edge.end, PieceEnd::MapEdge);
  EXPECT_NEAR(edge.to, 3.0 - 0.3, 0.11);
  const PathPiece longest =
      choose_piece(started({{1, 1}, {5, 1}}, {1, 1}), {}, map, {.longest = 2.0});
  EXPECT_EQ(longest.end, PieceEnd::Longest);
  EXPECT_EQ(longest.to, 2.0);
  const PathPiece outside = choose_piece(started({{9, 1}, {12, 1}}, {1, 1}), {}, map, {});
  EXPECT_EQ(outside.end, PieceEnd::OutsideMap);
  EXPECT_EQ(outside.length(), 0.0);
  const PathPiece moved =
      choose_piece(started({{9, 1}, {12, 1}}, {9, 1}), {.position = {-8, 0}}, map, {});
  EXPECT_EQ(moved.end, PieceEnd::PathEnd) << "the frame of the path is elsewhere";
}

TEST(PathPiece, EndsAtTheTipWhereThePathDoublesBack) {
  const BitGrid map = free_map();
  const PathPiece cusp = choose_piece(started({{1, 1}, {3, 1}, {1, 1}}, {1, 1}), {}, map, {});
  EXPECT_EQ(cusp.end, PieceEnd::DoublesBack);
  EXPECT_NEAR(cusp.to, 2.0, 0.11);
  const PathPiece lanes =
      choose_piece(started({{1, 1}, {3, 1}, {3, 1.4}, {1, 1.4}}, {1, 1}), {}, map, {.apart = 0.5});
  EXPECT_EQ(lanes.end, PieceEnd::DoublesBack);
  EXPECT_GT(lanes.to, 1.95) << "the turn is from 2 to 2.4 m";
  EXPECT_LT(lanes.to, 2.45);
  const PathPiece corner =
      choose_piece(started({{1, 1}, {3, 1}, {3, 3}}, {1, 1}), {}, map, {.apart = 1.0});
  EXPECT_EQ(corner.end, PieceEnd::PathEnd) << "a right angle is no return";
}

TEST(PathPiece, EndsBeforeAnObstacleAndSaysHowFarItIs) {
  BitGrid map = free_map();
  for (int y = 0; y < 120; ++y)
    map.set({60, y}, true);  // a wall at x = 3 m
  const PathProgress path = started({{1, 1}, {5, 1}}, {1, 1});
  const PathPiece piece = choose_piece(path, {}, map, {.longest = 2.0});
  EXPECT_EQ(piece.end, PieceEnd::Obstacle);
  EXPECT_NEAR(piece.to, 2.0 - 0.27, 0.11);
  const PathProgress beside = started({{2.9, 1}, {5, 1}}, {2.9, 1});
  const PathPiece none = choose_piece(beside, {}, map, {.longest = 0.2});
  EXPECT_EQ(none.length(), 0.0);
  EXPECT_NE(why_no_piece(beside, none, {}, map, {}).find("needs 0.27 m"), std::string::npos);
}

TEST(PathStrip, AdmitsTheRobotInsideTheBoundOnly) {
  const Path line{.waypoints = {{1, 3}, {1, 3}, {2, 3}, {3, 3}, {4, 3}, {5, 3}}};
  Path dense{.waypoints = {line.waypoints.front()}};
  for (int i = 10; i <= 50; ++i)
    dense.waypoints.emplace_back(0.1 * i, 3.0);
  const double radius = 0.25;
  const BitGrid strip = strip_around(dense, free_map(), radius, 0.3, 0.05);
  for (const double x : {2.0, 3.33, 4.0}) {
    EXPECT_TRUE(is_free(strip, {x, 3.23}, {x, 2.77}, radius)) << x;
    EXPECT_FALSE(is_free(strip, {x, 3.34}, {x, 3.34}, radius)) << x;
    EXPECT_FALSE(is_free(strip, {x, 2.66}, {x, 2.66}, radius)) << x;
  }
}

TEST(PathStrip, IsNeededWhereTheRobotWouldSkipAPartThroughFreeSpace) {
  Path corner{.waypoints = {{1, 1}}};
  for (int i = 0; i <= 20; ++i)
    corner.waypoints.emplace_back(1.0 + 0.1 * i, 1.0);
  for (int i = 1; i <= 20; ++i)
    corner.waypoints.emplace_back(3.0, 1.0 + 0.1 * i);
  BitGrid map = free_map();
  EXPECT_TRUE(has_shortcut(corner, map, 0.25, 0.25));
  for (int x = 20; x < 52; ++x) {
    for (int y = 28; y < 60; ++y)
      map.set({x, y}, true);  // the inside of the corner is an obstacle
  }
  EXPECT_FALSE(has_shortcut(corner, map, 0.25, 0.25));
}

}  // namespace
}  // namespace fairway::nav2
