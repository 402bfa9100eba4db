// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/initial_guess.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/random/random_control_problem.hpp"

namespace fairway {
namespace {

constexpr double kRounding = 1e-12;

// A problem with change limits, and a previous command that may be outside its range. The limits of
// a robot may have been lowered while it drives.
ControlProblem random_problem(test::Random& random) {
  ControlProblem problem = test::random_control_problem(random, {.max_horizon = kMaxHorizon});
  problem.max_change = {.linear = random.uniform(0.05, 0.4), .angular = random.uniform(0.1, 0.8)};
  problem.previous_command = {.linear = random.uniform(-1.0, 2.0),
                              .angular = random.uniform(-3.0, 3.0)};
  return problem;
}

// A plan of any commands, also such that the problem does not permit.
MpcSolution random_plan(test::Random& random) {
  MpcSolution plan;
  plan.horizon = random.integer(1, kMaxHorizon);
  for (Twist2& command : plan.commands)
    command = {.linear = random.uniform(-2.0, 2.0), .angular = random.uniform(-4.0, 4.0)};
  return plan;
}

// The distance of a value beyond the range that the change limit leaves reachable.
double excess(double value, double before, double low, double high, double change) {
  const double reachable_low = std::max(low, before - change);
  const double reachable_high = std::min(high, before + change);
  if (reachable_low > reachable_high) {  // the range itself cannot be reached in one step
    return std::abs(value - (before < low ? before + change : before - change));
  }
  return std::max({0.0, reachable_low - value, value - reachable_high});
}

void expect_within_limits(const ControlProblem& problem, const GuessedMotion& motion) {
  ASSERT_EQ(motion.guess.count, problem.horizon);
  Twist2 before = problem.previous_command;
  for (std::size_t k = 0; k < static_cast<std::size_t>(problem.horizon); ++k) {
    const Twist2& now = motion.guess.commands[k];
    EXPECT_LE(excess(now.linear, before.linear, problem.command_min.linear,
                     problem.command_max.linear, problem.max_change.linear),
              kRounding);
    EXPECT_LE(excess(now.angular, before.angular, problem.command_min.angular,
                     problem.command_max.angular, problem.max_change.angular),
              kRounding);
    before = now;
  }
}

void expect_rollout(const ControlProblem& problem, const GuessedMotion& motion) {
  Pose2 pose = problem.start;
  for (std::size_t k = 0;; ++k) {
    EXPECT_EQ(motion.poses[k].position, pose.position);
    EXPECT_EQ(motion.poses[k].heading, pose.heading);
    if (k == static_cast<std::size_t>(problem.horizon)) return;
    pose = step(pose, motion.guess.commands[k], problem.dt, problem.integration);
  }
}

TEST(ShiftedGuess, KeepsTheLimitsWhateverThePlanWas) {
  test::Random random(1);
  for (int trial = 0; trial < 300; ++trial) {
    const ControlProblem problem = random_problem(random);
    expect_within_limits(problem,
                         shifted_guess(problem, random_plan(random), random.uniform(0.01, 0.5)));
  }
}

TEST(ShiftedGuess, ItsPosesFollowFromItsCommands) {
  test::Random random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const ControlProblem problem = random_problem(random);
    expect_rollout(problem, shifted_guess(problem, random_plan(random), problem.dt));
  }
}

// A plan that obeys the limits of the problem from its first command on.
MpcSolution gentle_plan(const ControlProblem& problem) {
  MpcSolution plan;
  plan.horizon = problem.horizon;
  for (int k = 0; k < plan.horizon; ++k) {
    plan.commands[static_cast<std::size_t>(k)] = {.linear = 0.4 + 0.01 * k,
                                                  .angular = 0.5 - 0.02 * k};
  }
  return plan;
}

ControlProblem after(const MpcSolution& plan) {
  ControlProblem problem;
  problem.horizon = 10;
  problem.max_change = {.linear = 0.05, .angular = 0.1};
  problem.previous_command = plan.commands[0];
  return problem;
}

TEST(ShiftedGuess, ByOneStepIsTheRestOfThePlanAndItsLastCommandAgain) {
  const MpcSolution plan = gentle_plan({});
  const ControlProblem problem = after(plan);
  const GuessedMotion motion = shifted_guess(problem, plan, problem.dt);
  for (std::size_t k = 0; k < 10; ++k) {
    const Twist2& expected = plan.commands[std::min<std::size_t>(k + 1, 9)];
    EXPECT_EQ(motion.guess.commands[k].linear, expected.linear) << k;
    EXPECT_EQ(motion.guess.commands[k].angular, expected.angular) << k;
  }
}

TEST(ShiftedGuess, ByHalfAStepIsBetweenTwoCommands) {
  const MpcSolution plan = gentle_plan({});
  const ControlProblem problem = after(plan);
  const GuessedMotion motion = shifted_guess(problem, plan, 0.5 * problem.dt);
  for (std::size_t k = 0; k < 9; ++k) {
    EXPECT_NEAR(motion.guess.commands[k].linear,
                0.5 * (plan.commands[k].linear + plan.commands[k + 1].linear), kRounding);
    EXPECT_NEAR(motion.guess.commands[k].angular,
                0.5 * (plan.commands[k].angular + plan.commands[k + 1].angular), kRounding);
  }
  EXPECT_EQ(motion.guess.commands[9].linear, plan.commands[9].linear);
}

TEST(PursuitGuess, KeepsTheLimits) {
  test::Random random(3);
  for (int trial = 0; trial < 300; ++trial) {
    const ControlProblem problem = random_problem(random);
    expect_within_limits(problem, pursuit_guess(problem));
  }
}

TEST(PursuitGuess, ItsPosesFollowFromItsCommands) {
  test::Random random(4);
  for (int trial = 0; trial < 100; ++trial) {
    const ControlProblem problem = random_problem(random);
    expect_rollout(problem, pursuit_guess(problem));
  }
}

// Targets that move along a line from the start at 0.5 m/s, in direction `bearing` of the robot.
ControlProblem targets_along(const Pose2& start, double bearing) {
  ControlProblem problem;
  problem.horizon = 40;
  problem.start = start;
  problem.max_change = {.linear = 0.2, .angular = 0.4};
  const double heading = start.heading + bearing;
  for (int k = 1; k <= problem.horizon; ++k) {
    problem.targets[static_cast<std::size_t>(k)] = {
        .position = start.position + 0.5 * problem.dt * k * direction(heading), .heading = heading};
  }
  return problem;
}

// The targets end 2 m from the start. The aim is four steps ahead, which are 0.2 m here, and a turn
// on the spot takes time.
TEST(PursuitGuess, CatchesUpWithTargetsInAnyDirection) {
  test::Random random(5);
  for (int trial = 0; trial < 100; ++trial) {
    const ControlProblem problem = targets_along(
        {.position = test::random_point(random, 10.0), .heading = random.uniform(-3.0, 3.0)},
        random.uniform(-std::numbers::pi, std::numbers::pi));
    const GuessedMotion motion = pursuit_guess(problem);
    const auto last = static_cast<std::size_t>(problem.horizon);
    EXPECT_LT((motion.poses[last].position - problem.targets[last].position).norm(), 0.5);
  }
}

TEST(PursuitGuess, DoesNotDriveWhileItsAimIsBehind) {
  const ControlProblem problem = targets_along({}, 2.8);
  const GuessedMotion motion = pursuit_guess(problem);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(motion.guess.commands[k].linear, 0.0) << k;
    EXPECT_GT(motion.guess.commands[k].angular, 0.0) << "the shorter turn";
  }
}

// A robot and an obstacle on one line make a problem symmetric; a guess without a turn stays so.
TEST(PursuitGuess, LeansToOneSideOnAStraightLine) {
  const GuessedMotion motion = pursuit_guess(targets_along({}, 0.0));
  EXPECT_NE(motion.guess.commands[0].angular, 0.0);
  EXPECT_NE(motion.poses[40].position.y(), 0.0);
  EXPECT_LT(std::abs(motion.poses[40].position.y()), 0.05);
}

}  // namespace
}  // namespace fairway
