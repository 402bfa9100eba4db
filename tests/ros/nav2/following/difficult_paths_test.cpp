// SPDX-License-Identifier: Apache-2.0
// Paths with obstacles, sparse poses, distant beginnings and invalid poses: the robot arrives, or
// reports an error with a reason.
#include <limits>

#include <gtest/gtest.h>

#include "ros/nav2/following/follower_rig.hpp"

namespace fairway::nav2 {
namespace {

using Eigen::Vector2d;

const Pose2 kStart{.position = {1, 3}, .heading = 0};

TEST(DifficultPath, IsDrivenPastABoxAtEveryEndOfThePiece) {
  // The window ends 3 m ahead, so the end of the piece passes over the whole box.
  for (const double x : {3.5, 5.0, 7.0}) {
    SCOPED_TRACE(x);
    Scenario scenario = Rig::free_hall(kStart);
    Rig::block(scenario, {x, 0.0}, {x + 1.0, 3.2});
    Rig::block(scenario, {x, 4.15}, {x + 1.0, 6.0});  // 0.95 m free beside the box
    Rig rig(scenario);
    rig.follower.set_path(Rig::dense({{1, 3}, {11, 3}}), {});
    const FollowerStep last = rig.drive(60.0);
    EXPECT_EQ(last.status, NavigationStatus::GoalReached) << last.reason;
    EXPECT_FALSE(rig.world.encounters()[0].collided);
  }
}

TEST(DifficultPath, MayHaveSparsePoses) {
  Rig rig(Rig::free_hall(kStart));
  rig.follower.set_path({.waypoints = {{1, 3}, {11, 4}}},
                        {});  // 10 m apart, the window ends at 3 m
  EXPECT_EQ(rig.drive(40.0).status, NavigationStatus::GoalReached);
  Rig other(Rig::free_hall(kStart));
  other.follower.set_path({.waypoints = {{3, 4}}}, {});
  EXPECT_EQ(other.drive(20.0).status, NavigationStatus::GoalReached);
  EXPECT_LT((other.robot().pose.position - Vector2d(3, 4)).norm(), 0.15);
}

TEST(DifficultPath, BeginningBehindTheRobotIsJoinedBesideIt) {
  Rig rig(Rig::free_hall({.position = {5, 3.3}, .heading = 0}));
  rig.follower.set_path(Rig::dense({{1, 3}, {11, 3}}), {});
  const FollowerStep first = rig.step();
  EXPECT_NEAR(first.driven, 4.0, 0.35);
  EXPECT_EQ(rig.drive(30.0).status, NavigationStatus::GoalReached);
  for (const Vector2d& position : rig.track)
    EXPECT_GT(position.x(), 4.9);
}

TEST(DifficultPath, BeginningFarAwayIsReportedWithItsDistance) {
  Rig rig(Rig::free_hall(kStart));
  rig.follower.set_path(Rig::dense({{8.5, 3}, {11, 3}}), {});
  const FollowerStep step = rig.step();
  EXPECT_EQ(step.fault, FollowerFault::BadPath);
  EXPECT_NE(step.reason.find("7.50 m from the robot"), std::string::npos) << step.reason;
}

TEST(DifficultPath, WithInvalidPosesIsRefusedByName) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(path_fault({.waypoints = {{0, 0}, {1, 0}}}), "");
  EXPECT_NE(path_fault({.waypoints = {{0, 0}, {nan, 0}, {1, 0}}}).find("pose 1 of 3"),
            std::string::npos);
  EXPECT_NE(path_fault({}).find("empty"), std::string::npos);
}

TEST(DifficultPath, BlockedEverywhereIsDrivenUpToTheObstacleAndThenReported) {
  Scenario scenario = Rig::free_hall(kStart);
  Rig::block(scenario, {6, 0}, {6.5, 6});
  Rig rig(scenario);
  rig.follower.set_path(Rig::dense({{1, 3}, {11, 3}}), {});
  FollowerStep last;
  for (int i = 0; i < 300 && last.fault == FollowerFault::None; ++i)
    last = rig.step();
  EXPECT_EQ(last.fault, FollowerFault::NoControl);
  EXPECT_EQ(last.command.linear, 0.0);
  EXPECT_GT(rig.robot().pose.position.x(), 5.4);
  EXPECT_NE(last.reason.find(" m"), std::string::npos) << last.reason;
}

TEST(DifficultPath, WithABoundIsLeftByNoMoreAndBlockedByAnObstacleOnIt) {
  FollowerSettings settings;
  settings.following.max_deviation = 0.3;
  Scenario scenario = Rig::free_hall(kStart);
  Rig::block(scenario, {4, 3.15}, {4.5, 3.6});  // 0.15 m from the path: passed within the bound
  Rig::block(scenario, {8, 2.6}, {8.5, 3.4});   // on the path
  Rig rig(scenario, settings);
  rig.follower.set_path(Rig::dense({{1, 3}, {11, 3}}), {});
  FollowerStep last;
  double greatest = 0.0;
  for (int i = 0; i < 400 && last.fault == FollowerFault::None; ++i) {
    last = rig.step();
    greatest = std::max(greatest, last.deviation);
  }
  EXPECT_EQ(last.fault, FollowerFault::NoControl);
  EXPECT_LT(greatest, 0.3);
  EXPECT_GT(greatest, 0.1) << "it passed the first box";
  EXPECT_GT(rig.robot().pose.position.x(), 7.3);
  EXPECT_LT(rig.robot().pose.position.x(), 7.76);
}

TEST(DifficultPath, ReportsAnErrorWhenTheGoalCheckerNeverAccepts) {
  Rig rig(Rig::free_hall(kStart));
  rig.follower.set_path(Rig::dense({{1, 3}, {2, 3}}), {});
  EXPECT_EQ(rig.drive(20.0).status, NavigationStatus::GoalReached);
  FollowerStep last;
  for (int i = 0; i < 60 && last.fault == FollowerFault::None; ++i)
    last = rig.step();
  EXPECT_EQ(last.fault, FollowerFault::NoControl);
  EXPECT_NE(last.reason.find("goal checker"), std::string::npos);
}

}  // namespace
}  // namespace fairway::nav2
