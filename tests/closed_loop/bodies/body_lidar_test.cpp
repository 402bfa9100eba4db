// SPDX-License-Identifier: Apache-2.0
// Robots with a true outline that know only their lidar and odometry.
#include <string>

#include <gtest/gtest.h>

#include "fairway/simulation/episode.hpp"
#include "support/worlds/robot_presets.hpp"

namespace fairway {
namespace {

// Two rooms with a door of 1.4 m between them: 12 m x 8 m, walled.
OccupancyGrid rooms() {
  OccupancyGrid map(GridFrame{.width = 240, .height = 160, .resolution = 0.05, .origin = {}});
  const auto wall = [&](int x0, int y0, int x1, int y1) {
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x)
        map.set({.x = x, .y = y}, CellState::Occupied);
    }
  };
  wall(0, 0, 239, 1);
  wall(0, 158, 239, 159);
  wall(0, 0, 1, 159);
  wall(238, 0, 239, 159);
  wall(118, 0, 121, 66);
  wall(118, 95, 121, 159);
  return map;
}

Scenario scenario_of(const RobotModel& model) {
  Scenario scenario;
  scenario.map = rooms();
  scenario.sensing.sensing = Sensing::Lidar;
  scenario.time_limit = 90.0;
  scenario.robots = {{.name = "robot",
                      .start = {.position = {2.5, 2.5}, .heading = 0.3},
                      .goal = {.position = {9.5, 5.5}, .heading = 1.0},
                      .model = model}};
  return scenario;
}

TEST(BodyLidar, EveryRobotArrivesWithoutAMap) {
  for (const test::NamedRobot& robot : test::robot_presets()) {
    SCOPED_TRACE(robot.name);
    const EpisodeResult result = run_episode(scenario_of(robot.model));
    EXPECT_TRUE(result.robots[0].reached)
        << to_text(result.trace.rows.back().status) << ", "
        << to_text(result.trace.rows.back().limit) << " at ("
        << result.trace.rows.back().pose.position.transpose() << ")";
    EXPECT_FALSE(result.robots[0].collided);
  }
}

TEST(BodyLidar, APersonWhoCrossesIsNotTouched) {
  Scenario scenario = scenario_of(test::robot_presets()[5].model);
  scenario.bodies = {{.name = "person",
                      .radius = 0.3,
                      .key_frames = {{0.0, {7.5, 1.0}}, {30.0, {7.5, 7.0}}},
                      .loop = true}};
  const EpisodeResult result = run_episode(scenario);
  EXPECT_TRUE(result.robots[0].reached);
  EXPECT_FALSE(result.robots[0].collided && result.robots[0].approach > 0.0);
}

TEST(BodyLidar, WithoutAWayItStaysWhereItIs) {
  Scenario scenario = scenario_of(test::robot_presets()[7].model);
  for (int y = 67; y < 95; ++y)
    scenario.map.set({.x = 119, .y = y}, CellState::Occupied);
  scenario.time_limit = 30.0;
  const EpisodeResult result = run_episode(scenario);
  EXPECT_FALSE(result.robots[0].reached);
  EXPECT_FALSE(result.robots[0].collided);
}

}  // namespace
}  // namespace fairway
