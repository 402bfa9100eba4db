// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/timed_targets.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "fairway/navigation/settings.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

ReferencePath make_path(std::initializer_list<Vector2d> points, bool ends_at_goal) {
  ReferencePath path;
  for (const Vector2d& p : points) {
    const auto i = static_cast<std::size_t>(path.count++);
    path.points[i] = p;
    path.arc[i] = i == 0 ? 0.0 : path.arc[i - 1] + (p - path.points[i - 1]).norm();
  }
  path.ends_at_goal = ends_at_goal;
  return path;
}

std::size_t last(const ControlProblem& problem) {
  return static_cast<std::size_t>(problem.horizon);
}

void set_targets(const ReferencePath& path,
                 TargetStart start,
                 const Settings& settings,
                 ControlProblem& problem) {
  start.lead = settings.safety.actuation_lag * settings.navigation.control_period;
  set_timed_targets(path, start, settings.tracking, settings.mpc, settings.robot, problem);
}

TEST(TimedTargets, AccelerateWithinTheLimitsAndStopAtTheGoal) {
  Settings settings;
  ControlProblem problem;
  problem.horizon = 50;
  set_targets(make_path({{0, 0}, {2, 0}}, true), {}, settings, problem);
  double before = 0.0;
  double speed = 0.0;
  for (std::size_t k = 1; k <= last(problem); ++k) {
    const double s = problem.targets[k].position.x();
    const double v = (s - before) / settings.mpc.step_length;
    EXPECT_LE(v, settings.robot.linear_max + 1e-9);
    EXPECT_LE(v - speed, settings.robot.linear_acceleration_max * settings.mpc.step_length + 1e-9);
    EXPECT_GE(v, -1e-12);
    before = s;
    speed = v;
  }
  EXPECT_NEAR(before, 2.0, 1e-9) << "the last target is the goal";
}

TEST(TimedTargets, ReachTheGoalsHeadingByTheShorterTurn) {
  Settings settings;
  ControlProblem problem;
  problem.horizon = 50;
  set_targets(make_path({{0, 0}, {1, 0}}, true), {.speed = 0.5, .goal_heading = -3.0}, settings,
              problem);
  EXPECT_NEAR(problem.targets[last(problem)].heading, -3.0, 1e-9);
  set_targets(make_path({{0, 0}, {1, 0}}, true), {.speed = 0.5}, settings, problem);
  EXPECT_NEAR(problem.targets[last(problem)].heading, 0.0, 1e-9);
}

TEST(TimedTargets, SlowDownForASharpCornerOnly) {
  Settings settings;
  ControlProblem problem;
  problem.horizon = 50;
  const auto slowest = [&](const ReferencePath& path) {
    set_targets(path, {.speed = 1.0}, settings, problem);
    double least = 10.0;
    for (std::size_t k = 2; k <= 40; ++k) {
      least =
          std::min(least, (problem.targets[k].position - problem.targets[k - 1].position).norm());
    }
    return least / settings.mpc.step_length;
  };
  EXPECT_GT(slowest(make_path({{0, 0}, {2, 0}, {9, 0.5}}, false)), 0.95);
  EXPECT_LT(slowest(make_path({{0, 0}, {2, 0}, {2, 9}}, false)), 0.7);
  EXPECT_LT(slowest(make_path({{0, 0}, {2, 0}, {0.1, 0.5}}, false)), 0.4);
}

// Also a robot that is slower than the least speed at corners.
TEST(TimedTargets, AreNeverFasterThanTheRobot) {
  for (const double fastest : {0.01, 0.05, 0.09, 0.3}) {
    Settings settings;
    settings.robot.linear_max = fastest;
    ControlProblem problem;
    problem.horizon = 50;
    const TargetStart start{.speed = fastest};
    set_targets(make_path({{0, 0}, {0.05, 0}, {0.05, 0.05}, {0, 0.05}, {0, 1}}, true), start,
                settings, problem);
    Vector2d before = problem.targets[1].position;  // which is a lead further
    for (std::size_t k = 2; k <= last(problem); ++k) {
      const Vector2d now = problem.targets[k].position;
      EXPECT_LE((now - before).norm(), fastest * settings.mpc.step_length + 1e-9) << fastest;
      before = now;
    }
  }
}

TEST(TimedTargets, WaitWhileTheRobotFacesAway) {
  Settings settings;
  ControlProblem problem;
  problem.horizon = 20;
  set_targets(make_path({{0, 0}, {5, 0}}, true), {.heading = std::numbers::pi - 0.01}, settings,
              problem);
  EXPECT_EQ(problem.targets[5].position.x(), 0.0);
  EXPECT_GT(problem.targets[20].position.x(), 0.2);
  // The heading targets turn the shorter way and stay within pi of the robot's heading.
  EXPECT_NEAR(problem.targets[1].heading, 0.0, 1e-9);
}

}  // namespace
}  // namespace fairway
