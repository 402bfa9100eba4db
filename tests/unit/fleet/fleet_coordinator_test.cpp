// SPDX-License-Identifier: Apache-2.0
// Robots that meet in open space: roundabouts. Narrow places are in priority_test.cpp.
#include "fairway/fleet/fleet_coordinator.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "fairway/map/free_space.hpp"
#include "support/random/random_world.hpp"
#include "support/runs/publishing_fleet.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

using FleetCoordinatorTest = test::PublishingFleet;

TEST_F(FleetCoordinatorTest, ARobotAloneFollowsItsOwnPath) {
  add({5, 5}, {15, 5});
  cycle();
  EXPECT_TRUE(members_[0].follows_own_path);
  EXPECT_FALSE(members_[0].coordinator.roundabout().exists());
  EXPECT_FALSE(members_[0].coordinator.waits());
}

TEST_F(FleetCoordinatorTest, TwoRobotsThatMeetHeadOnUseTheSameRoundabout) {
  add({6, 5}, {14, 5});
  add({14, 5}, {6, 5});
  run(0.5);
  const Roundabout& a = members_[0].coordinator.roundabout();
  const Roundabout& b = members_[1].coordinator.roundabout();
  ASSERT_TRUE(a.exists());
  EXPECT_EQ(a.center, b.center);
  EXPECT_EQ(a.radius, b.radius);
  EXPECT_LT((a.center - Vector2d(10, 5)).norm(), 0.5) << "about where they meet";
}

// Both keep the centre on their left, so that they are on different sides of it.
TEST_F(FleetCoordinatorTest, TwoRobotsPassEachOtherOnTheRight) {
  add({6, 5}, {14, 5});
  add({14, 5}, {6, 5});
  run(0.5);
  EXPECT_LT(members_[0].path.at(4.0).y(), 5.0 - kRadius);
  EXPECT_GT(members_[1].path.at(4.0).y(), 5.0 + kRadius);
}

TEST_F(FleetCoordinatorTest, ADetourLeadsFromTheRobotToItsGoal) {
  add({6, 5}, {14, 5});
  add({14, 5}, {6, 5});
  run(0.5);
  const ReferencePath& path = members_[0].path;
  EXPECT_FALSE(members_[0].follows_own_path);
  EXPECT_EQ(path.points[0], Vector2d(6, 5));
  EXPECT_EQ(path.points[static_cast<std::size_t>(path.count - 1)], Vector2d(14, 5));
}

TEST_F(FleetCoordinatorTest, TwoPathsThatCrossAtARightAngleNeedNoRoundabout) {
  add({6, 5}, {14, 5});
  add({10, 1}, {10, 9});
  run(0.5);
  EXPECT_TRUE(members_[0].follows_own_path);
  EXPECT_TRUE(members_[1].follows_own_path);
}

TEST_F(FleetCoordinatorTest, ThreeRobotsThatMeetUseOneRoundaboutWithASideForEach) {
  for (int i = 0; i < 3; ++i) {
    const Vector2d arm = 4.0 * direction(2.0 * std::numbers::pi / 3.0 * i);
    add(Vector2d(10, 5) + arm, Vector2d(10, 5) - arm);
  }
  run(1.0);
  const Roundabout& first = members_[0].coordinator.roundabout();
  ASSERT_TRUE(first.exists());
  // Three bodies on the corners of a triangle touch each other at 2 r = side = sqrt(3) R.
  EXPECT_GT(first.radius, 2.0 * kRadius / std::sqrt(3.0));
  for (const Member& member : members_) {
    EXPECT_LT((member.coordinator.roundabout().center - first.center).norm(), 1e-9);
    EXPECT_NEAR(member.coordinator.roundabout().radius, first.radius, 1e-9);
  }
}

TEST_F(FleetCoordinatorTest, ALargerRoundaboutThatOverlapsIsAdopted) {
  add({6, 5}, {14, 5});
  add({14, 5}, {6, 5});
  run(0.5);
  members_[1].motion.roundabout = {.center = {10.2, 5.1}, .radius = 1.5};
  cycle(0);
  EXPECT_EQ(members_[0].coordinator.roundabout().center, Vector2d(10.2, 5.1));
  EXPECT_EQ(members_[0].coordinator.roundabout().radius, 1.5);
}

TEST_F(FleetCoordinatorTest, ASmallerOrDistantRoundaboutIsIgnored) {
  add({6, 5}, {14, 5});
  add({14, 5}, {6, 5});
  run(0.5);
  const Roundabout own = members_[0].coordinator.roundabout();
  for (const Roundabout& other : {Roundabout{.center = own.center, .radius = 0.5 * own.radius},
                                  Roundabout{.center = {10, 40}, .radius = 3.0}}) {
    members_[1].motion.roundabout = other;
    cycle(0);
    EXPECT_EQ(members_[0].coordinator.roundabout().radius, own.radius);
  }
}

TEST_F(FleetCoordinatorTest, ARobotThatStopsOnARoundaboutEnlargesIt) {
  add({6, 5}, {14, 5});
  add({14, 5}, {6, 5});
  run(0.5);
  const double before = members_[0].coordinator.roundabout().radius;
  members_[0].stopped = true;
  run(0.9);
  EXPECT_EQ(members_[0].coordinator.roundabout().radius, before) << "not for a short stop";
  run(0.5);
  EXPECT_GT(members_[0].coordinator.roundabout().radius, 1.1 * before);
  EXPECT_EQ(members_[1].coordinator.roundabout().radius,
            members_[0].coordinator.roundabout().radius)
      << "the other robot adopts it";
}

TEST_F(FleetCoordinatorTest, ARobotLeavesTheRoundaboutBehindIt) {
  add({6, 5}, {14, 5});
  add({14, 5}, {6, 5});
  run(0.5);
  members_[0].position = {12, 4.8};
  members_[1].position = {8, 5.2};
  publish();
  cycle();
  EXPECT_TRUE(members_[0].follows_own_path);
  EXPECT_FALSE(members_[0].coordinator.roundabout().exists());
}

TEST_F(FleetCoordinatorTest, ANewPathEndsTheRoundabout) {
  add({6, 5}, {14, 5});
  add({14, 5}, {6, 5});
  run(0.5);
  ASSERT_TRUE(members_[0].coordinator.roundabout().exists());
  members_[0].coordinator.path_changed();
  EXPECT_FALSE(members_[0].coordinator.roundabout().exists());
}

TEST_F(FleetCoordinatorTest, NoDetourLeadsIntoAnObstacle) {
  test::Random random(1);
  int detours = 0;
  for (int trial = 0; trial < 300; ++trial) {
    map_ = BitGrid(map_.frame(), false);
    for (int i = 0; i < 25; ++i)
      map_.set({random.integer(0, 199), random.integer(0, 99)}, true);
    members_.clear();
    add({5, random.uniform(3, 7)}, {15, random.uniform(3, 7)});
    add({15, random.uniform(3, 7)}, {5, random.uniform(3, 7)});
    run(0.3);
    for (const Member& member : members_) {
      if (member.follows_own_path || member.coordinator.waits()) continue;
      ++detours;
      for (std::size_t i = 1; i < static_cast<std::size_t>(member.path.count); ++i) {
        EXPECT_TRUE(is_free(map_, member.path.points[i - 1], member.path.points[i], kRadius));
      }
    }
  }
  EXPECT_GT(detours, 50);
}

TEST_F(FleetCoordinatorTest, ResetForgetsEverything) {
  add({6, 5}, {14, 5});
  add({14, 5}, {6, 5});
  run(0.5);
  members_[0].coordinator.reset();
  EXPECT_FALSE(members_[0].coordinator.roundabout().exists());
  EXPECT_FALSE(members_[0].coordinator.waits());
}

}  // namespace
}  // namespace fairway
