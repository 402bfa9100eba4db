// SPDX-License-Identifier: Apache-2.0
#include "experiments/barn/barn.hpp"

#include <gtest/gtest.h>

namespace fairway {
namespace {

BarnWorld ten_metres() {
  BarnWorld world;
  world.number = 7;
  world.goal = {10.0, 0.0};
  world.optimal_time = 6.0;
  return world;
}

// A robot that waits 1 s and then drives to `end` at `speed`.
EpisodeResult straight_run(double speed, double end) {
  EpisodeResult result;
  result.robots.resize(1);
  double x = 0.0;
  for (int i = 0; i <= 1200; ++i) {
    TraceRow row;
    row.time = 0.1 * i;
    x = std::min(end, speed * std::max(0.0, row.time - 1.0));
    row.pose.position = {x, 0.0};
    result.trace.rows.push_back(row);
  }
  result.time = result.trace.rows.back().time;
  result.robots[0].time = result.time;
  return result;
}

TEST(Barn, TheClockRunsFromTenCentimetresToOneMetreBeforeTheGoal) {
  const BarnScore score = barn_score(ten_metres(), 3, straight_run(0.5, 10.0));
  EXPECT_TRUE(score.success);
  EXPECT_EQ(score.world, 7);
  EXPECT_EQ(score.trial, 3);
  EXPECT_NEAR(score.time, 8.9 / 0.5, 1e-9);
  EXPECT_NEAR(score.score, 6.0 / (8.9 / 0.5), 1e-9);
}

TEST(Barn, TheScoreIsAtMostAHalfAndAtLeastAnEighth) {
  EXPECT_NEAR(barn_score(ten_metres(), 0, straight_run(2.0, 10.0)).score, 0.5, 1e-12);
  EXPECT_NEAR(barn_score(ten_metres(), 0, straight_run(0.1, 10.0)).score, 0.125, 1e-12);
}

TEST(Barn, ARunThatDoesNotArriveIsNoSuccess) {
  const BarnScore score = barn_score(ten_metres(), 0, straight_run(1.0, 8.0));
  EXPECT_FALSE(score.success);
  EXPECT_FALSE(score.collided);
  EXPECT_EQ(score.score, 0.0);
}

TEST(Barn, AContactBeforeTheGoalIsAFailureAndOneAfterItIsNot) {
  EpisodeResult result = straight_run(1.0, 10.0);
  result.robots[0].collided = true;
  result.robots[0].time = 5.0;
  EXPECT_TRUE(barn_score(ten_metres(), 0, result).collided);
  EXPECT_FALSE(barn_score(ten_metres(), 0, result).success);
  result.robots[0].time = 10.5;  // it was within a metre at 10.0 s
  EXPECT_TRUE(barn_score(ten_metres(), 0, result).success);
  EXPECT_FALSE(barn_score(ten_metres(), 0, result).collided);
}

TEST(Barn, ALateArrivalIsNoSuccess) {
  BarnWorld world = ten_metres();
  world.timeout = 5.0;
  EXPECT_FALSE(barn_score(world, 0, straight_run(1.0, 10.0)).success);
}

TEST(Barn, TrialsDifferOnlyInTheirSeed) {
  const BarnWorld world = ten_metres();
  const Scenario first = barn_scenario(world, {}, 0);
  const Scenario second = barn_scenario(world, {}, 1);
  EXPECT_NE(first.seed, second.seed);
  EXPECT_EQ(first.robots[0].goal.position, world.goal);
}

}  // namespace
}  // namespace fairway
