// SPDX-License-Identifier: Apache-2.0
// Whole runs in random worlds: the robot arrives where a path exists, has no contact, keeps every
// limit, and repeats the run exactly.
#include <cmath>

#include <gtest/gtest.h>

#include "fairway/simulation/episode.hpp"
#include "support/random/free_poses.hpp"

namespace fairway {
namespace {

std::optional<Scenario> random_scenario(std::uint64_t seed) {
  test::Random random(seed);
  Scenario scenario;
  scenario.map = test::random_world(random, 220);
  scenario.settings.robot.radius = random.uniform(0.1, 0.35);
  scenario.time_limit = 120.0;
  const BitGrid obstacles(scenario.map);
  const auto start =
      test::random_free_pose(random, obstacles, scenario.settings.robot.radius + 0.05);
  const auto goal =
      test::random_free_pose(random, obstacles, scenario.settings.robot.radius + 0.05);
  if (!start || !goal) return std::nullopt;
  RobotTask task{
      .name = "robot", .start = *start, .goal = {.position = goal->position, .heading = {}}};
  if (random.chance(0.5)) task.goal.heading = goal->heading;
  scenario.robots = {task};
  return scenario;
}

void expect_limits_kept(const Scenario& scenario, const Trace& trace) {
  const RobotSettings& robot = scenario.settings.robot;
  const double period = scenario.settings.navigation.control_period;
  Twist2 before;
  for (const TraceRow& row : trace.rows) {
    ASSERT_TRUE(is_finite(row.command));
    EXPECT_LE(row.command.linear, robot.linear_max + 1e-9);
    EXPECT_GE(row.command.linear, robot.linear_min - 1e-9);
    EXPECT_LE(std::abs(row.command.angular), robot.angular_max + 1e-9);
    EXPECT_LE(std::abs(row.command.linear - before.linear),
              robot.linear_acceleration_max * period + 1e-9);
    EXPECT_LE(std::abs(row.command.angular - before.angular),
              robot.angular_acceleration_max * period + 1e-9);
    before = row.command;
  }
}

TEST(RandomWorlds, ArrivesWithoutContactWhereAPathExists) {
  int driven = 0;
  int without_plan = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const std::optional<Scenario> scenario = random_scenario(seed);
    if (!scenario) continue;
    SCOPED_TRACE("seed " + std::to_string(seed));
    const EpisodeResult result = run_episode(*scenario);
    const RobotResult& robot = result.robots.front();
    EXPECT_FALSE(robot.collided);
    expect_limits_kept(*scenario, result.trace);
    if (!robot.plan.usable()) {
      ++without_plan;
      continue;
    }
    ++driven;
    EXPECT_TRUE(robot.reached) << "after " << robot.time << " s at ("
                               << result.trace.rows.back().pose.position.transpose() << "), goal ("
                               << scenario->robots[0].goal.position.transpose() << "), status "
                               << to_text(result.trace.rows.back().status) << ", limit "
                               << to_text(result.trace.rows.back().limit);
  }
  EXPECT_GT(driven, 30) << without_plan << " without a plan";
}

TEST(RandomWorlds, TheSameScenarioGivesTheSameBits) {
  const std::optional<Scenario> scenario = random_scenario(3);
  ASSERT_TRUE(scenario);
  const EpisodeResult a = run_episode(*scenario);
  const EpisodeResult b = run_episode(*scenario);
  ASSERT_EQ(a.trace.rows.size(), b.trace.rows.size());
  for (std::size_t i = 0; i < a.trace.rows.size(); ++i) {
    EXPECT_EQ(a.trace.rows[i].command.linear, b.trace.rows[i].command.linear);
    EXPECT_EQ(a.trace.rows[i].command.angular, b.trace.rows[i].command.angular);
  }
}

}  // namespace
}  // namespace fairway
