// SPDX-License-Identifier: Apache-2.0
// Whole runs of a robot that knows only its lidar scans and odometry.
#include <gtest/gtest.h>

#include "fairway/simulation/episode.hpp"
#include "support/random/random_world.hpp"
#include "support/worlds/boxes.hpp"

namespace fairway {
namespace {

// A hall of 14 x 10 m with outer walls; the robot starts at the left with heading 0.
Scenario hall(std::uint64_t seed) {
  Scenario scenario;
  scenario.map = OccupancyGrid({.width = 280, .height = 200, .resolution = 0.05, .origin = {}});
  scenario.settings.robot = {.radius = 0.31, .length = 0.458, .width = 0.416};
  scenario.settings.robot.linear_max = 1.5;
  scenario.settings.robot.angular_max = 3.0;
  scenario.robots = {{.name = "robot",
                      .start = {.position = {1.5, 5.0}, .heading = 0.0},
                      .goal = {.position = {12.5, 5.0}, .heading = {}}}};
  scenario.sensing.sensing = Sensing::Lidar;
  use_standard_noise(scenario.sensing);
  scenario.time_limit = 60.0;
  scenario.seed = seed;
  return scenario;
}

void expect_arrival(const EpisodeResult& result, const Scenario& scenario) {
  EXPECT_FALSE(result.robots[0].collided);
  EXPECT_TRUE(result.robots[0].reached) << to_text(result.trace.rows.back().status);
  // Odometry errs by up to 1 % and 0.2 degrees per metre.
  const Eigen::Vector2d off =
      result.trace.rows.back().pose.position - scenario.robots[0].goal.position;
  EXPECT_LT(off.norm(), 1.0);
}

TEST(Mapless, CrossesAnUnknownFieldOfPosts) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Scenario scenario = hall(seed);
    test::Random random(seed);
    for (int i = 0; i < 25; ++i) {
      const double x = random.uniform(3.0, 11.0);
      const double y = random.uniform(0.5, 9.5);
      test::put_box(scenario.map, x, y, x + 0.15, y + 0.15);
    }
    SCOPED_TRACE(seed);
    expect_arrival(run_episode(scenario), scenario);
  }
}

TEST(Mapless, LeavesADeadEnd) {
  Scenario scenario = hall(1);
  // A pocket across the straight path, open towards the robot.
  test::put_box(scenario.map, 4.0, 3.0, 8.0, 3.1);
  test::put_box(scenario.map, 4.0, 6.9, 8.0, 7.0);
  test::put_box(scenario.map, 8.0, 3.0, 8.1, 7.0);
  expect_arrival(run_episode(scenario), scenario);
}

// A passage of twice 0.365 m, as narrow as BARN's, may shrink to 0.70 m when it becomes cells.
TEST(Mapless, PassesADoorAsNarrowAsBarns) {
  for (const Sensing sensing : {Sensing::Map, Sensing::Lidar}) {
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      Scenario scenario = hall(seed);
      scenario.sensing.sensing = sensing;
      const double low = 4.0 + 0.7 * static_cast<double>(seed);
      test::put_box(scenario.map, 6.0, 0.0, 6.39, low - 0.01);
      test::put_box(scenario.map, 6.0, low + 0.71, 6.39, 9.99);
      SCOPED_TRACE(seed);
      expect_arrival(run_episode(scenario), scenario);
    }
  }
}

// The wheels err by up to 3 % and 0.6 degrees per metre.
TEST(Mapless, ScansCorrectTheDriftOfTheWheels) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Scenario scenario = hall(seed);
    scenario.sensing.odometry.most_scale_error *= 3.0;
    scenario.sensing.odometry.most_drift *= 3.0;
    test::put_box(scenario.map, 5.0, 3.0, 5.5, 6.5);
    test::put_box(scenario.map, 8.0, 4.0, 8.5, 8.0);
    SCOPED_TRACE(seed);
    const EpisodeResult result = run_episode(scenario);
    EXPECT_TRUE(result.robots[0].reached);
    const Eigen::Vector2d off =
        result.trace.rows.back().pose.position - scenario.robots[0].goal.position;
    EXPECT_LT(off.norm(), scenario.settings.navigation.goal_tolerance + 0.1);
  }
}

TEST(Mapless, DoesNotMoveWithoutScans) {
  Scenario scenario = hall(1);
  scenario.sensing.lidar.latency = 100.0;  // no scan ever becomes available
  scenario.time_limit = 3.0;
  const EpisodeResult result = run_episode(scenario);
  EXPECT_EQ(result.robots[0].length, 0.0);
  EXPECT_EQ(result.trace.rows.back().status, NavigationStatus::Stale);
}

TEST(Mapless, SameSeedGivesTheSameBits) {
  Scenario scenario = hall(5);
  test::put_box(scenario.map, 5.0, 4.0, 5.2, 6.5);
  scenario.time_limit = 4.0;
  const EpisodeResult first = run_episode(scenario);
  const EpisodeResult second = run_episode(scenario);
  ASSERT_EQ(first.trace.rows.size(), second.trace.rows.size());
  for (std::size_t i = 0; i < first.trace.rows.size(); ++i)
    ASSERT_EQ(first.trace.rows[i].pose.position, second.trace.rows[i].pose.position);
}

}  // namespace
}  // namespace fairway
