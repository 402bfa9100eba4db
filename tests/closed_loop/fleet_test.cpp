// SPDX-License-Identifier: Apache-2.0
// Several robots in one world: all arrive without contact.
#include <algorithm>

#include <gtest/gtest.h>

#include "fairway/simulation/episode.hpp"
#include "fairway/simulation/scenarios/swap_scenario.hpp"

namespace fairway {
namespace {

struct Outcome {
  bool arrived = true;
  bool touched = false;
  double time = 0.0;  // of the last arrival [s]
};

Outcome run(const Scenario& scenario) {
  Outcome outcome;
  for (const RobotResult& robot : run_episode(scenario).robots) {
    outcome.arrived = outcome.arrived && robot.reached;
    outcome.touched = outcome.touched || robot.collided;
    outcome.time = std::max(outcome.time, robot.time);
  }
  return outcome;
}

TEST(Fleet, ExchangesPlacesOnACircle) {
  for (const int robots : {2, 3, 4, 8}) {
    for (const std::uint64_t seed : {0U, 1U, 2U}) {
      const Outcome outcome = run(swap_scenario(robots, swap_radius(robots), {}, seed));
      EXPECT_TRUE(outcome.arrived) << robots << " robots, seed " << seed;
      EXPECT_FALSE(outcome.touched) << robots << " robots, seed " << seed;
      EXPECT_LT(outcome.time, 1.5 * 8.5) << robots << " robots, seed " << seed;
    }
  }
}

TEST(Fleet, MakesNoContactWhenMessagesAreLateOrLost) {
  for (const double loss : {0.0, 0.2}) {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
      Scenario scenario = swap_scenario(8, 4.0, {}, seed);
      scenario.radio.delay = 0.1;
      scenario.radio.loss = loss;
      const Outcome outcome = run(scenario);
      EXPECT_TRUE(outcome.arrived) << "loss " << loss << ", seed " << seed;
      EXPECT_FALSE(outcome.touched) << "loss " << loss << ", seed " << seed;
    }
  }
}

// Two rooms of 5 m x 6 m, joined by a door of 0.9 m.
TEST(Fleet, ChangesRoomsThroughADoorForOneRobotAtATime) {
  OccupancyGrid map({.width = 200, .height = 120, .resolution = 0.05, .origin = {}});
  for (int y = 0; y < 120; ++y) {
    for (int x = 98; x < 102; ++x)
      map.set({x, y}, y >= 51 && y < 69 ? CellState::Free : CellState::Occupied);
  }
  Scenario scenario;
  scenario.map = map;
  scenario.time_limit = 60.0;
  const auto add = [&](double y, bool from_west) {
    scenario.robots.push_back(
        {.name = "robot",
         .start = {.position = {from_west ? 1.0 : 9.0, y}, .heading = from_west ? 0.0 : 3.14},
         .goal = {.position = {from_west ? 9.0 : 1.0, y}, .heading = {}}});
  };
  add(1.5, true);
  add(4.5, true);
  add(1.5, false);
  add(4.5, false);
  const Outcome outcome = run(scenario);
  EXPECT_TRUE(outcome.arrived);
  EXPECT_FALSE(outcome.touched);
}

// 24 m x 6 m: rooms of 4 m, joined by a passage of 0.8 m; `bend` moves its eastern half up [m].
OccupancyGrid passage(double bend) {
  OccupancyGrid map({.width = 240, .height = 60, .resolution = 0.1, .origin = {}});
  const int up = static_cast<int>(bend / 0.1);
  for (int x = 40; x < 200; ++x) {
    const int low = x < 120 ? 26 : 26 + up;
    const int high = x < 120 - 8 || x >= 120 ? low + 8 : low + 8 + up;
    for (int y = 0; y < 60; ++y)
      map.set({x, y}, y >= low && y < high ? CellState::Free : CellState::Occupied);
  }
  return map;
}

RobotTask task(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return {.name = "robot",
          .start = {.position = from, .heading = to.x() > from.x() ? 0.0 : 3.14},
          .goal = {.position = to, .heading = {}}};
}

TEST(Fleet, TheRobotWithTheShorterRetreatPathLeavesThePassage) {
  for (const double bend : {0.0, 1.5}) {
    Scenario scenario;
    scenario.map = passage(bend);
    scenario.time_limit = 100.0;
    scenario.robots = {task({8, 3}, {22, 3}), task({15, 3 + bend}, {2, 3})};
    const EpisodeResult result = run_episode(scenario);
    for (const RobotResult& robot : result.robots) {
      EXPECT_TRUE(robot.reached) << "bend of " << bend << " m";
      EXPECT_FALSE(robot.collided) << "bend of " << bend << " m";
    }
    EXPECT_LT(result.robots[1].time + 5.0, result.robots[0].time) << "bend of " << bend << " m";
  }
}

TEST(Fleet, AFollowedRobotLeavesThePassageWithItsFollower) {
  Scenario scenario;
  scenario.map = passage(0.0);
  scenario.time_limit = 100.0;
  scenario.robots = {task({8, 3}, {22, 3}), task({6.8, 3}, {22, 1.5}), task({14, 3}, {2, 3})};
  const Outcome outcome = run(scenario);
  EXPECT_TRUE(outcome.arrived);
  EXPECT_FALSE(outcome.touched);
}

TEST(Fleet, LeavesAPassageWhenMessagesAreLateAndLost) {
  Scenario scenario;
  scenario.map = passage(0.0);
  scenario.time_limit = 100.0;
  scenario.robots = {task({8, 3}, {22, 3}), task({15, 3}, {2, 3})};
  scenario.radio = {.delay = 0.1, .loss = 0.2};
  const Outcome outcome = run(scenario);
  EXPECT_TRUE(outcome.arrived);
  EXPECT_FALSE(outcome.touched);
}

// The passage ends behind the robot that has to leave.
TEST(Fleet, ARobotOutsideADeadEndLetsTheOneInsideLeave) {
  Scenario scenario;
  scenario.map = passage(0.0);
  for (int x = 140; x < 240; ++x) {
    for (int y = 0; y < 60; ++y)
      scenario.map.set({x, y}, CellState::Occupied);
  }
  scenario.time_limit = 100.0;
  scenario.robots = {task({13, 3}, {2, 1.5}), task({7, 3}, {13, 3})};
  const Outcome outcome = run(scenario);
  EXPECT_TRUE(outcome.arrived);
  EXPECT_FALSE(outcome.touched);
}

}  // namespace
}  // namespace fairway
