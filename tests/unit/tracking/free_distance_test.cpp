// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/free_distance.hpp"

#include <gtest/gtest.h>

namespace fairway {
namespace {

ReferencePath along_x(double length) {
  ReferencePath path;
  path.count = 3;
  path.points[0] = {0, 0};
  path.points[1] = {0.37, 0};
  path.points[2] = {length, 0};
  path.arc[0] = 0.0;
  path.arc[1] = 0.37;
  path.arc[2] = length;
  return path;
}

BitGrid floor_with_wall_at(double x) {
  BitGrid map(GridFrame{.width = 200, .height = 80, .resolution = 0.05, .origin = {{-2, -2}, 0}},
              false);
  const int column = map.frame().cell_at({x + 1e-9, 0}).x;
  for (int y = 0; y < 80; ++y)
    map.set({column, y}, true);
  return map;
}

TEST(FreeLength, EndsBeforeAnObstacle) {
  for (const double wall : {1.0, 2.35, 3.0}) {
    const double length = free_length(floor_with_wall_at(wall), along_x(5.0), 0.3, 10.0);
    EXPECT_LE(length, wall - 0.3);
    EXPECT_GE(length, wall - 0.3 - 0.11);
  }
}

TEST(FreeLength, IsTheWholePathOrTheLimitWithoutObstacles) {
  const BitGrid map = floor_with_wall_at(7.0);
  EXPECT_EQ(free_length(map, along_x(5.0), 0.3, 10.0), 5.0);
  EXPECT_EQ(free_length(map, along_x(5.0), 0.3, 2.0), 2.0);
}

TEST(FreeLength, ARobotTooCloseToAnObstacleMayLeave) {
  BitGrid map = floor_with_wall_at(7.0);
  map.set(map.frame().cell_at({-0.28, 0.01}), true);  // behind it, inside its disc
  EXPECT_GT(free_length(map, along_x(5.0), 0.3, 10.0), 4.0);
}

}  // namespace
}  // namespace fairway
