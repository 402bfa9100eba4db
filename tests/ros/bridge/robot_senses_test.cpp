// SPDX-License-Identifier: Apache-2.0
#include "bridge/sensing/robot_senses.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "bridge/pilot.hpp"

namespace fairway::bridge {
namespace {

constexpr double kQuarter = std::numbers::pi / 2.0;

TEST(RobotSenses, KnowTheirPoseOnceOdometryAndLocalisationAreKnown) {
  RobotSenses senses({});
  EXPECT_FALSE(senses.pose());
  senses.add_odometry(1.0, {{2.0, 0.0}, 0.0}, {});
  EXPECT_FALSE(senses.pose()) << "the odometry's frame has no place in the map yet";
  senses.set_localisation({{5.0, 1.0}, kQuarter}, 1.0);
  ASSERT_TRUE(senses.pose());
  EXPECT_NEAR(senses.pose()->position.x(), 5.0, 1e-12);
  EXPECT_NEAR(senses.pose()->position.y(), 3.0, 1e-12);
  EXPECT_NEAR(senses.pose()->heading, kQuarter, 1e-12);
}

TEST(RobotSenses, PoseIsStaleWithoutAFreshLocalisation) {
  RobotSenses senses({.localisation_timeout = 2.0});
  senses.add_odometry(1.0, {}, {});
  senses.set_localisation({}, 1.0);
  EXPECT_EQ(senses.measure(1.5).pose_time, 1.0);
  senses.add_odometry(3.5, {}, {});
  EXPECT_LT(*senses.measure(3.5).pose_time, 0.0);
  EXPECT_TRUE(senses.is_lost(3.5));
}

TEST(RobotSenses, MapIsStaleUntilAScanWasUsed) {
  RobotSenses senses({.use_scan = true});
  ASSERT_TRUE(senses.measure(1.0).map_time);
  EXPECT_LT(*senses.measure(1.0).map_time, 0.0);
  senses.note_scan();
  EXPECT_FALSE(senses.measure(1.0).map_time);
  RobotSenses blind({.use_scan = false});
  EXPECT_FALSE(blind.measure(1.0).map_time);
}

TEST(RobotSenses, PlaceAScanInBothFrames) {
  RobotSenses senses({});
  senses.add_odometry(1.0, {{0.0, 0.0}, 0.0}, {.linear = 1.0});
  senses.add_odometry(1.1, {{0.1, 0.0}, 0.0}, {.linear = 1.0});
  const LidarScan scan{.time = 1.1};
  const Pose2 mount{{0.2, 0.0}, 0.0};
  EXPECT_FALSE(senses.place(scan, 0.1, mount)) << "no localisation";
  senses.set_localisation({{10.0, 0.0}, kQuarter}, 1.0);
  const auto placed = senses.place(scan, 0.1, mount);
  ASSERT_TRUE(placed);
  EXPECT_NEAR(placed->in_odometry.first_pose.position.x(), 0.2, 1e-12);
  EXPECT_NEAR(placed->in_odometry.last_pose.position.x(), 0.3, 1e-12);
  EXPECT_NEAR(placed->in_world.first_pose.position.y(), 0.2, 1e-12);
  EXPECT_NEAR(placed->position.y(), 0.1, 1e-12);
  EXPECT_FALSE(senses.place({.time = 5.0}, 0.1, mount)) << "no odometry at that time";
}

// Robots decide ties by their numbers: each must know the one by which the others know it.
TEST(RobotSenses, MeasureTheNumberUnderWhichThePilotShares) {
  const std::uint32_t number = robot_number("red");
  RobotSenses senses({.robot = number});
  EXPECT_EQ(senses.measure(1.0).robot, number);
  Pilot pilot({}, {.use_scan = false, .robot = number});
  pilot.set_map(OccupancyGrid(
      {.width = 100, .height = 100, .resolution = 0.1, .origin = {{-5.0, -5.0}, 0.0}}));
  pilot.add_odometry(1.0, {}, {});
  pilot.set_localisation({}, 1.0);
  (void)pilot.cycle(1.0);
  const auto motion = pilot.share(1.0);
  ASSERT_TRUE(motion);
  EXPECT_EQ(motion->robot, number);
}

}  // namespace
}  // namespace fairway::bridge
