// SPDX-License-Identifier: Apache-2.0
// Whole runs of a robot in a known map whose pose comes from lidar scans and odometry.
#include <algorithm>

#include <gtest/gtest.h>

#include "fairway/simulation/episode.hpp"
#include "support/random/random_world.hpp"
#include "support/worlds/boxes.hpp"

namespace fairway {
namespace {

// A hall of 14 m x 10 m with posts and walls, and `factor` times the standard noise.
Scenario hall(std::uint64_t seed, double factor) {
  Scenario scenario;
  scenario.map = OccupancyGrid({.width = 280, .height = 200, .resolution = 0.05, .origin = {}});
  test::put_box(scenario.map, 0.01, 0.01, 13.99, 0.05);
  test::put_box(scenario.map, 0.01, 9.95, 13.99, 9.99);
  test::put_box(scenario.map, 0.01, 0.01, 0.05, 9.99);
  test::put_box(scenario.map, 13.95, 0.01, 13.99, 9.99);
  test::Random random(seed);
  for (int i = 0; i < 25; ++i) {
    const double x = random.uniform(3.0, 11.0);
    const double y = random.uniform(0.5, 9.5);
    test::put_box(scenario.map, x, y, x + 0.15, y + 0.15);
  }
  scenario.robots = {{.name = "robot",
                      .start = {.position = {1.5, 5.0}, .heading = 0.0},
                      .goal = {.position = {12.5, 5.0}, .heading = {}}}};
  scenario.sensing.pose = PoseSource::Scans;
  use_standard_noise(scenario.sensing);
  scenario.sensing.lidar.range_sigma *= factor;
  scenario.sensing.lidar.dropout *= factor;
  scenario.sensing.odometry.most_scale_error *= factor;
  scenario.sensing.odometry.most_drift *= factor;
  scenario.time_limit = 60.0;
  scenario.seed = seed;
  return scenario;
}

TEST(Located, ARobotArrivesExactlyWithItsPoseFromScans) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Scenario scenario = hall(seed, seed % 2 == 0 ? 3.0 : 1.0);
    SCOPED_TRACE(seed);
    const EpisodeResult result = run_episode(scenario);
    EXPECT_FALSE(result.robots[0].collided);
    EXPECT_TRUE(result.robots[0].reached) << to_text(result.trace.rows.back().status);
    const Eigen::Vector2d off =
        result.trace.rows.back().pose.position - scenario.robots[0].goal.position;
    constexpr double kError = 0.05;  // [m]
    EXPECT_LT(off.norm(), scenario.settings.navigation.goal_tolerance + kError);
  }
}

TEST(Located, WithoutScansTheSameRobotIsLost) {
  double furthest = 0.0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Scenario scenario = hall(seed, 3.0);
    scenario.sensing.lidar.dropout = 1.0;
    const EpisodeResult result = run_episode(scenario);
    const Eigen::Vector2d off =
        result.trace.rows.back().pose.position - scenario.robots[0].goal.position;
    furthest = std::max(furthest, off.norm());
  }
  EXPECT_GT(furthest, 0.3) << "then the test above shows nothing";
}

}  // namespace
}  // namespace fairway
