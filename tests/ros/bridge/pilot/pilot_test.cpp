// SPDX-License-Identifier: Apache-2.0
// Tests the pilot from measurements to commands, in simulated time, without a middleware.
#include "bridge/pilot.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "pilot_rig.hpp"

namespace fairway::bridge {
namespace {

using test::Rig;
using test::room;

constexpr PilotOptions kMapAndScan{.plan_in_background = false};
constexpr PilotOptions kMapOnly{.use_scan = false, .plan_in_background = false};
const Goal kBehindTheWall{.position = {8.0, 1.5}, .heading = 1.0};

TEST(Pilot, SendsNothingWithoutAGoal) {
  Rig rig(kMapAndScan);
  for (int i = 0; i < 20; ++i)
    EXPECT_FALSE(rig.step().send);
}

TEST(Pilot, ReachesAGoalOnTheMapWithASeparateOdometryFrame) {
  for (const PilotOptions& options : {kMapAndScan, kMapOnly}) {
    Rig rig(options);
    rig.pilot.set_goal(kBehindTheWall);
    EXPECT_EQ(rig.drive(40.0).end, GoalEnd::Reached);
    EXPECT_LT((rig.world.robots()[0].pose.position - kBehindTheWall.position).norm(), 0.15);
    EXPECT_NEAR(rig.world.robots()[0].pose.heading, 1.0, 0.15);
    EXPECT_FALSE(rig.world.encounters()[0].collided);
    for (int i = 0; i < 5; ++i)
      rig.step();
    EXPECT_EQ(rig.pilot.state(), PilotState::Idle);
    EXPECT_EQ(rig.speed(), 0.0);
  }
}

TEST(Pilot, AvoidsObstaclesThatAreNotOnTheMap) {
  Scenario changed = room();
  for (int y = 85; y < 105; ++y) {
    for (int x = 60; x < 90; ++x)
      changed.map.set({x, y}, CellState::Occupied);
  }
  for (int y = 20; y < 50; ++y) {
    for (int x = 60; x < 66; ++x)
      changed.map.set({x, y}, CellState::Occupied);
  }
  Rig rig(kMapAndScan, changed);
  rig.pilot.set_goal(kBehindTheWall);
  EXPECT_EQ(rig.drive(60.0).end, GoalEnd::Reached);
  EXPECT_FALSE(rig.world.encounters()[0].collided);
}

TEST(Pilot, ReachesAGoalWithoutAMap) {
  Rig rig({.use_map = false, .plan_in_background = false});
  rig.step();
  rig.pilot.set_goal(rig.in_odometry(kBehindTheWall));
  EXPECT_EQ(rig.drive(60.0).end, GoalEnd::Reached);
  EXPECT_LT((rig.world.robots()[0].pose.position - kBehindTheWall.position).norm(), 0.15);
  EXPECT_FALSE(rig.world.encounters()[0].collided);
}

TEST(Pilot, SaysForWhomItWaits) {
  Scenario hall;
  hall.map = OccupancyGrid({.width = 200, .height = 60, .resolution = 0.05, .origin = {}});
  for (int x = 0; x < 200; ++x) {
    for (int y = 0; y < 60; ++y) {
      if (y < 18 || y >= 42) hall.map.set({x, y}, CellState::Occupied);
    }
  }
  hall.robots = {{.name = "robot", .start = {.position = {1.5, 1.5}, .heading = 0}, .goal = {}}};
  Rig rig(kMapOnly, hall);
  rig.pilot.set_map(hall.map);
  rig.pilot.set_goal({.position = {8.0, 1.5}});
  PilotStep answer;
  std::string said;
  for (int i = 0; i < 150; ++i) {
    rig.pilot.board().set_detections(
        "people", {.obstacles = {{.position = {5.0, 1.5}, .velocity = {0, 0}, .radius = 0.3}},
                   .time = rig.world.time()});
    answer = rig.step();
    if (!answer.explanation.empty()) said = answer.explanation;
    if (rig.speed() > 0.05) {
      EXPECT_EQ(answer.explanation, "");
    }
  }
  EXPECT_NE(said.find("waits for a moving obstacle at (5.00, 1.50)"), std::string::npos) << said;
}

// Starts to drive, then removes one input, and checks that the robot stops in time.
void expect_stop_without(bool Rig::*input,
                         const PilotOptions& options,
                         double age_limit,
                         LimitingFactor limit) {
  Rig rig(options);
  rig.pilot.set_goal(options.use_map ? kBehindTheWall : rig.in_odometry(kBehindTheWall));
  rig.drive(2.0);
  ASSERT_GT(rig.speed(), 0.5);
  rig.*input = false;
  const double braking = rig.speed() / rig.scenario.settings.robot.linear_acceleration_max;
  const PilotStep answer =
      rig.drive(age_limit + braking + 3.0 * rig.scenario.settings.navigation.control_period);
  EXPECT_TRUE(answer.send) << "zero commands continue";
  EXPECT_EQ(answer.command.linear, 0.0);
  EXPECT_EQ(answer.command.angular, 0.0);
  EXPECT_EQ(answer.status, NavigationStatus::Stale);
  EXPECT_EQ(answer.limit, limit) << to_text(answer.limit);
  EXPECT_LT(rig.speed(), 0.01);
  rig.*input = true;
  EXPECT_EQ(rig.drive(40.0).end, GoalEnd::Reached) << "continues when the input is back";
}

TEST(Pilot, StopsWithoutScans) {
  expect_stop_without(&Rig::scan_alive, kMapAndScan, 0.3, LimitingFactor::StaleMap);
  expect_stop_without(&Rig::scan_alive, {.use_map = false, .plan_in_background = false}, 0.3,
                      LimitingFactor::StaleMap);
}

TEST(Pilot, StopsWithoutOdometry) {
  expect_stop_without(&Rig::odometry_alive, kMapOnly, 0.2, LimitingFactor::StalePose);
}

TEST(Pilot, StopsWithoutLocalisation) {
  expect_stop_without(&Rig::localisation_alive, kMapOnly, 2.0, LimitingFactor::StalePose);
}

TEST(Pilot, StopsWhenADetectorWithoutDetectionsFallsSilent) {
  Rig rig(kMapOnly);
  rig.pilot.set_goal(kBehindTheWall);
  rig.pilot.board().set_detections("camera", {.obstacles = {}, .time = 0.0});
  const PilotStep answer = rig.drive(2.0);
  EXPECT_EQ(answer.limit, LimitingFactor::StaleTracks);
  EXPECT_EQ(rig.speed(), 0.0);
}

TEST(Pilot, BrakesWhenTheGoalIsCancelled) {
  Rig rig(kMapOnly);
  rig.pilot.set_goal(kBehindTheWall);
  rig.drive(2.0);
  ASSERT_GT(rig.speed(), 0.5);
  rig.pilot.cancel();
  EXPECT_EQ(rig.pilot.state(), PilotState::Stopping);
  double before = rig.speed();
  while (rig.pilot.state() != PilotState::Idle && rig.world.time() < 10.0) {
    rig.step();
    EXPECT_LE(rig.speed(), before + 1e-9);
    before = rig.speed();
  }
  EXPECT_EQ(rig.speed(), 0.0);
  EXPECT_FALSE(rig.step().send);
}

TEST(Pilot, GivesUpAnUnreachableGoalWithAReason) {
  Rig rig(kMapOnly);
  rig.pilot.set_goal({.position = {5.02, 1.0}, .heading = {}});  // in the wall
  const PilotStep answer = rig.drive(60.0);
  EXPECT_EQ(answer.end, GoalEnd::GivenUp);
  EXPECT_NE(answer.reason.find("the robot does not fit at the goal"), std::string::npos)
      << answer.reason;
  EXPECT_EQ(answer.path, PathStatus::GoalBlocked);
  EXPECT_NEAR(rig.world.time(), rig.pilot.options().patience, 0.5);
}

TEST(Pilot, FollowsAPathInsteadOfTheShortestOne) {
  Rig rig(kMapOnly);
  rig.pilot.follow({.waypoints = {{1.5, 1.5}, {1.5, 5.0}, {4.0, 5.0}}}, 0.5, 0.2);
  double furthest_from_diagonal = 0.0;
  PilotStep last;
  while (rig.world.time() < 40.0 && last.end == GoalEnd::None) {
    last = rig.step();
    const Eigen::Vector2d at = rig.world.robots()[0].pose.position;
    furthest_from_diagonal = std::max(furthest_from_diagonal, at.y() - at.x());
  }
  EXPECT_EQ(last.end, GoalEnd::Reached);
  EXPECT_GT(furthest_from_diagonal, 2.5) << "the corner of the path is 3.5 m from the diagonal";
  EXPECT_NEAR(rig.world.robots()[0].pose.heading, 0.5, 0.15);
  rig.pilot.set_goal({.position = {2.0, 4.0}, .heading = {}});
  EXPECT_EQ(rig.drive(30.0).end, GoalEnd::Reached) << "a goal replaces the path";
}

TEST(Pilot, AcceptsANewGoalDuringADrive) {
  Rig rig(kMapOnly);
  rig.pilot.set_goal(kBehindTheWall);
  rig.drive(2.0);
  rig.pilot.set_goal({.position = {2.0, 4.5}, .heading = {}});
  EXPECT_EQ(rig.drive(30.0).end, GoalEnd::Reached);
  EXPECT_LT((rig.world.robots()[0].pose.position - Eigen::Vector2d(2.0, 4.5)).norm(), 0.15);
}

TEST(Pilot, ContinuesWithOtherSettings) {
  Rig rig(kMapOnly);
  rig.pilot.set_goal(kBehindTheWall);
  rig.drive(2.0);
  Settings slow = rig.scenario.settings;
  slow.robot.linear_max = 0.3;
  rig.pilot.set_settings(slow);
  rig.drive(1.5);
  EXPECT_LT(rig.speed(), 0.35);
  EXPECT_GT(rig.speed(), 0.2);
  EXPECT_EQ(rig.drive(60.0).end, GoalEnd::Reached);
}

TEST(PilotOptions, AreChecked) {
  EXPECT_TRUE(validate(PilotOptions{}));
  EXPECT_EQ(validate(PilotOptions{.use_map = false, .use_scan = false}).error().message,
            "use_map, use_scan: expected one of them true, found both false");
  EXPECT_FALSE(validate(PilotOptions{.patience = std::nan("")}));
  EXPECT_FALSE(validate(PilotOptions{.localisation_timeout = 0.0}));
}

}  // namespace
}  // namespace fairway::bridge
