// SPDX-License-Identifier: Apache-2.0
// Behind a person in a passage too narrow to overtake, with limits other than the defaults: the
// robot stays behind, and touches neither person nor wall.
#include <string>

#include <gtest/gtest.h>

#include "fairway/simulation/episode.hpp"

namespace fairway {
namespace {

constexpr double kCell = 0.05;  // [m]

struct Passage {
  int cells_across;  // the walls included
  double robot_y;
  Eigen::Vector2d person;
  Eigen::Vector2d velocity;
  double speed;
  double change;  // acceleration and braking
  RobotSettings base{};
};

Scenario scenario_of(const Passage& passage) {
  Scenario scenario;
  const int along = 1200;
  OccupancyGrid map({.width = along, .height = passage.cells_across, .resolution = kCell});
  for (int x = 0; x < along; ++x) {
    map.set({.x = x, .y = 0}, CellState::Occupied);
    map.set({.x = x, .y = passage.cells_across - 1}, CellState::Occupied);
  }
  scenario.map = map;
  scenario.settings.robot = passage.base;
  scenario.settings.robot.linear_max = passage.speed;
  scenario.settings.robot.linear_acceleration_max = passage.change;
  scenario.time_limit = 45.0;
  scenario.robots = {
      {.name = "amr",
       .start = {.position = {1.0, passage.robot_y}, .heading = 0.0},
       .goal = {.position = {55.0, 0.5 * kCell * passage.cells_across}, .heading = {}}}};
  constexpr double kLong = 200.0;  // [s]
  scenario.bodies = {
      {.name = "person",
       .radius = 0.3,
       .key_frames = {{0.0, passage.person}, {kLong, passage.person + kLong * passage.velocity}}}};
  return scenario;
}

void expect_distance(const Passage& passage) {
  const EpisodeResult result = run_episode(scenario_of(passage));
  EXPECT_FALSE(result.robots[0].collided) << "at " << result.robots[0].time << " s";
  EXPECT_GT(result.robots[0].min_separation, 0.05);
  EXPECT_GT(result.robots[0].min_clearance, 0.0);
}

TEST(NoContact, BehindAPersonWhoWalks) {
  expect_distance({24, 0.5, {11.755, 0.7}, {0.871, -0.0005}, 2.0, 2.0});
  expect_distance({24, 0.7, {14.344, 0.5}, {0.741, 0.0005}, 2.0, 1.5});
  expect_distance({24, 0.5, {15.367, 0.5}, {0.5, 0.0005}, 1.5, 1.0});
  expect_distance({28, 0.7, {14.890, 0.7}, {1.188, 0.0}, 2.0, 1.5});
}

TEST(NoContact, WithAWallWhereBrakingTakesLong) {
  expect_distance({24, 0.6, {20.0, 0.6}, {0.3, 0.0}, 2.0, 0.7});
}

TEST(NoContact, BeforeAPersonWhoStandsWhereBrakingTakesAsLongAsTheHorizon) {
  expect_distance({24, 0.6, {40.0, 0.6}, {0.0, 0.0}, 2.0, 1.0});
  expect_distance({24, 0.6, {40.0, 0.6}, {0.0, 0.0}, 3.0, 0.7});
}

TEST(NoContact, WithABaseThatAnswersLateAndBrakesLess) {
  RobotSettings late;
  late.linear_delay = late.angular_delay = 0.4;
  expect_distance({24, 0.6, {20.0, 0.6}, {0.5, 0.0}, 1.5, 1.0, late});
  RobotSettings weak;
  weak.linear_braking_max = 0.5;
  weak.linear_lag = weak.angular_lag = 0.2;
  expect_distance({24, 0.6, {20.0, 0.6}, {0.5, 0.0}, 1.5, 1.0, weak});
}

}  // namespace
}  // namespace fairway
