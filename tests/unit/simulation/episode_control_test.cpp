// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/episode_control.hpp"

#include <gtest/gtest.h>

#include "fairway/simulation/episode.hpp"
#include "fairway/simulation/recorded/replay_check.hpp"

namespace fairway {
namespace {

Scenario hall() {
  Scenario scenario;
  scenario.map =
      OccupancyGrid(GridFrame{.width = 200, .height = 120, .resolution = 0.05, .origin = {}});
  scenario.robots = {{.name = "robot",
                      .start = {.position = {1.0, 3.0}, .heading = 0.0},
                      .goal = {.position = {9.0, 3.0}, .heading = {}}}};
  return scenario;
}

// Plays a run: `act` is called after each cycle with its number, and ends the run by returning
// false. The navigators must give the same outputs when they run again.
EpisodeResult played(const Scenario& scenario,
                     const std::function<bool(EpisodeControl&, int)>& act) {
  ReplayCheck check;
  int cycle = 0;
  EpisodeHooks hooks;
  hooks.observer = &check;
  hooks.play = [&](EpisodeControl& control) { return act(control, cycle++); };
  EpisodeResult result = run_episode(scenario, hooks);
  EXPECT_EQ(check.different(), 0);
  return result;
}

TEST(EpisodeControl, ContinuesAtTheGoalAndDrivesToAnother) {
  double end = 0.0;
  const EpisodeResult result = played(hall(), [&](EpisodeControl& control, int cycle) {
    if (cycle == 150) control.set_goal(0, {.position = {9.0, 5.0}, .heading = {}});
    end = control.world().robots()[0].pose.position.y();
    return cycle < 250;
  });
  EXPECT_TRUE(result.robots[0].reached);
  EXPECT_NEAR(end, 5.0, 0.2);
}

TEST(EpisodeControl, PlansAroundObstaclesThatAppear) {
  const EpisodeResult result = played(hall(), [](EpisodeControl& control, int cycle) {
    if (cycle == 15) {
      std::vector<CellIndex> wall;
      for (int y = 20; y < 90; ++y)
        wall.push_back({.x = 110, .y = y});
      control.set_cells(wall, true);
    }
    return cycle < 250;
  });
  EXPECT_TRUE(result.robots[0].reached);
  EXPECT_FALSE(result.robots[0].collided);
  EXPECT_GT(result.robots[0].plan.path.length(), 5.0);
}

TEST(EpisodeControl, MakesNoObstacleInARobotOrOutsideTheMap) {
  static_cast<void>(played(hall(), [](EpisodeControl& control, int) {
    const GridFrame& frame = control.world().obstacles().frame();
    const CellIndex here = frame.cell_at(control.world().robots()[0].pose.position);
    const std::vector<CellIndex> cells = {here, {.x = -1, .y = 0}, {.x = 0, .y = 120}};
    control.set_cells(cells, true);
    EXPECT_FALSE(control.world().obstacles().blocked(here));
    return false;
  }));
}

TEST(EpisodeControl, MovesAndRemovesBodies) {
  static_cast<void>(played(hall(), [](EpisodeControl& control, int cycle) {
    const MovingBody body{.name = "person",
                          .radius = 0.3,
                          .key_frames = {{.time = 0.0, .position = {5.0, 5.0}}},
                          .loop = false};
    if (cycle == 0) control.set_body(0, body);
    if (cycle == 1) control.set_body(1, body);
    if (cycle == 2) {
      EXPECT_EQ(control.world().num_bodies(), 2U);
      control.remove_body(0);
      EXPECT_EQ(control.world().num_bodies(), 1U);
    }
    return cycle < 5;
  }));
}

TEST(EpisodeControl, ContinuesWithOtherSettings) {
  double fastest = 0.0;
  const EpisodeResult result = played(hall(), [&](EpisodeControl& control, int cycle) {
    if (cycle == 20) {
      Settings slow;
      slow.robot.linear_max = 0.3;
      control.set_settings(slow);
    }
    if (cycle > 40) fastest = std::max(fastest, control.world().robots()[0].twist.linear);
    return cycle < 300;
  });
  EXPECT_TRUE(result.robots[0].reached);
  EXPECT_GT(fastest, 0.2);
  EXPECT_LT(fastest, 0.3 + 1e-9);
}

}  // namespace
}  // namespace fairway
