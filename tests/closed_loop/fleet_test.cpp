// SPDX-License-Identifier: Apache-2.0
// Robots among robots: nobody touches, everybody arrives.
#include <algorithm>

#include <gtest/gtest.h>

#include "fairway/simulation/episode.hpp"
#include "fairway/simulation/swap_scenario.hpp"

namespace fairway {
namespace {

struct Outcome {
  bool arrived = true;
  bool touched = false;
  double time = 0.0;  // of the last to arrive [s]
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

TEST(Fleet, DoesNotTouchWhereMessagesAreLateOrLost) {
  for (const double loss : {0.0, 0.2}) {
    Scenario scenario = swap_scenario(4, 4.0, {}, 1);
    scenario.radio.delay = 0.1;
    scenario.radio.loss = loss;
    const Outcome outcome = run(scenario);
    EXPECT_TRUE(outcome.arrived) << "loss " << loss;
    EXPECT_FALSE(outcome.touched) << "loss " << loss;
  }
}

// Two rooms of 5 m x 6 m and a door of 0.9 m.
TEST(Fleet, ChangesRoomsThroughADoorThatOnlyOneFitsThrough) {
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

}  // namespace
}  // namespace fairway
