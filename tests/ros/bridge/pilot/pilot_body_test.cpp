// SPDX-License-Identifier: Apache-2.0
// The pilot of robots with their true outline.
#include <algorithm>

#include <gtest/gtest.h>

#include "pilot_rig.hpp"
#include "support/worlds/robot_presets.hpp"

namespace fairway::bridge {
namespace {

using test::Rig;
using test::room;

// Bodies whose covering disc would not turn where they stop.
TEST(Pilot, DrivesEveryBodyOnAMapAndWithoutOne) {
  for (const fairway::test::NamedRobot& robot : fairway::test::robot_presets()) {
    for (const bool use_map : {true, false}) {
      SCOPED_TRACE(std::string(robot.name) + (use_map ? " on a map" : " without a map"));
      PilotOptions options{.use_map = use_map, .plan_in_background = false};
      options.body = robot.model;
      ASSERT_TRUE(validate(options));
      Scenario truth = room();
      truth.robots[0].model = robot.model;
      Rig rig(options, truth);
      rig.step();
      const Goal goal{.position = {3.6, 4.0}, .heading = {}};
      rig.pilot.set_goal(use_map ? goal : rig.in_odometry(goal));
      const PilotStep last = rig.drive(60.0);
      EXPECT_EQ(last.end, GoalEnd::Reached) << to_text(last.status) << ' ' << to_text(last.limit);
      EXPECT_FALSE(rig.world.encounters()[0].collided);
      EXPECT_LT((rig.world.robots()[0].pose.position - goal.position).norm(), 0.15);
    }
  }
}

// A keep-out on the straight line to the goal.
TEST(Pilot, ABodyObeysTheZones) {
  PilotOptions options{.plan_in_background = false};
  options.body = fairway::test::robot_presets().front().model;
  options.zones = {
      Zone{.kind = ZoneKind::KeepOut, .polygon = {{2.2, 2.4}, {3.0, 2.4}, {3.0, 3.2}, {2.2, 3.2}}}};
  ASSERT_TRUE(validate(options));
  Scenario truth = room();
  truth.robots[0].model = options.body;
  Rig rig(options, truth);
  rig.step();
  rig.pilot.set_goal({.position = {3.6, 4.0}, .heading = {}});
  const double until = rig.world.time() + 60.0;
  PilotStep last;
  double nearest = 10.0;  // distance of the reference point from the zone
  while (rig.world.time() < until && last.end == GoalEnd::None) {
    last = rig.step();
    const Eigen::Vector2d from_centre =
        (rig.world.robots()[0].pose.position - Eigen::Vector2d(2.6, 2.8)).cwiseAbs();
    nearest = std::min(nearest, (from_centre.array() - 0.4).max(0.0).matrix().norm());
  }
  EXPECT_EQ(last.end, GoalEnd::Reached) << to_text(last.status) << ' ' << to_text(last.limit);
  EXPECT_GT(nearest, 0.2);
}

// The goal is inside the wall that only the scans have shown, or beside a path with a bound.
TEST(Pilot, ABodyGivesUpAfterItsPatience) {
  PilotOptions options{.plan_in_background = false, .patience = 3.0};
  options.body = fairway::test::robot_presets().front().model;
  Scenario truth = room();
  truth.robots[0].model = options.body;
  Rig rig(options, truth);
  rig.step();
  rig.pilot.set_goal({.position = {5.0, 1.5}, .heading = {}});
  const double begin = rig.world.time();
  const PilotStep last = rig.drive(20.0);
  EXPECT_EQ(last.end, GoalEnd::GivenUp);
  EXPECT_GE(rig.world.time() - begin, 3.0);
  EXPECT_LE(rig.world.time() - begin, 3.5);
  EXPECT_FALSE(last.reason.empty());
}

// A path with a bound stays one, with its strips: the end of it lies just behind the start.
TEST(Pilot, ABodyKeepsItsPathWhenTheSettingsChange) {
  PilotOptions options{.plan_in_background = false};
  options.body = fairway::test::robot_presets().front().model;
  Scenario truth = room();
  truth.robots[0].model = options.body;
  Rig rig(options, truth);
  rig.step();
  rig.pilot.follow({{{1.5, 1.5}, {3.8, 1.5}, {3.8, 4.5}, {1.5, 4.5}}}, {}, 0.8);
  rig.drive(3.0);
  Settings changed = rig.pilot.settings();
  changed.navigation.patience = 30.0;
  rig.pilot.set_settings(changed);
  double furthest = 0.0;
  PilotStep last;
  for (double until = rig.world.time() + 60.0;
       rig.world.time() < until && last.end == GoalEnd::None;) {
    last = rig.step();
    furthest = std::max(furthest, rig.world.robots()[0].pose.position.x());
  }
  EXPECT_EQ(last.end, GoalEnd::Reached) << to_text(last.status) << ' ' << to_text(last.limit);
  EXPECT_GT(furthest, 2.8);
}

}  // namespace
}  // namespace fairway::bridge
