// SPDX-License-Identifier: Apache-2.0
// Robots that know only their lidar, behind a person who blocks the only door for a while.
#include <string>

#include <gtest/gtest.h>

#include "fairway/simulation/episode.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

// Two rooms with one door, and a person in it, in a frame that is turned by `angle`.
struct DoorWorld {
  double door = 4.0;    // middle of the door along the wall [m]
  double width = 0.8;   // of the door [m]
  double leaves = 2.0;  // when the person leaves the door [s]
  Pose2 start{.position = {3.0, 4.0}, .heading = 0.0};
  Vector2d goal{9.0, 4.0};
  double angle = 0.0;  // of the map in the world [rad]
  bool noise = false;
  std::uint64_t seed = 1;
};

constexpr double kWall = 6.0;  // [m]
constexpr double kWalk = 4.0;  // time in which the person leaves the door [s]

Scenario scenario_of(const DoorWorld& world) {
  Scenario scenario;
  const Pose2 origin{.position = {1.0, -2.0}, .heading = world.angle};
  scenario.map = OccupancyGrid({.width = 240, .height = 160, .resolution = 0.05, .origin = origin});
  for (int y = 0; y < 160; ++y) {
    for (int x = 118; x < 122; ++x) {
      if (std::abs((y + 0.5) * 0.05 - world.door) > 0.5 * world.width)
        scenario.map.set({x, y}, CellState::Occupied);
    }
  }
  const auto place = [&](const Vector2d& p) { return transform(origin, p); };
  scenario.robots = {{.name = "robot",
                      .start = {.position = place(world.start.position),
                                .heading = world.angle + world.start.heading},
                      .goal = {.position = place(world.goal), .heading = {}}}};
  const double aside = world.door < 4.0 ? 7.0 : 1.0;  // out of the path to the goal
  scenario.bodies = {{.name = "person",
                      .radius = 0.3,
                      .key_frames = {{0.0, place({kWall, world.door})},
                                     {world.leaves, place({kWall, world.door})},
                                     {world.leaves + kWalk, place({9.0, world.door})},
                                     {world.leaves + 2.0 * kWalk, place({9.0, aside})}}}};
  scenario.sensing.sensing = Sensing::Lidar;
  if (world.noise) use_standard_noise(scenario.sensing);
  scenario.seed = world.seed;
  scenario.time_limit = world.leaves + kWalk + 60.0;
  return scenario;
}

void expect_arrival(const DoorWorld& world) {
  SCOPED_TRACE("door " + std::to_string(world.door) + ", width " + std::to_string(world.width) +
               ", leaves " + std::to_string(world.leaves) + ", start " +
               std::to_string(world.start.position.x()) + " " +
               std::to_string(world.start.position.y()) + " " +
               std::to_string(world.start.heading) + ", goal " + std::to_string(world.goal.x()) +
               " " + std::to_string(world.goal.y()) + ", angle " + std::to_string(world.angle) +
               ", seed " + std::to_string(world.seed));
  const EpisodeResult result = run_episode(scenario_of(world));
  EXPECT_FALSE(result.robots[0].collided);
  EXPECT_TRUE(result.robots[0].reached) << to_text(result.trace.rows.back().status);
}

TEST(LostPath, APersonWhoBlocksTheOnlyDoorForTwoSecondsLeavesNoWall) { expect_arrival({}); }

TEST(LostPath, TheRobotWaitsForAPersonWhoStaysLonger) {
  expect_arrival({.leaves = 25.0});
  expect_arrival({.leaves = 15.0, .start = {.position = {4.5, 4.0}, .heading = 0.0}});
}

TEST(LostPath, ArrivesInRandomRoomsWithADoorThatOpens) {
  test::Random random(5);
  for (int i = 0; i < 6; ++i) {
    DoorWorld world{.door = random.uniform(1.5, 6.5),
                    .width = random.uniform(0.8, 1.1),
                    .leaves = random.uniform(2.0, 20.0),
                    .start = {.position = {random.uniform(1.0, 4.5), random.uniform(1.0, 7.0)},
                              .heading = random.uniform(-3.1, 3.1)},
                    .goal = {random.uniform(7.5, 11.0), random.uniform(1.0, 7.0)},
                    .angle = random.uniform(-3.1, 3.1),
                    .noise = random.chance(0.5),
                    .seed = static_cast<std::uint64_t>(i)};
    expect_arrival(world);
  }
}

// A door that never opens: the robot does not end at the opposite wall, and says what is wrong.
TEST(LostPath, ReportsBlockedInAClosedRoom) {
  Scenario scenario = scenario_of({.leaves = 100.0});
  scenario.time_limit = 45.0;
  const EpisodeResult result = run_episode(scenario);
  EXPECT_FALSE(result.robots[0].collided);
  EXPECT_FALSE(result.robots[0].reached);
  EXPECT_GT(result.robots[0].status_counts[static_cast<std::size_t>(NavigationStatus::Blocked)],
            20);
}

}  // namespace
}  // namespace fairway
