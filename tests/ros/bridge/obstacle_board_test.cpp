// SPDX-License-Identifier: Apache-2.0
#include "bridge/obstacle_board.hpp"

#include <gtest/gtest.h>

namespace fairway::bridge {
namespace {

constexpr double kSilentAfter = 0.5;

MovingObstacle moving(double x, double speed) {
  return {.position = {x, 0.0}, .velocity = {speed, 0.0}, .radius = 0.3};
}

TEST(ObstacleBoard, BringsAllDetectionsToTheOldestTime) {
  ObstacleBoard board;
  board.set_detections("camera", {.obstacles = {moving(1.0, 2.0)}, .time = 10.0});
  board.set_detections("lidar", {.obstacles = {moving(5.0, 1.0)}, .time = 10.2});
  const SeenObstacles all = board.collect(10.3, kSilentAfter);
  EXPECT_DOUBLE_EQ(all.time, 10.0);
  ASSERT_EQ(all.obstacles.size(), 2U);
  EXPECT_DOUBLE_EQ(all.obstacles[0].position.x(), 1.0);
  EXPECT_DOUBLE_EQ(all.obstacles[1].position.x(), 4.8);
}

TEST(ObstacleBoard, KeepsTheAgeOfADetectorThatSeesNothing) {
  ObstacleBoard board;
  EXPECT_FALSE(board.has_detectors());
  board.set_detections("camera", {.obstacles = {}, .time = 10.0});
  EXPECT_TRUE(board.has_detectors());
  EXPECT_DOUBLE_EQ(board.collect(12.0, kSilentAfter).time, 10.0);
}

TEST(ObstacleBoard, ShiftsAFreshNeighbourToNow) {
  ObstacleBoard board;
  board.set_neighbour("b", {.body = moving(1.0, 1.0), .greatest_speed = 1.0, .time = 9.8});
  const SeenObstacles all = board.collect(10.0, kSilentAfter);
  ASSERT_EQ(all.obstacles.size(), 1U);
  EXPECT_NEAR(all.obstacles[0].position.x(), 1.2, 1e-12);
  EXPECT_DOUBLE_EQ(all.obstacles[0].radius, 0.3);
}

TEST(ObstacleBoard, HoldsASilentNeighbourWhereverItCanBe) {
  ObstacleBoard board;
  board.set_neighbour("b", {.body = moving(1.0, 1.0), .greatest_speed = 2.0, .time = 7.0});
  EXPECT_EQ(board.silent_neighbours(7.5, kSilentAfter), 0);
  EXPECT_EQ(board.silent_neighbours(10.0, kSilentAfter), 1);
  const SeenObstacles all = board.collect(10.0, kSilentAfter);
  ASSERT_EQ(all.obstacles.size(), 1U);
  EXPECT_DOUBLE_EQ(all.obstacles[0].position.x(), 1.0);
  EXPECT_DOUBLE_EQ(all.obstacles[0].radius, 0.3 + 2.0 * 3.0);
  board.set_neighbour("b", {.body = moving(2.0, 0.0), .greatest_speed = 2.0, .time = 10.0});
  EXPECT_DOUBLE_EQ(board.collect(10.0, kSilentAfter).obstacles[0].radius, 0.3);
}

TEST(ObstacleBoard, PrefersTheNewestNewsAndLetsGoOnlyWhoLeaves) {
  ObstacleBoard board;
  board.set_neighbour("b", {.body = moving(2.0, 0.0), .greatest_speed = 1.0, .time = 10.0});
  board.set_neighbour("b", {.body = moving(1.0, 0.0), .greatest_speed = 1.0, .time = 9.9});
  EXPECT_DOUBLE_EQ(board.collect(10.0, kSilentAfter).obstacles[0].position.x(), 2.0);
  board.remove_neighbour("b");
  EXPECT_TRUE(board.collect(10.0, kSilentAfter).obstacles.empty());
}

}  // namespace
}  // namespace fairway::bridge
