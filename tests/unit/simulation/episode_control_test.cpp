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

TEST(EpisodeControl, ARobotWhoseGoalIsCancelledStops) {
  double speed = 1.0;
  const EpisodeResult result = played(hall(), [&](EpisodeControl& control, int cycle) {
    if (cycle == 15) control.cancel_goal(0);
    speed = control.world().robots()[0].twist.linear;
    return cycle < 60;
  });
  EXPECT_NEAR(speed, 0.0, 1e-6);
  EXPECT_FALSE(result.robots[0].reached);
}

TEST(EpisodeControl, APlacedRobotContinuesToItsGoalFromThere) {
  const EpisodeResult result = played(hall(), [](EpisodeControl& control, int cycle) {
    if (cycle == 15) {
      control.place_robot(0, {.position = {3.0, 1.0}, .heading = 1.0});
      EXPECT_EQ(control.world().robots()[0].pose.position, Eigen::Vector2d(3.0, 1.0));
    }
    return cycle < 250;
  });
  EXPECT_TRUE(result.robots[0].reached);
}

TEST(EpisodeControl, PlacingARobotForgetsItsContact) {
  static_cast<void>(played(hall(), [](EpisodeControl& control, int cycle) {
    const MovingBody body{.name = "person",
                          .radius = 0.3,
                          .key_frames = {{.time = 0.0, .position = {1.0, 3.0}}},
                          .loop = false};
    if (cycle == 0) control.set_body(0, body);
    if (cycle == 2) {
      const Encounter& met = control.world().encounters()[0];
      EXPECT_TRUE(met.collided);
      EXPECT_EQ(met.contact.with, Contact::With::Body);
      EXPECT_EQ(met.contact.other, 0U);
      control.place_robot(0, {.position = {5.0, 5.0}, .heading = 0.0});
    }
    if (cycle == 20) {
      EXPECT_GT(control.world().robots()[0].twist.linear, 0.1);
    }
    return cycle < 20;
  }));
}

TEST(EpisodeControl, RobotsAreAddedAndRemovedWithoutANewRun) {
  const EpisodeResult result = played(hall(), [](EpisodeControl& control, int cycle) {
    if (cycle == 10) {
      control.add_robot({.name = "second",
                         .start = {.position = {5.0, 5.0}, .heading = 0.0},
                         .goal = {},
                         .idle = true});
    }
    if (cycle == 12) control.set_goal(1, {.position = {8.0, 5.0}, .heading = {}});
    if (cycle == 100) {
      control.set_present(0, false);
      EXPECT_TRUE(control.world().encounters()[0].absent);
    }
    if (cycle == 110) control.set_present(0, true);
    return cycle < 250;
  });
  ASSERT_EQ(result.robots.size(), 2U);
  EXPECT_TRUE(result.robots[1].reached);
  EXPECT_FALSE(result.robots[0].collided);
}

TEST(EpisodeControl, AnAbsentRobotIsNoObstacle) {
  const EpisodeResult result = played(hall(), [](EpisodeControl& control, int cycle) {
    if (cycle == 0) {
      control.add_robot({.name = "second",
                         .start = {.position = {5.0, 3.0}, .heading = 0.0},
                         .goal = {},
                         .idle = true});
      control.set_present(1, false);
    }
    return cycle < 250;
  });
  EXPECT_TRUE(result.robots[0].reached);
  EXPECT_FALSE(result.robots[0].collided);
}

TEST(EpisodeControl, AnEmergencyStopHoldsAllRobotsUntilItIsReleased) {
  const EpisodeResult result = played(hall(), [](EpisodeControl& control, int cycle) {
    if (cycle == 15) control.set_halted(true);
    if (cycle == 50) {
      EXPECT_NEAR(control.world().robots()[0].twist.linear, 0.0, 1e-9);
      control.set_halted(false);
    }
    return cycle < 300;
  });
  EXPECT_TRUE(result.robots[0].reached);
}

TEST(EpisodeControl, APausedWorldTakesOverPlansOfThreads) {
  Scenario scenario = hall();
  scenario.settings.planning.background = true;
  int at_goal = 0;
  const EpisodeResult result = played(scenario, [&](EpisodeControl& control, int cycle) {
    control.take_plans();
    const UnicycleRobot& robot = control.world().robots()[0];
    if ((robot.pose.position - Eigen::Vector2d(9.0, 3.0)).norm() < 0.15) ++at_goal;
    return at_goal < 100 && cycle < 1000000;  // a thread may be slower than many cycles
  });
  EXPECT_TRUE(result.robots[0].reached);
}

}  // namespace
}  // namespace fairway
