// SPDX-License-Identifier: Apache-2.0
#include "fairway/fleet/passing_place.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace fairway {
namespace {

using Eigen::Vector2d;

constexpr double kRadius = 0.25;

// 10 m x 4 m with a wall at x = 5 m and a door of 0.9 m in it.
BitGrid two_rooms() {
  BitGrid grid({.width = 100, .height = 40, .resolution = 0.1, .origin = {}}, false);
  for (int y = 0; y < 40; ++y)
    grid.set({50, y}, y < 16 || y >= 25);
  return grid;
}

ReferencePath straight_path(const Vector2d& from, const Vector2d& to) {
  ReferencePath path;
  path.count = 2;
  path.points = {from, to};
  path.arc = {0.0, (to - from).norm()};
  return path;
}

SharedMotion coming(const Vector2d& from, const Vector2d& to) {
  SharedMotion motion{.position = from, .radius = kRadius, .under_way = true};
  motion.way.count = 1;
  motion.way.points[0] = to;
  return motion;
}

TEST(PassingPlace, ADoorIsNarrowAndARoomIsNot) {
  const BitGrid grid = two_rooms();
  const NarrowPlaces narrow(straight_path({2, 2}, {8, 2}), kRadius, grid);
  ASSERT_FALSE(narrow.places.empty());
  for (const NarrowPlaces::Place& place : narrow.places)
    EXPECT_NEAR(place.position.x(), 5.05, 0.5);
  EXPECT_EQ(NarrowPlaces(straight_path({1, 2}, {4, 2}), kRadius, grid).places.size(), 0U);
}

TEST(PassingPlace, OnlyOncomingRobotsAreMet) {
  const BitGrid grid = two_rooms();
  const NarrowPlaces narrow(straight_path({2, 2}, {8, 2}), kRadius, grid);
  EXPECT_NEAR(narrow.length_to_meeting(coming({8, 2}, {1, 2}), kRadius), 3.0, 0.6);
  EXPECT_TRUE(std::isinf(narrow.length_to_meeting(coming({3, 2}, {9, 2}), kRadius)));
  EXPECT_TRUE(std::isinf(narrow.length_to_meeting(coming({8, 1}, {6, 1}), kRadius)));
}

TEST(PassingPlace, OnlyRobotsThatEnterTheSamePathTogetherMerge) {
  const BitGrid grid = two_rooms();
  const NarrowPlaces narrow(straight_path({3.5, 2.5}, {8, 2}), kRadius, grid);
  EXPECT_TRUE(std::isfinite(narrow.length_to_merging(coming({3.5, 1.5}, {8, 2.6}), kRadius)));
  EXPECT_TRUE(std::isinf(narrow.length_to_merging(coming({2, 1.5}, {8, 2.3}), kRadius))) << "later";
  EXPECT_TRUE(std::isinf(narrow.length_to_merging(coming({5, 2}, {8, 2}), kRadius))) << "inside";
  EXPECT_TRUE(std::isinf(narrow.length_to_merging(coming({6.5, 2}, {1, 2}), kRadius))) << "meets";
}

TEST(PassingPlace, AGoalInANarrowPassageBlocksIt) {
  const BitGrid grid = two_rooms();
  const NarrowPlaces narrow(straight_path({2, 2}, {8, 2}), kRadius, grid);
  EXPECT_TRUE(narrow.contain_goal_of(coming({8, 2}, {5, 2}), kRadius));
  EXPECT_FALSE(narrow.contain_goal_of(coming({8, 2}, {1, 2}), kRadius));
  EXPECT_FALSE(narrow.contain_goal_of(SharedMotion{}, kRadius)) << "no goal";
}

TEST(PassingPlace, IsTheNearestThatLetsTheOthersPass) {
  const BitGrid grid = two_rooms();
  const SharedMotion other = coming({7, 2}, {1, 2});
  const FleetMember member{.motion = &other};
  const SharedMotion* const passing[] = {&other};
  const PassingEnvironment around{
      .obstacles = &grid, .fleet = {&member, 1}, .passing = passing, .radius = kRadius};
  const auto place = passing_place({3, 2}, around);
  ASSERT_TRUE(place);
  EXPECT_TRUE(lets_pass(*place, other, kRadius));
  EXPECT_LT((*place - Vector2d(3, 2)).norm(), 1.3);
  EXPECT_EQ(passing_place({3, 3.5}, around), std::optional(Vector2d(3, 3.5))) << "outside its path";
}

}  // namespace
}  // namespace fairway
