// SPDX-License-Identifier: Apache-2.0
// The frame of the path moves relative to the costmap while the robot drives: map -> odom is
// corrected by the localisation.
#include <gtest/gtest.h>

#include "ros/nav2/following/follower_rig.hpp"

namespace fairway::nav2 {
namespace {

using Eigen::Vector2d;

class FrameJump : public testing::TestWithParam<Pose2> {};

TEST_P(FrameJump, IsFollowedToTheGoalInThePathsFrame) {
  Rig rig(Rig::free_hall({.position = {1, 3}, .heading = 0}));
  const Path path = Rig::dense({{1, 3}, {5, 3}, {10, 2.5}});
  rig.follower.set_path(path, 0.0);
  rig.drive(3.0);
  rig.frame = GetParam();
  const FollowerStep last = rig.drive(40.0);
  EXPECT_EQ(last.status, NavigationStatus::GoalReached) << last.reason;
  const Vector2d goal = transform(GetParam(), path.waypoints.back());
  EXPECT_LT((rig.robot().pose.position - goal).norm(), 0.12);
  EXPECT_EQ(rig.faults, 0);
}

INSTANTIATE_TEST_SUITE_P(Jumps,
                         FrameJump,
                         testing::Values(Pose2{.position = {0.0, 0.1}},
                                         Pose2{.position = {0.0, 0.4}},
                                         Pose2{.position = {-0.3, -0.3}},
                                         Pose2{.position = {0.0, 1.0}},
                                         Pose2{.position = {-1.0, 0.0}},
                                         Pose2{.position = {1.0, 0.0}},
                                         Pose2{.position = {0.3, 0.0}, .heading = 0.1}));

// With a costmap in the frame of the map, the pose jumps and the path does not.
TEST(PoseJump, BrakesWithinTheLimitsAndArrives) {
  for (const double jump : {0.1, 0.4, 1.0}) {
    SCOPED_TRACE(jump);
    Rig rig(Rig::free_hall({.position = {1, 3}, .heading = 0}));
    rig.follower.set_path(Rig::dense({{1, 3}, {10, 3}}), {});
    rig.drive(3.0);
    rig.offset = Vector2d(0.0, jump);
    const FollowerStep last = rig.drive(40.0);
    EXPECT_EQ(last.status, NavigationStatus::GoalReached) << last.reason;
    EXPECT_LT((rig.robot().pose.position + rig.offset - Vector2d(10, 3)).norm(), 0.12);
    EXPECT_LE(rig.greatest_change, 0.2 + 1e-9);
  }
}

TEST(FrameDrift, IsFollowedWithoutStops) {
  Rig rig(Rig::free_hall({.position = {1, 3}, .heading = 0}));
  const Path path = Rig::dense({{1, 3}, {10, 3}});
  rig.follower.set_path(path, {});
  rig.drive(2.0);
  FollowerStep last;
  double slowest = 1.0;
  for (int i = 0; i < 600 && last.status != NavigationStatus::GoalReached; ++i) {
    rig.frame = Pose2{.position = {0.0, std::min(0.6, 0.01 * i)}};
    last = rig.step();
    if (last.remaining > 1.0) slowest = std::min(slowest, last.command.linear);
  }
  EXPECT_LT((rig.robot().pose.position - Vector2d(10, 3.6)).norm(), 0.12);
  EXPECT_GT(slowest, 0.5);
}

TEST(FrameJumps, WithoutATransformTheRobotContinuesForASecondThenBrakesAndReports) {
  Rig rig(Rig::free_hall({.position = {1, 3}, .heading = 0}));
  rig.follower.set_path(Rig::dense({{1, 3}, {10, 3}}), {});
  rig.drive(3.0);
  rig.frame = {};
  FollowerStep last = rig.drive(0.8);
  EXPECT_GT(last.command.linear, 0.5);
  last = rig.drive(1.5);
  EXPECT_EQ(last.fault, FollowerFault::NoFrame);
  EXPECT_LE(rig.greatest_change, 0.2 + 1e-9) << "it brakes within the acceleration limit";
  rig.frame = Pose2{};
  EXPECT_EQ(rig.drive(30.0).status, NavigationStatus::GoalReached);
}

}  // namespace
}  // namespace fairway::nav2
