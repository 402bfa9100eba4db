// SPDX-License-Identifier: Apache-2.0
#include "bridge/sensing/obstacle_board.hpp"

#include <gtest/gtest.h>

namespace fairway::bridge {
namespace {

MovingObstacle moving(double x, double speed) {
  return {.position = {x, 0.0}, .velocity = {speed, 0.0}, .radius = 0.3};
}

TEST(ObstacleBoard, ExtrapolatesAllDetectionsToTheOldestTime) {
  ObstacleBoard board;
  board.set_detections("camera", {.obstacles = {moving(1.0, 2.0)}, .time = 10.0});
  board.set_detections("lidar", {.obstacles = {moving(5.0, 1.0)}, .time = 10.2});
  const SeenObstacles all = board.collect(10.3);
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
  EXPECT_DOUBLE_EQ(board.collect(12.0).time, 10.0);
}

}  // namespace
}  // namespace fairway::bridge
