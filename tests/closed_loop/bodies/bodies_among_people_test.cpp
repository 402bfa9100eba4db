// SPDX-License-Identifier: Apache-2.0
// Robots of every outline and base among people who do not react: no contact in which the robot
// drove towards the person. A person who walks into a robot at standstill does not count.
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "fairway/map/body_clearance.hpp"
#include "fairway/map/distance_field.hpp"
#include "fairway/simulation/episode.hpp"
#include "support/random/random_world.hpp"
#include "support/worlds/robot_presets.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

constexpr double kTime = 40.0;  // [s]

enum class Walk { Straight, BackAndForth, Anywhere };

OccupancyGrid random_hall(test::Random& random) {
  OccupancyGrid map(GridFrame{.width = 240, .height = 180, .resolution = 0.05, .origin = {}});
  for (int i = random.integer(2, 6); i > 0; --i) {
    const int x = random.integer(0, 219);
    const int y = random.integer(0, 159);
    const int width = random.integer(3, 20);
    const int height = random.integer(3, 20);
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u)
        map.set({.x = x + u, .y = y + v}, CellState::Occupied);
    }
  }
  return map;
}

// A free pose; often one behind `before`, so that robots reverse.
Pose2 random_pose(test::Random& random, const BodyClearance& clearance, const Pose2* before) {
  constexpr double kClearance = 0.15;  // [m]
  const bool behind = before != nullptr && random.chance(0.5);
  for (int i = 0; i < 500; ++i) {
    Pose2 pose{.position = {random.uniform(1.0, 11.0), random.uniform(1.0, 8.0)},
               .heading = random.uniform(-3.1, 3.1)};
    if (behind && i < 50) {
      const Vector2d away(-random.uniform(2.0, 4.0), random.uniform(-0.7, 0.7));
      pose = {.position = transform(*before, away),
              .heading = before->heading + random.uniform(-0.3, 0.3)};
    }
    if (clearance.is_free(pose, kClearance)) return pose;
  }
  return {.position = {6.0, 4.5}, .heading = 0.0};
}

MovingBody random_person(test::Random& random, const RobotTask& robot, Walk walk) {
  MovingBody person{.name = "person", .radius = 0.3, .key_frames = {}};
  const double speed = random.uniform(0.2, 1.4);
  Vector2d at;
  do {
    at = {random.uniform(-1.0, 13.0), random.uniform(-1.0, 10.0)};
  } while (robot.model->body.distance(inverse_transform(robot.start, at)) < 1.0);
  person.key_frames.push_back({0.0, at});
  if (walk == Walk::Straight) {  // through a place near the robot's route
    const double share = random.uniform(0.0, 1.0);
    const Vector2d via = (1.0 - share) * robot.start.position + share * robot.goal.position +
                         Vector2d(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
    person.key_frames.push_back({kTime, at + kTime * speed * (via - at).normalized()});
    return person;
  }
  double time = 0.0;
  const Vector2d other(random.uniform(1.0, 11.0), random.uniform(1.0, 8.0));
  for (int i = 1; time < kTime; ++i) {
    const bool back_and_forth = walk == Walk::BackAndForth;
    const Vector2d from = person.key_frames.back().position;
    const Vector2d to = back_and_forth
                            ? (i % 2 == 1 ? other : at)
                            : Vector2d(random.uniform(0.0, 12.0), random.uniform(0.0, 9.0));
    time += std::max(0.3, (to - from).norm() / (back_and_forth ? speed : random.uniform(0.2, 1.4)));
    person.key_frames.push_back({time, to});
    if (back_and_forth || !random.chance(0.4)) continue;
    time += random.uniform(0.5, 6.0);
    person.key_frames.push_back({time, to});
  }
  return person;
}

Scenario random_scenario(std::uint64_t seed, const RobotModel& model, Walk walk) {
  test::Random random(seed);
  Scenario scenario;
  scenario.map = random_hall(random);
  scenario.time_limit = kTime;
  const BitGrid obstacles(scenario.map);
  const DistanceField distances(obstacles);
  const BodyClearance clearance(obstacles, distances, model.body);
  RobotTask robot{.name = "robot", .start = random_pose(random, clearance, nullptr), .goal = {}};
  const Pose2 goal = random_pose(random, clearance, &robot.start);
  robot.goal = {.position = goal.position, .heading = goal.heading};
  robot.model = model;
  scenario.robots = {robot};
  for (int i = random.integer(1, 4); i > 0; --i)
    scenario.bodies.push_back(random_person(random, robot, walk));
  return scenario;
}

// How long ago the nearest person changed its velocity [s].
double since_turn(const Scenario& scenario, const Vector2d& robot, double time) {
  const MovingBody* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const MovingBody& body : scenario.bodies) {
    const double away = (body.at(time).position - robot).norm();
    if (away < least) nearest = &body;
    least = std::min(least, away);
  }
  double last = 0.0;
  for (const MovingBody::KeyFrame& frame : nearest->key_frames) {
    if (frame.time <= time) last = frame.time;
  }
  return time - last;
}

double speed_of(const TraceRow& row) { return std::abs(row.command.linear); }

// A robot cannot foresee that a person turns: it has to brake from then on.
bool brakes_since(const Scenario& scenario, const Trace& trace, double seconds) {
  constexpr double kReaction = 0.15;  // one control period, and what is left of the one before [s]
  const BaseModel& base = scenario.robots[0].model->base;
  const TraceRow& last = trace.rows.back();
  for (const TraceRow& row : trace.rows) {
    const double ago = last.time - row.time;
    if (ago > seconds - kReaction) continue;
    return speed_of(last) <=
           std::max(0.0, speed_of(row) - 0.7 * base.linear_acceleration * ago) + 0.05;
  }
  return true;
}

void expect_no_contact_by_driving(Walk walk, std::uint64_t seeds) {
  int reached = 0;
  const auto robots = test::robot_presets();
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const test::NamedRobot& robot = robots[seed % robots.size()];
    const Scenario scenario = random_scenario(seed, robot.model, walk);
    const EpisodeResult result = run_episode(scenario);
    const RobotResult& run = result.robots[0];
    reached += run.reached ? 1 : 0;
    if (!run.collided) continue;
    SCOPED_TRACE(std::string(robot.name) + ", seed " + std::to_string(seed));
    EXPECT_GE(run.min_clearance, 0.0) << "touched a wall";
    // People who walk straight are foreseen to the millimetre; those who turn leave a cycle less.
    const double stopped = walk == Walk::Straight ? 1e-3 : 0.1;  // [m/s]
    if (run.approach <= stopped) continue;
    EXPECT_EQ(walk, Walk::Anywhere) << run.approach << " m/s towards a person";
    const double ago =
        since_turn(scenario, result.trace.rows.back().pose.position, result.trace.rows.back().time);
    EXPECT_TRUE(brakes_since(scenario, result.trace, ago))
        << run.approach << " m/s towards a person who turned " << ago << " s before";
    const BaseModel& base = robot.model.base;
    const double fastest = std::max({base.linear_max, -base.linear_min, base.lateral_max});
    EXPECT_LT(ago, fastest / base.linear_acceleration + 0.2) << run.approach << " m/s";
  }
  EXPECT_GT(reached, static_cast<int>(seeds) / 4);
}

TEST(BodiesAmongPeople, PeopleWhoWalkStraight) { expect_no_contact_by_driving(Walk::Straight, 32); }

TEST(BodiesAmongPeople, PeopleWhoWalkBackAndForth) {
  expect_no_contact_by_driving(Walk::BackAndForth, 32);
}

TEST(BodiesAmongPeople, PeopleWhoWalkAnywhereAndStop) {
  expect_no_contact_by_driving(Walk::Anywhere, 32);
}

// A person walks along the middle of a hall, straight at the robot, and never looks. There is space
// beside the person, so the robot moves out of the way.
TEST(BodiesAmongPeople, GiveWayToAPersonWhoWalksStraightAtThem) {
  for (const test::NamedRobot& robot : test::robot_presets()) {
    SCOPED_TRACE(robot.name);
    Scenario scenario;
    scenario.map =
        OccupancyGrid(GridFrame{.width = 400, .height = 100, .resolution = 0.05, .origin = {}});
    scenario.time_limit = kTime;
    RobotTask task{.name = "robot",
                   .start = {.position = {4.0, 2.5}, .heading = 0.0},
                   .goal = {.position = {16.0, 2.5}, .heading = {}}};
    task.model = robot.model;
    scenario.robots = {task};
    scenario.bodies = {
        {.name = "person", .radius = 0.3, .key_frames = {{0.0, {16.0, 2.5}}, {15.0, {1.0, 2.5}}}}};
    const EpisodeResult result = run_episode(scenario);
    const RobotResult& run = result.robots[0];
    EXPECT_FALSE(run.collided) << run.approach << " m/s at " << run.time << " s";
    EXPECT_TRUE(run.reached);
  }
}

// A person walks slowly along the middle of a hall, in the direction of the robot. There is space
// to both sides, so the robot overtakes: behind the person it would need 58 s.
TEST(BodiesAmongPeople, OvertakeAPersonWhoWalksSlowlyAhead) {
  for (const test::NamedRobot& robot : test::robot_presets()) {
    SCOPED_TRACE(robot.name);
    Scenario scenario;
    scenario.map =
        OccupancyGrid(GridFrame{.width = 400, .height = 140, .resolution = 0.05, .origin = {}});
    scenario.time_limit = 60.0;
    RobotTask task{.name = "robot",
                   .start = {.position = {3.0, 3.5}, .heading = 0.0},
                   .goal = {.position = {17.0, 3.5}, .heading = 0.0}};
    task.model = robot.model;
    scenario.robots = {task};
    scenario.bodies = {
        {.name = "person", .radius = 0.3, .key_frames = {{0.0, {6.5, 3.5}}, {60.0, {18.5, 3.5}}}}};
    const EpisodeResult result = run_episode(scenario);
    const RobotResult& run = result.robots[0];
    EXPECT_FALSE(run.collided) << run.approach << " m/s at " << run.time << " s";
    EXPECT_TRUE(run.reached);
    EXPECT_LT(run.time, 35.0);
  }
}

}  // namespace
}  // namespace fairway
