// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "fairway/simulation/people/walkers.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

Scenario open_floor() {
  Scenario scenario;
  scenario.map =
      OccupancyGrid({.width = 200, .height = 200, .resolution = 0.05, .origin = {{-5, -5}, 0}});
  scenario.settings.robot.radius = 0.25;
  return scenario;
}

TEST(World, ARobotThatDrivesIntoAWallTouchesItAndStops) {
  Scenario scenario = open_floor();
  scenario.map.set({130, 100}, CellState::Occupied);  // [1.5, 1.55] x [0, 0.05]
  scenario.robots = {{.name = "a", .start = {{0, 0.025}, 0}, .goal = {}}};
  World world(scenario);
  for (int i = 0; i < 50; ++i)
    world.advance({{1.0, 0.0}}, 0.1);
  EXPECT_TRUE(world.encounters()[0].collided);
  // It stopped where its rim met the cell, within one fine step.
  EXPECT_NEAR(world.robots()[0].pose.position.x(), 1.5 - 0.25, 1.0 * World::kFineStep + 1e-9);
  EXPECT_LT(world.encounters()[0].min_clearance, 0.0);
}

// Of a body of 2 m x 0.2 m only the front touches, and a disc beside it does not.
TEST(World, ContactOfARobotWithAModelIsJudgedByItsTrueBody) {
  Scenario scenario = open_floor();
  scenario.map.set({130, 100}, CellState::Occupied);  // [1.5, 1.55] x [0, 0.05]
  RobotModel model{.body = BodyShape::rectangle(2.0, 0.2, 1.0), .base = {}};
  scenario.robots = {{.name = "a", .start = {{0, 0.025}, 0}, .goal = {}, .model = model}};
  MovingBody person;
  person.radius = 0.3;
  person.key_frames = {{0.0, {0.0, 0.6}}};
  scenario.bodies = {person};
  World world(scenario);
  world.send(0, {.linear = 1.0});
  for (int i = 0; i < 30; ++i)
    world.advance({{}}, 0.1);
  EXPECT_TRUE(world.encounters()[0].collided);
  EXPECT_NEAR(world.robots()[0].pose.position.x(), 0.5, 1.0 * World::kFineStep + 1e-9);
  EXPECT_NEAR(world.encounters()[0].min_separation, 0.6 - 0.025 - 0.1 - 0.3, 1e-9);
}

// The person walks at a robot that does not move: around it if the person sees it, otherwise into
// it.
TEST(World, PeopleWhoSeeRobotsWalkAroundThem) {
  for (const WalkingModel model : {WalkingModel::Orca, WalkingModel::SocialForce}) {
    Scenario scenario = open_floor();
    scenario.robots = {{.name = "a", .start = {{0, 0}, 0}, .goal = {}}};
    const Walker person{.start = {3, 0.05}, .goal = {-3, 0.05}, .speed = 1.0};
    for (const bool sees : {false, true}) {
      scenario.bodies =
          sees ? walking_bodies({&person, 1}, model) : walk({&person, 1}, model, 15.0);
      World world(scenario);
      for (int i = 0; i < 150; ++i)
        world.advance({{}}, 0.1);
      EXPECT_EQ(world.encounters()[0].collided, !sees);
      EXPECT_LT((world.body(0).at(world.time()).position - person.goal).norm(), 0.5);
    }
  }
}

TEST(World, PeopleWhoSeeRobotsWalkForHoursInBoundedMemory) {
  Scenario scenario = open_floor();
  const Walker person{.start = {3, 0}, .goal = {-3, 0}, .speed = 1.0, .returns = true};
  scenario.bodies = walking_bodies({&person, 1}, WalkingModel::Orca);
  World world(scenario);
  for (int i = 0; i < 2400; ++i) {
    world.advance({}, 0.1);
    const MovingBody& body = world.body(0);
    ASSERT_LE(body.key_frames.size(), 1000U);
    ASSERT_NEAR(body.at(world.time() - 0.05).velocity.norm(), body.walk->velocity.norm(), 1e-9);
  }
}

// Steps of a run that are no part of a person's step change nothing but rounding.
TEST(World, PeopleWhoSeeRobotsMoveSteadilyAtAnyPeriod) {
  Scenario scenario = open_floor();
  const Walker person{.start = {3, 0}, .goal = {-3, 0}, .speed = 1.0};
  scenario.bodies = walking_bodies({&person, 1}, WalkingModel::Orca);
  World world(scenario);
  for (int i = 0; i < 60; ++i) {
    std::vector<MovingObstacle> seen;
    world.moving_bodies(seen);
    EXPECT_NEAR(seen.at(0).velocity.x(), -1.0, 1e-6) << world.time();
    EXPECT_NEAR(seen[0].position.x(), 3.0 - world.time(), 1e-6);
    world.advance({}, 0.037);
  }
}

TEST(World, ARobotWithAModelMovesSidewaysWithinItsLimits) {
  Scenario scenario = open_floor();
  RobotModel model{.body = BodyShape::rectangle(1.0, 0.5, 0.5), .base = {}};
  model.base.kind = BaseKind::Omni;
  model.base.lateral_acceleration = 0.5;
  scenario.robots = {{.name = "a", .start = {{0, 0}, 0}, .goal = {}, .model = model}};
  World world(scenario);
  world.send(0, {.lateral = 0.4});
  world.advance({{}}, 0.4);
  EXPECT_NEAR(world.robots()[0].pose.position.y(), 0.5 * 0.5 * 0.4 * 0.4, 1e-9);
  EXPECT_NEAR(world.model_of(0)->twist().lateral, 0.2, 1e-12);
  EXPECT_EQ(world.clearance(0), World::kClearanceLimit);
}

TEST(World, TwoRobotsThatMeetHaveBothCollided) {
  Scenario scenario = open_floor();
  scenario.robots = {{.name = "a", .start = {{-1, 0}, 0}, .goal = {}},
                     {.name = "b", .start = {{1, 0.1}, 3.14159}, .goal = {}}};
  World world(scenario);
  for (int i = 0; i < 30; ++i)
    world.advance({{1.0, 0.0}, {1.0, 0.0}}, 0.1);
  EXPECT_TRUE(world.encounters()[0].collided);
  EXPECT_TRUE(world.encounters()[1].collided);
}

// The slow, obvious version looks at all pairs.
TEST(World, TheSeparationIsThatOfTheNearestRobot) {
  test::Random random(4);
  for (int trial = 0; trial < 40; ++trial) {
    Scenario scenario = open_floor();
    scenario.settings.robot.radius = random.uniform(0.1, 0.4);
    scenario.robots.clear();
    for (int i = 0; i < 8; ++i) {
      const Eigen::Vector2d place(random.uniform(-4.0, 4.0), random.uniform(-4.0, 4.0));
      scenario.robots.push_back({.name = std::to_string(i), .start = {place, 0.0}, .goal = {}});
    }
    const World world(scenario);
    for (std::size_t i = 0; i < 8; ++i) {
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t j = 0; j < 8; ++j) {
        const double between =
            (scenario.robots[i].start.position - scenario.robots[j].start.position).norm();
        const double radius = scenario.settings.robot.radius;
        if (i != j) nearest = std::min(nearest, std::max(0.0, between - radius) - radius);
      }
      ASSERT_NEAR(world.encounters()[i].min_separation, nearest, 1e-12);
    }
  }
}

TEST(World, PutsARobotOnlyWhereItTouchesNothing) {
  Scenario scenario = open_floor();
  scenario.map.set({130, 100}, CellState::Occupied);  // [1.5, 1.55] x [0, 0.05]
  scenario.robots = {{.name = "a", .start = {{-1, 0}, 0}, .goal = {}},
                     {.name = "b", .start = {{-3, 0}, 0}, .goal = {}}};
  World world(scenario);
  world.advance({{1.0, 0.0}, {}}, 0.5);
  EXPECT_FALSE(world.try_place(0, {{1.4, 0.0}, 0.0}));
  EXPECT_FALSE(world.try_place(0, {{-3.2, 0.0}, 0.0}));
  EXPECT_FALSE(world.try_place(0, {{std::nan(""), 0.0}, 0.0}));
  EXPECT_TRUE(world.try_place(0, {{1.0, 2.0}, 1.0}));
  EXPECT_EQ(world.robots()[0].pose.position, Eigen::Vector2d(1.0, 2.0));
  EXPECT_EQ(world.robots()[0].twist.linear, 0.0);
}

TEST(World, ReportsTheRobotsOwnSpeedAtAContact) {
  Scenario scenario = open_floor();
  scenario.robots = {{.name = "a", .start = {{0, 0}, 0}, .goal = {}}};
  MovingBody person;
  person.key_frames = {{0.0, {-3, 0}}, {3.0, {3, 0}}};
  scenario.bodies = {person};
  World standing(scenario);
  World leaving(scenario);
  World meeting(scenario);
  for (int i = 0; i < 30; ++i) {
    standing.advance({{0.0, 0.0}}, 0.1);
    leaving.advance({{0.5, 0.0}}, 0.1);
    meeting.advance({{-0.5, 0.0}}, 0.1);
  }
  ASSERT_TRUE(standing.encounters()[0].collided);
  EXPECT_EQ(standing.encounters()[0].approach, 0.0);
  ASSERT_TRUE(leaving.encounters()[0].collided);
  EXPECT_NEAR(leaving.encounters()[0].approach, -0.5, 1e-9);
  ASSERT_TRUE(meeting.encounters()[0].collided);
  EXPECT_NEAR(meeting.encounters()[0].approach, 0.5, 1e-9);
}

TEST(World, AnAbsentBodyIsNeitherSeenNorTouched) {
  Scenario scenario = open_floor();
  scenario.robots = {{.name = "a", .start = {{0, 0}, 0}, .goal = {}}};
  MovingBody person{.name = "p", .key_frames = {{1.0, {0, 0}}, {2.0, {1, 0}}}};
  person.passing = true;
  scenario.bodies = {person};
  World world(scenario);
  std::vector<MovingObstacle> seen;
  world.moving_bodies(seen);
  EXPECT_TRUE(seen.empty());
  world.advance({{0.0, 0.0}}, 0.5);
  EXPECT_FALSE(world.encounters()[0].collided);
  world.advance({{0.0, 0.0}}, 0.6);
  EXPECT_TRUE(world.encounters()[0].collided);
}

TEST(World, EveryRobotSeesAllOthersAndAllBodies) {
  Scenario scenario = open_floor();
  scenario.robots = {{.name = "a", .start = {{-1, 0}, 0}, .goal = {}},
                     {.name = "b", .start = {{1, 0}, 0}, .goal = {}}};
  MovingBody person;
  person.key_frames = {{0.0, {3, 3}}};
  scenario.bodies = {person};
  const World world(scenario);
  std::vector<MovingObstacle> seen;
  world.moving_around(0, seen);
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_EQ(seen[1].position, Eigen::Vector2d(1, 0));
}

TEST(World, AStartInsideAWallIsAContactFromTheBeginning) {
  Scenario scenario = open_floor();
  scenario.map.set({100, 100}, CellState::Occupied);
  scenario.robots = {{.name = "a", .start = {{0, 0}, 0}, .goal = {}}};
  EXPECT_TRUE(World(scenario).encounters()[0].collided);
}

}  // namespace
}  // namespace fairway
