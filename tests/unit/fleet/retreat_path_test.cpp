// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/fleet/retreat_search.hpp"
#include "fairway/map/free_space.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

constexpr double kRobotRadius = 0.25;

// 16 m x 6 m: a room up to x = 4 m, then a passage of 0.8 m at y = 3 m that ends at x = 14 m.
BitGrid dead_end() {
  BitGrid grid({.width = 160, .height = 60, .resolution = 0.1, .origin = {}}, false);
  for (int y = 0; y < 60; ++y) {
    for (int x = 40; x < 160; ++x)
      grid.set({x, y}, x >= 140 || y < 26 || y >= 34);
  }
  return grid;
}

SharedMotion robot_at(const Vector2d& position, const Vector2d& goal) {
  SharedMotion motion{.position = position, .radius = kRobotRadius, .under_way = true};
  motion.can_step_aside = false;
  motion.way.count = 1;
  motion.way.points[0] = goal;
  return motion;
}

class RetreatPathTest : public testing::Test {
 protected:
  PassingEnvironment around() {
    return {.obstacles = &grid_, .fleet = fleet_, .passing = passing_, .radius = kRobotRadius};
  }

  BitGrid grid_ = dead_end();
  SharedMotion coming_ = robot_at({12, 3}, {1, 3});
  std::vector<FleetMember> fleet_{{.motion = &coming_}};
  std::vector<const SharedMotion*> passing_{&coming_};
};

TEST_F(RetreatPathTest, LeadsOutOfThePassageToAPassingPlace) {
  const RetreatPath way = find_retreat_path({8, 3}, around());
  ASSERT_TRUE(way.exists());
  EXPECT_TRUE(lets_pass(way.place(), coming_, kRobotRadius));
  EXPECT_TRUE(is_still_valid(way, {8, 3}, around()));
  EXPECT_GT(way.length({8, 3}), 4.0);
  EXPECT_LT(way.length({8, 3}), 6.0);
  Vector2d from(8, 3);
  for (const Vector2d& to : way.points) {
    EXPECT_TRUE(is_free(grid_, from, to, kRobotRadius));
    from = to;
  }
}

TEST_F(RetreatPathTest, DoesNotExistWhereThePassageEndsBehindTheRobot) {
  coming_ = robot_at({6, 3}, {13, 3});
  EXPECT_FALSE(find_retreat_path({12, 3}, around()).exists());
  EXPECT_TRUE(std::isinf(RetreatPath{}.length({12, 3})));
}

TEST_F(RetreatPathTest, DoesNotLeadThroughARobotAtItsGoal) {
  SharedMotion arrived{.position = {6, 3}, .radius = kRobotRadius};
  fleet_.push_back({.motion = &arrived});
  EXPECT_FALSE(find_retreat_path({8, 3}, around()).exists());
}

TEST_F(RetreatPathTest, DoesNotLeadPastTheGoalOfThePassingRobot) {
  // Further in there is a place behind the goal, but it would block the robot indefinitely.
  coming_ = robot_at({6, 3}, {10, 3});
  EXPECT_FALSE(find_retreat_path({9, 3}, around()).exists());
  coming_ = robot_at({12, 3}, {1, 3});
  EXPECT_TRUE(find_retreat_path({9, 3}, around()).exists());
}

TEST_F(RetreatPathTest, LeavesSpaceForFollowers) {
  const RetreatPath alone = find_retreat_path({6, 3}, around());
  SharedMotion between = robot_at({8, 3}, {13, 3});
  fleet_.push_back({.motion = &between});
  const RetreatPath followed = find_retreat_path({6, 3}, around());
  ASSERT_TRUE(alone.exists() && followed.exists());
  EXPECT_TRUE(lets_pass(followed.place(), coming_, kRobotRadius, 2.0 * kRobotRadius));
  EXPECT_GT(followed.length({6, 3}), alone.length({6, 3}) + kRobotRadius);
}

TEST_F(RetreatPathTest, IsShortenedAsItIsDriven) {
  RetreatPath way = find_retreat_path({8, 3}, around());
  const std::size_t before = way.points.size();
  const Vector2d place = way.place();
  shorten(way, way.points[0], grid_, kRobotRadius);
  EXPECT_LT(way.points.size(), before);
  EXPECT_EQ(way.place(), place);
}

TEST_F(RetreatPathTest, NoLongerLeadsAsideWhenItIsBlocked) {
  const RetreatPath way = find_retreat_path({8, 3}, around());
  for (int y = 26; y < 34; ++y)
    grid_.set({60, y}, true);
  EXPECT_FALSE(is_still_valid(way, {8, 3}, around()));
}

// A cycle does a bounded part of a search: in the open, where nothing lets pass, it takes many.
TEST_F(RetreatPathTest, IsSearchedAPartPerCycle) {
  const BitGrid open({.width = 300, .height = 300, .resolution = 0.1, .origin = {}}, false);
  SharedMotion wide = robot_at({16, 15}, {14, 15});
  wide.radius = 20.0;  // no place on the lattice is far enough from it
  const std::vector<FleetMember> fleet{{.motion = &wide}};
  const std::vector<const SharedMotion*> passing{&wide};
  const PassingEnvironment around{
      .obstacles = &open, .fleet = fleet, .passing = passing, .radius = kRobotRadius};
  RetreatSearch search;
  search.begin({15, 15}, around);
  int cycles = 1;
  while (!search.advance(around)) {
    EXPECT_TRUE(search.running());
    ASSERT_LT(++cycles, 10'000);
  }
  EXPECT_FALSE(search.running());
  EXPECT_GT(cycles, 20);
}

TEST_F(RetreatPathTest, IsTheSameWhetherSearchedInPartsOrAtOnce) {
  RetreatSearch search;
  search.begin({8, 3}, around());
  std::optional<RetreatPath> found;
  while (!found)
    found = search.advance(around());
  const RetreatPath at_once = find_retreat_path({8, 3}, around());
  ASSERT_TRUE(found->exists());
  ASSERT_EQ(found->points.size(), at_once.points.size());
  EXPECT_EQ(found->place(), at_once.place());
}

}  // namespace
}  // namespace fairway
