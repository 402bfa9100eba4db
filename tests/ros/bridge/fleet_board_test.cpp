// SPDX-License-Identifier: Apache-2.0
#include "bridge/fleet_board.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace fairway::bridge {
namespace {

SharedMotion motion_at(double x, double time) {
  SharedMotion motion{
      .robot = 1, .time = time, .position = {x, 0.0}, .speed_max = 1.0, .acceleration = 2.0};
  motion.plan.add(motion.position);
  motion.stop.add(motion.position);
  return motion;
}

TEST(FleetBoard, NumbersRobotsByTheirNames) {
  EXPECT_EQ(robot_number(""), 2166136261U);
  EXPECT_EQ(robot_number("a"), 0xe40c292cU) << "FNV-1a's published value";
  EXPECT_NE(robot_number("robot_1"), robot_number("robot_2"));
}

TEST(FleetBoard, ReportsTheAgeOfItsMessages) {
  FleetBoard board;
  EXPECT_TRUE(board.receive("b", motion_at(3.0, 10.0), 10.0));
  const Fleet fleet = board.around({0, 0}, 10.25);
  ASSERT_EQ(fleet.size(), 1U);
  EXPECT_EQ(fleet[0].motion->position.x(), 3.0);
  EXPECT_DOUBLE_EQ(fleet[0].unseen, 0.25);
}

TEST(FleetBoard, PrefersTheNewestMessage) {
  FleetBoard board;
  EXPECT_TRUE(board.receive("b", motion_at(3.0, 10.0), 10.0));
  board.receive("b", motion_at(2.0, 9.9), 10.0);
  EXPECT_EQ(board.around({0, 0}, 10.0)[0].motion->position.x(), 3.0);
  board.receive("b", motion_at(4.0, 10.1), 10.1);
  EXPECT_EQ(board.around({0, 0}, 10.1)[0].motion->position.x(), 4.0);
}

// One wrong clock or one broken message must not silence a robot: its next good message counts.
TEST(FleetBoard, RefusesAnImplausibleMessageAndUsesTheNextGoodOne) {
  constexpr double kNow = 10.0;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double stamp : {nan, 3600.0, 1e18, kNow + 2.0 * FleetBoard::kMostAhead}) {
    FleetBoard board;
    EXPECT_FALSE(board.receive("b", motion_at(3.0, stamp), kNow)) << stamp;
    EXPECT_TRUE(board.around({0, 0}, kNow).empty()) << stamp;
    EXPECT_TRUE(board.receive("b", motion_at(4.0, kNow), kNow)) << stamp;
    ASSERT_EQ(board.around({0, 0}, kNow).size(), 1U) << stamp;
    EXPECT_EQ(board.around({0, 0}, kNow)[0].motion->position.x(), 4.0) << stamp;
  }
  FleetBoard board;
  for (const double place : {nan, 1e300})
    EXPECT_FALSE(board.receive("b", motion_at(place, kNow), kNow));
  EXPECT_TRUE(board.around({0, 0}, kNow).empty());
}

TEST(FleetBoard, AllowsForClocksThatDifferALittle) {
  FleetBoard board;
  EXPECT_TRUE(board.receive("b", motion_at(3.0, 10.0 + 0.9 * FleetBoard::kMostAhead), 10.0));
}

TEST(FleetBoard, KeepsSilentRobotsAndForgetsOnlyThoseThatLeave) {
  FleetBoard board;
  EXPECT_TRUE(board.receive("b", motion_at(3.0, 10.0), 10.0));
  EXPECT_EQ(board.around({0, 0}, 1000.0).size(), 1U);
  board.forget("b");
  EXPECT_TRUE(board.around({0, 0}, 1000.0).empty());
}

TEST(FleetBoard, OmitsDistantRobotsUntilTheyCanHaveComeNear) {
  FleetBoard board;
  EXPECT_TRUE(board.receive("b", motion_at(20.0, 10.0), 10.0));
  EXPECT_TRUE(board.around({0, 0}, 10.0).empty());
  EXPECT_TRUE(board.around({0, 0}, 14.0).empty());
  EXPECT_EQ(board.around({0, 0}, 16.0).size(), 1U);
}

}  // namespace
}  // namespace fairway::bridge
