// SPDX-License-Identifier: Apache-2.0
// Robots that meet where they cannot pass each other: who gives way.
#include <gtest/gtest.h>

#include "fairway/fleet/fleet_coordinator.hpp"
#include "fairway/map/free_space.hpp"
#include "support/random/random_world.hpp"
#include "support/runs/publishing_fleet.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

using Priority = test::PublishingFleet;

// Decisions of two robots that meet in the passage, wherever they are.
TEST_F(Priority, ExactlyOneOfTwoRobotsGivesWayInAPassage) {
  build_passage();
  test::Random random(2);
  int decided = 0;
  for (int trial = 0; trial < 60; ++trial) {
    members_.clear();
    first_number_ = static_cast<std::uint32_t>(random.integer(0, 5));
    add({random.uniform(1, 9), 5}, {19, 5});
    add({random.uniform(11, 19), 5}, {1, 5});
    if (members_[1].position.x() - members_[0].position.x() > 8.0) continue;  // out of sight
    run(2.0);
    EXPECT_LE(count_waiting(), 1) << members_[0].position.x() << ' ' << members_[1].position.x();
    decided += count_waiting();
  }
  EXPECT_GT(decided, 10);
}

TEST_F(Priority, TheRobotThatCanStepAsideGivesWayToTheOneInThePassage) {
  build_passage();
  add({3.2, 5}, {19, 5});   // in the room, before the passage
  add({7.0, 5}, {1.0, 5});  // inside
  run(1.0);
  EXPECT_TRUE(members_[0].coordinator.waits());
  EXPECT_TRUE(members_[0].coordinator.can_step_aside());
  EXPECT_FALSE(members_[1].coordinator.can_step_aside());
  EXPECT_TRUE(members_[1].follows_own_path);
}

TEST_F(Priority, AWaitingRobotLeavesThePathOfTheOtherOne) {
  build_passage();
  add({3.2, 5}, {19, 5});
  add({7.0, 5}, {1.0, 5});
  run(1.0);
  const ReferencePath& path = members_[0].path;
  const Vector2d place = path.points[static_cast<std::size_t>(path.count - 1)];
  EXPECT_TRUE(lets_pass(place, members_[1].motion, kRadius));
  EXPECT_TRUE(is_free(map_, place, place, kRadius));
}

TEST_F(Priority, OfTwoRobotsInsideTheOneWithTheShorterRetreatGoesBack) {
  build_passage();
  add({6.0, 5}, {19, 5});  // 2 m from its end of the passage
  add({11.0, 5}, {1, 5});  // 5 m from the other end
  run(2.0);
  EXPECT_TRUE(members_[0].coordinator.waits());
  EXPECT_FALSE(members_[1].coordinator.waits());
  EXPECT_LT(members_[0].coordinator.retreat_length(), members_[1].coordinator.retreat_length());
  EXPECT_NEAR(members_[0].coordinator.retreat_length(), 3.0, 1.0);
}

TEST_F(Priority, AtEqualDistanceTheGreaterNumberGivesWay) {
  for (int y = 0; y < 100; ++y)
    map_.set({100, y}, y < 46 || y >= 55);  // a door at x = 10.05
  add({8.05, 5}, {19, 5});
  add({12.05, 5}, {1, 5});
  run(1.0);
  EXPECT_FALSE(members_[0].coordinator.waits());
  EXPECT_TRUE(members_[1].coordinator.waits());
}

TEST_F(Priority, TheRobotNearerToADoorGoesFirst) {
  for (int y = 0; y < 100; ++y)
    map_.set({100, y}, y < 46 || y >= 55);
  add({7.05, 5}, {19, 5});
  add({12.05, 5}, {1, 5});
  run(1.0);
  EXPECT_TRUE(members_[0].coordinator.waits());
  EXPECT_FALSE(members_[1].coordinator.waits());
}

TEST_F(Priority, ARobotStopsWaitingWhenTheOtherOneHasPassed) {
  build_passage();
  add({3.2, 5}, {19, 5});
  add({7.0, 5}, {1.0, 5});
  run(1.0);
  ASSERT_TRUE(members_[0].coordinator.waits());
  members_[1].position = {1.2, 5};
  publish();
  cycle();
  EXPECT_FALSE(members_[0].coordinator.waits());
}

TEST_F(Priority, ARobotThatWaitedLongForOneThatDoesNotMoveTriesToContinue) {
  build_passage();
  add({3.2, 5}, {19, 5});
  add({7.0, 5}, {1.0, 5});
  run(19.0);
  EXPECT_TRUE(members_[0].coordinator.waits());
  run(2.5);
  EXPECT_FALSE(members_[0].coordinator.waits());
  run(5.0);
  EXPECT_TRUE(members_[0].coordinator.waits()) << "it tries for a few seconds only";
}

TEST_F(Priority, ARobotThatApproachesIsWaitedForHoweverLongItTakes) {
  build_passage();
  add({3.2, 5}, {19, 5});
  add({7.0, 5}, {1.0, 5});
  run(1.0);
  for (int k = 0; k < 300; ++k) {
    members_[1].motion.speed = 0.5;
    cycle();
    ASSERT_TRUE(members_[0].coordinator.waits()) << k;
  }
}

TEST_F(Priority, ARobotAtItsGoalHasNoPriority) {
  build_passage();
  add({3.2, 5}, {19, 5});
  add({7.0, 5}, {1.0, 5});
  run(1.0);
  ASSERT_TRUE(members_[0].coordinator.waits());
  members_[1].motion.under_way = false;
  cycle(0);
  EXPECT_FALSE(members_[0].coordinator.waits());
}

}  // namespace
}  // namespace fairway
