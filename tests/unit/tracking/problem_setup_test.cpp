// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/problem_setup.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/mpc/evaluation.hpp"
#include "fairway/mpc/problem_from_settings.hpp"
#include "fairway/navigation/settings.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

TEST(ProblemSetup, IsValidAfterAnyPreviousCommand) {
  test::Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    Settings settings;
    settings.robot.linear_min = random.uniform(-0.5, 0.3);
    ControlProblem problem;
    set_from_settings(settings.mpc, settings.robot, {random.uniform(-3, 3), random.uniform(-5, 5)},
                      problem);
    EXPECT_EQ(validate(problem), ProblemFault::None);
  }
}

TEST(ProblemSetup, KeepsTheNearestObstaclesInOrderOfUrgency) {
  test::Random random(2);
  std::vector<MovingObstacle> obstacles;
  for (int i = 0; i < 60; ++i) {
    obstacles.push_back(
        {.position = {random.uniform(-9, 9), random.uniform(-9, 9)}, .radius = 0.3});
  }
  ControlProblem problem;
  set_predictions({}, {}, {.obstacles = obstacles, .age = 0.0, .fleet = {}}, {0, 0}, problem);
  ASSERT_EQ(problem.num_obstacles, kMaxObstacles);
  std::sort(obstacles.begin(), obstacles.end(),
            [](const auto& a, const auto& b) { return a.position.norm() < b.position.norm(); });
  for (std::size_t j = 0; j < kMaxObstacles; ++j) {
    EXPECT_EQ(problem.obstacles[j].position[0], obstacles[j].position);
  }
}

TEST(ProblemSetup, OldTracksAreExtrapolated) {
  const std::vector<MovingObstacle> one{{.position = {1, 0}, .velocity = {2, 0}, .radius = 0.3}};
  ControlProblem problem;
  problem.horizon = 10;
  problem.dt = 0.1;
  set_predictions({}, {}, {.obstacles = one, .age = 0.25, .fleet = {}}, {0, 0}, problem);
  EXPECT_NEAR(problem.obstacles[0].position[0].x(), 1.5, 1e-12);
  EXPECT_NEAR(problem.obstacles[0].position[10].x(), 3.5, 1e-12);
}

TEST(ProblemSetup, ATurnOnTheSpotEndsWithoutOscillation) {
  const RobotSettings limits;
  constexpr double kPeriod = 0.1;  // [s]
  for (const double turn : {3.0, -1.0, 0.3, 0.02}) {
    double rest = turn;
    double speed = 0.0;
    for (int i = 0; i < 200; ++i) {
      const double wanted = turning_speed(rest, limits, kPeriod);
      const double change = limits.angular_acceleration_max * kPeriod;
      speed += std::clamp(wanted - speed, -change, change);
      rest -= speed * kPeriod;
      EXPECT_GT(rest * turn, -0.05 * turn * turn) << "overshoot";
    }
    EXPECT_NEAR(rest, 0.0, 1e-3);
  }
}

}  // namespace
}  // namespace fairway
