// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/path_beginning.hpp"

#include <gtest/gtest.h>

namespace fairway {
namespace {

TEST(BeginningOf, EndsOnThePathAfterItsLength) {
  const Path path{.waypoints = {{0, 0}, {3, 0}, {3, 4}}};
  const Path part = beginning_of(path, 5.0);
  ASSERT_EQ(part.waypoints.size(), 3U);
  EXPECT_EQ(part.waypoints[1], path.waypoints[1]);
  EXPECT_TRUE(part.waypoints[2].isApprox(Eigen::Vector2d(3, 2)));
  EXPECT_NEAR(part.length(), 5.0, 1e-12);
}

TEST(BeginningOf, IsTheWholeOfAShorterPath) {
  const Path path{.waypoints = {{0, 0}, {3, 0}, {3, 4}}};
  EXPECT_EQ(beginning_of(path, 7.0).waypoints, path.waypoints);
  EXPECT_EQ(beginning_of(path, 1e9).waypoints, path.waypoints);
  EXPECT_TRUE(beginning_of(Path(), 1.0).waypoints.empty());
}

TEST(BeginningOf, OfLengthZeroIsTheStart) {
  const Path path{.waypoints = {{1, 2}, {1, 2}, {3, 4}}};
  EXPECT_EQ(beginning_of(path, 0.0).length(), 0.0);
  EXPECT_EQ(beginning_of(path, 0.0).waypoints.front(), path.waypoints.front());
}

}  // namespace
}  // namespace fairway
