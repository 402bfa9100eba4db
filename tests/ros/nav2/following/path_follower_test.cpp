// SPDX-License-Identifier: Apache-2.0
// Nav2's controller without Nav2: a robot in a true world, a local costmap that moves with it, and
// a path from another planner.
#include "nav2_fairway_controller/path_follower.hpp"

#include <gtest/gtest.h>

#include "ros/nav2/following/follower_rig.hpp"

namespace fairway::nav2 {
namespace {

TEST(CostmapConversion, BlocksLethalCellsAndIgnoresInflation) {
  Costmap costmap{.width = 3,
                  .height = 2,
                  .origin_x = 1.0,
                  .origin_y = -2.0,
                  .cells = {0, 254, 253, 128, 255, 0}};
  const BitGrid blocking = to_obstacles(costmap, UnknownCells::Occupied);
  EXPECT_EQ(blocking.frame().origin.position, Eigen::Vector2d(1.0, -2.0));
  EXPECT_FALSE(blocking.blocked({0, 0}));
  EXPECT_TRUE(blocking.blocked({1, 0}));
  EXPECT_FALSE(blocking.blocked({2, 0}));
  EXPECT_FALSE(blocking.blocked({0, 1}));
  EXPECT_TRUE(blocking.blocked({1, 1}));
  EXPECT_FALSE(to_obstacles(costmap, UnknownCells::Free).blocked({1, 1}));
}

TEST(CostmapConversion, FillsPathsDenselyAndEndsWithTheGoalsHeading) {
  PathMessage message;
  fill_path({.waypoints = {{0, 0}, {1, 0}, {1, 0.5}}}, 2.0, 0.1, message);
  ASSERT_EQ(message.poses.size(), 16U);
  EXPECT_EQ(message.poses[3].header, 7);
  EXPECT_NEAR(message.poses[3].pose.position.x, 0.3, 1e-12);
  EXPECT_NEAR(bridge::heading_of(message.poses[3].pose.orientation), 0.0, 1e-12);
  EXPECT_NEAR(bridge::heading_of(message.poses.back().pose.orientation), 2.0, 1e-12);
  const Path back = to_path(message);
  EXPECT_EQ(back.waypoints.front(), Eigen::Vector2d(0, 0));
  EXPECT_TRUE(back.waypoints.back().isApprox(Eigen::Vector2d(1, 0.5)));
  fill_path({}, 2.0, 0.1, message);
  EXPECT_EQ(message.poses.size(), 16U);
}

TEST(PathFollower, FollowsAPathThroughAMovingWindowToItsEnd) {
  Rig rig(Rig::hall());
  rig.follower.set_path(Rig::path(), 0.0);
  rig.drive(40.0);
  const Pose2& pose = rig.world.robots()[0].pose;
  EXPECT_LT((pose.position - Eigen::Vector2d(11, 3)).norm(), 0.15);
  EXPECT_NEAR(pose.heading, 0.0, 0.15);
  EXPECT_FALSE(rig.world.encounters()[0].collided);
}

TEST(PathFollower, AvoidsAnObstacleOnThePath) {
  Rig rig(Rig::hall());
  Path straight{.waypoints = {}};
  for (int i = 20; i <= 220; ++i)
    straight.waypoints.emplace_back(0.05 * i, 2.75);  // through the first post
  rig.follower.set_path(straight, {});
  rig.drive(60.0);
  EXPECT_LT((rig.world.robots()[0].pose.position - Eigen::Vector2d(11, 2.75)).norm(), 0.15);
  EXPECT_FALSE(rig.world.encounters()[0].collided);
}

TEST(PathFollower, RespectsASpeedLimitDuringADrive) {
  Rig rig(Rig::hall());
  rig.follower.set_path(Rig::path(), {});
  rig.drive(2.0);
  rig.follower.set_speed_limit({.value = 0.3});
  rig.drive(1.0);
  for (int i = 0; i < 20; ++i)
    EXPECT_LE(rig.step().command.linear, 0.3 + 1e-9);
  rig.follower.set_speed_limit({});
  rig.drive(1.5);
  EXPECT_GT(rig.world.robots()[0].twist.linear, 0.6);
}

TEST(PathFollower, BrakesWhenTheCostmapIsOldAndThenReportsIt) {
  Rig rig(Rig::hall());
  rig.follower.set_path(Rig::path(), {});
  rig.drive(2.0);
  rig.costmap_alive = false;
  FollowerStep step = rig.step();
  EXPECT_EQ(step.fault, FollowerFault::None) << "it brakes first";
  step = rig.drive(1.0);
  EXPECT_EQ(step.fault, FollowerFault::NoControl);
  EXPECT_EQ(step.status, NavigationStatus::Stale);
  EXPECT_NE(step.reason.find("stale map"), std::string::npos) << step.reason;
  EXPECT_NE(step.reason.find("s old, and safety.map_timeout is"), std::string::npos) << step.reason;
}

TEST(PathFollower, BrakesToStandstillWhenCancelled) {
  Rig rig(Rig::hall());
  rig.follower.set_path(Rig::path(), {});
  rig.drive(2.0);
  rig.follower.cancel();
  EXPECT_GT(rig.step().command.linear, 0.0);
  rig.drive(1.0);
  EXPECT_EQ(rig.world.robots()[0].twist.linear, 0.0);
}

TEST(PathFollower, WaitsForAPersonOnThePathAndContinuesWhenTheyLeave) {
  Rig rig(Rig::hall());
  rig.follower.set_path(Rig::path(), {});
  const MovingObstacle person{.position = {6.0, 3.0}, .velocity = {0.0, 0.0}, .radius = 0.3};
  double least = 1e9;
  for (int i = 0; i < 150; ++i) {
    rig.board.set_detections("topic", {.obstacles = {person}, .time = rig.world.time()});
    rig.step();
    least = std::min(least, (rig.world.robots()[0].pose.position - person.position).norm());
  }
  EXPECT_GT(least, person.radius + Settings{}.robot.radius);
  for (int i = 0; i < 300; ++i) {
    rig.board.set_detections("topic", {.obstacles = {}, .time = rig.world.time()});
    if (rig.step().status == NavigationStatus::GoalReached) break;
  }
  EXPECT_LT((rig.world.robots()[0].pose.position - Eigen::Vector2d(11, 3)).norm(), 0.15);
}

}  // namespace
}  // namespace fairway::nav2
