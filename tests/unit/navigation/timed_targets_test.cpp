// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/timed_targets.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace fairway {
namespace {

using Eigen::Vector2d;

StringAhead make_string(std::initializer_list<Vector2d> points, bool ends_at_goal) {
  StringAhead string;
  for (const Vector2d& p : points) {
    const auto i = static_cast<std::size_t>(string.count++);
    string.points[i] = p;
    string.arc[i] = i == 0 ? 0.0 : string.arc[i - 1] + (p - string.points[i - 1]).norm();
  }
  string.ends_at_goal = ends_at_goal;
  return string;
}

std::size_t last(const ControlProblem& problem) {
  return static_cast<std::size_t>(problem.horizon);
}

TEST(TimedTargets, SpeedUpNoFasterThanTheLimitsAndStopAtTheGoal) {
  Settings settings;
  ControlProblem problem;
  problem.horizon = 50;
  set_timed_targets(make_string({{0, 0}, {2, 0}}, true), 0.0, 0.0, {}, settings, problem);
  double before = 0.0;
  double speed = 0.0;
  for (std::size_t k = 1; k <= last(problem); ++k) {
    const double s = problem.targets[k].position.x();
    const double v = (s - before) / settings.mpc.dt;
    EXPECT_LE(v, settings.mpc.linear_max + 1e-9);
    EXPECT_LE(v - speed, settings.mpc.linear_acceleration_max * settings.mpc.dt + 1e-9);
    EXPECT_GE(v, -1e-12);
    before = s;
    speed = v;
  }
  EXPECT_NEAR(before, 2.0, 1e-9) << "the last target is the goal";
}

TEST(TimedTargets, AtTheGoalTheGoalsHeadingWithoutALongTurn) {
  Settings settings;
  ControlProblem problem;
  problem.horizon = 50;
  set_timed_targets(make_string({{0, 0}, {1, 0}}, true), 0.5, 0.0, -3.0, settings, problem);
  EXPECT_NEAR(problem.targets[last(problem)].heading, -3.0, 1e-9);
  set_timed_targets(make_string({{0, 0}, {1, 0}}, true), 0.5, 0.0, {}, settings, problem);
  EXPECT_NEAR(problem.targets[last(problem)].heading, 0.0, 1e-9);
}

TEST(TimedTargets, SlowDownForASharpCornerOnly) {
  Settings settings;
  ControlProblem problem;
  problem.horizon = 50;
  const auto slowest = [&](const StringAhead& string) {
    set_timed_targets(string, 1.0, 0.0, {}, settings, problem);
    double least = 10.0;
    for (std::size_t k = 2; k <= 40; ++k) {
      least =
          std::min(least, (problem.targets[k].position - problem.targets[k - 1].position).norm());
    }
    return least / settings.mpc.dt;
  };
  EXPECT_GT(slowest(make_string({{0, 0}, {2, 0}, {9, 0.5}}, false)), 0.95);
  EXPECT_LT(slowest(make_string({{0, 0}, {2, 0}, {2, 9}}, false)), 0.7);
  EXPECT_LT(slowest(make_string({{0, 0}, {2, 0}, {0.1, 0.5}}, false)), 0.4);
}

TEST(TimedTargets, WaitWhileTheRobotLooksAway) {
  Settings settings;
  ControlProblem problem;
  problem.horizon = 20;
  set_timed_targets(make_string({{0, 0}, {5, 0}}, true), 0.0, std::numbers::pi - 0.01, {}, settings,
                    problem);
  EXPECT_EQ(problem.targets[5].position.x(), 0.0);
  EXPECT_GT(problem.targets[20].position.x(), 0.2);
  // The heading targets unwind the shorter way and stay within pi of the robot's heading.
  EXPECT_NEAR(problem.targets[1].heading, 0.0, 1e-9);
}

}  // namespace
}  // namespace fairway
