// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/facade/opening_search.hpp"

#include <gtest/gtest.h>

namespace fairway {
namespace {

using Eigen::Vector2d;

constexpr double kRadius = 0.31;
const Vector2d kHere(2.0, 2.0);
const Vector2d kBehindTheWall(6.5, 4.0);

// Two rooms of 4 m x 6 m with a wall at x = 4 m, and a door in it from y = 4.5 to 5.5 m.
BitGrid two_rooms() {
  BitGrid map({.width = 160, .height = 120, .resolution = 0.05, .origin = {}}, false);
  for (int y = 0; y < 120; ++y)
    map.set({80, y}, y < 90 || y >= 110);
  for (int x = 0; x < 80; ++x) {
    map.set({x, 5}, true);
    map.set({x, 114}, true);
  }
  for (int y = 0; y < 120; ++y)
    map.set({5, y}, true);
  return map;
}

// A person of radius 0.3 m in the middle of the door leaves gaps that are too narrow.
BitGrid with_a_person() {
  BitGrid map = two_rooms();
  for (int y = 90; y < 110; ++y) {
    for (int x = 70; x < 90; ++x) {
      if ((map.frame().center({.x = x, .y = y}) - Vector2d(4.02, 5.0)).norm() < 0.3)
        map.set({x, y}, true);
    }
  }
  return map;
}

TEST(OpeningSearch, FindsNoneWhereThePathIsFree) {
  OpeningSearch search;
  EXPECT_FALSE(search.find(PreparedMap(two_rooms()), kHere, kBehindTheWall, kRadius, {}));
}

TEST(OpeningSearch, PrefersTheGapBesideAPersonToTheWall) {
  OpeningSearch search;
  const PreparedMap map(with_a_person());
  const std::optional<Opening> found = search.find(map, kHere, kBehindTheWall, kRadius, {});
  ASSERT_TRUE(found);
  EXPECT_LT((found->blocked_at - Vector2d(4.0, 5.0)).norm(), 0.9);
  EXPECT_GT((found->viewpoint - found->blocked_at).norm(), 0.9);
  EXPECT_GE(map.distances.at(map.obstacles.frame().cell_at(found->viewpoint)), kRadius);
}

TEST(OpeningSearch, GoesElsewhereAfterAnOpeningWasTried) {
  OpeningSearch search;
  BitGrid closed = with_a_person();
  for (int y = 0; y < 120; ++y)
    closed.set({80, y}, true);
  const PreparedMap map(std::move(closed));
  TriedOpenings tried;
  const std::optional<Opening> first = search.find(map, kHere, kBehindTheWall, kRadius, tried);
  ASSERT_TRUE(first);
  tried.add(first->blocked_at);
  const std::optional<Opening> second = search.find(map, kHere, kBehindTheWall, kRadius, tried);
  ASSERT_TRUE(second);
  EXPECT_GT((second->blocked_at - first->blocked_at).norm(), 0.5);
}

TEST(OpeningSearch, LooksTowardsAGoalOutsideTheMap) {
  OpeningSearch search;
  const std::optional<Opening> found =
      search.find(PreparedMap(with_a_person()), kHere, {20.0, 4.0}, kRadius, {});
  ASSERT_TRUE(found);
  EXPECT_LT((found->blocked_at - Vector2d(4.0, 5.0)).norm(), 0.9);
}

TEST(OpeningSearch, AcceptsARobotInANarrowPlaceAndOneOutsideTheMap) {
  OpeningSearch search;
  const PreparedMap map(with_a_person());
  EXPECT_TRUE(search.find(map, {3.9, 2.0}, kBehindTheWall, kRadius, {}));
  EXPECT_FALSE(search.find(map, {-3.0, 2.0}, kBehindTheWall, kRadius, {}));
}

}  // namespace
}  // namespace fairway
