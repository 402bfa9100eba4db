// SPDX-License-Identifier: Apache-2.0
// Provokes every status of a solve, and extreme situations.
#include <cmath>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "fairway/mpc/evaluation.hpp"
#include "fairway/mpc/interior_point/solver.hpp"
#include "support/random/random_control_problem.hpp"

namespace fairway {
namespace {

// The robot at the origin, facing a target 2 m ahead, in a corridor of 1 m to each side.
ControlProblem straight_ahead(int horizon = 10) {
  ControlProblem problem;
  problem.horizon = horizon;
  for (std::size_t k = 1; k <= static_cast<std::size_t>(horizon); ++k) {
    problem.targets[k] = {.position = {2.0, 0.0}, .heading = 0.0, .weight = {20.0, 20.0, 0.1}};
    problem.regions[k].count = 1;
    problem.regions[k].rectangles[0] = {
        .seed = {0.0, 0.0}, .orientation = 0.0, .min = {-1.0, -1.0}, .max = {3.0, 1.0}};
  }
  return problem;
}

void put_obstacle(ControlProblem& problem, const Eigen::Vector2d& center, double keep_out) {
  PredictedObstacle& obstacle =
      problem.obstacles[static_cast<std::size_t>(problem.num_obstacles++)];
  obstacle.position.fill(center);
  obstacle.keep_out.fill(keep_out);
}

class InteriorPointStatus : public testing::Test {
 protected:
  const MpcSolution& solve(const ControlProblem& problem,
                           const InteriorPointSettings& settings = {}) {
    return solver_->solve(problem, {}, settings);
  }
  std::unique_ptr<InteriorPointSolver> solver_ = std::make_unique<InteriorPointSolver>();
};

TEST_F(InteriorPointStatus, SolvedWhenAllConstraintsHold) {
  const MpcSolution& solution = solve(straight_ahead());
  EXPECT_EQ(solution.status, SolveStatus::Solved);
  EXPECT_EQ(solution.max_violation, 0.0);
  EXPECT_NEAR(solution.commands[0].linear, 1.0, 1e-5);
  EXPECT_NEAR(solution.commands[0].angular, 0.0, 1e-5);
  EXPECT_EQ(solution.limiting.kind, ConstraintKind::LinearSpeed);
}

TEST_F(InteriorPointStatus, LeastViolationWhenTheStartIsOutsideItsRectangle) {
  ControlProblem problem = straight_ahead();
  problem.start.position = {-2.0, 0.0};  // 1 m behind, reached after the horizon
  const MpcSolution& solution = solve(problem);
  EXPECT_EQ(solution.status, SolveStatus::LeastViolation);
  EXPECT_EQ(solution.limiting.kind, ConstraintKind::Corridor);
  EXPECT_NEAR(solution.poses[10].position.x(), -1.0, 1e-4) << "straight to it at full speed";
  EXPECT_NEAR(solution.max_violation, 0.9, 1e-4);
}

TEST_F(InteriorPointStatus, LeastViolationInsideAKeepOutDisc) {
  ControlProblem problem = straight_ahead();
  put_obstacle(problem, {-0.3, 0.0}, 2.0);
  const MpcSolution& solution = solve(problem);
  EXPECT_EQ(solution.status, SolveStatus::LeastViolation);
  EXPECT_EQ(solution.limiting.kind, ConstraintKind::Barrier);
  EXPECT_GT(solution.poses[10].position.x(), 0.99) << "drives out of it at full speed";
}

TEST_F(InteriorPointStatus, LeastViolationForAnEmptyRectangle) {
  ControlProblem problem = straight_ahead();
  for (StepRegion& region : problem.regions) {
    region.rectangles[0].min.x() = 1.0;
    region.rectangles[0].max.x() = 0.5;
  }
  EXPECT_EQ(solve(problem).status, SolveStatus::LeastViolation);
}

TEST_F(InteriorPointStatus, LeastViolationWhenThePreviousCommandIsTooFast) {
  ControlProblem problem = straight_ahead();
  problem.previous_command.linear = 1.55;
  problem.max_change.linear = 0.1;
  const MpcSolution& solution = solve(problem);
  EXPECT_EQ(solution.status, SolveStatus::LeastViolation);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_NEAR(solution.commands[k].linear, 1.45 - 0.1 * static_cast<double>(k), 1e-12)
        << "the change bound takes precedence";
  }
  for (std::size_t k = 5; k < 10; ++k)
    EXPECT_LE(solution.commands[k].linear, 1.0);
}

TEST_F(InteriorPointStatus, BrakesAtTheLimitWhenItCannotStop) {
  ControlProblem problem = straight_ahead(5);
  problem.stop_at_end = true;
  problem.previous_command.linear = 1.0;
  problem.max_change.linear = 0.125;
  const MpcSolution& solution = solve(problem);
  EXPECT_EQ(solution.status, SolveStatus::LeastViolation);
  for (std::size_t k = 0; k < 5; ++k)
    EXPECT_EQ(solution.commands[k].linear, 1.0 - 0.125 * static_cast<double>(k + 1));
}

TEST_F(InteriorPointStatus, StopsAtTheEnd) {
  ControlProblem problem = straight_ahead();
  problem.stop_at_end = true;
  problem.previous_command.linear = 1.0;
  problem.max_change.linear = 0.2;
  const MpcSolution& solution = solve(problem);
  EXPECT_EQ(solution.status, SolveStatus::Solved);
  EXPECT_EQ(solution.commands[9].linear, 0.0);
  EXPECT_EQ(solution.commands[9].angular, 0.0);
  EXPECT_GT(solution.commands[4].linear, 0.9);
}

TEST_F(InteriorPointStatus, SolvesWithoutFreeCommands) {
  ControlProblem problem = straight_ahead();
  problem.max_change = {.linear = 0.0, .angular = 0.0};
  problem.previous_command = {.linear = 0.5, .angular = 0.25};
  const MpcSolution& solution = solve(problem);
  EXPECT_EQ(solution.status, SolveStatus::Solved);
  for (std::size_t k = 0; k < 10; ++k) {
    EXPECT_EQ(solution.commands[k].linear, 0.5);
    EXPECT_EQ(solution.commands[k].angular, 0.25);
  }
}

TEST_F(InteriorPointStatus, SolvesWithoutAnyWeight) {
  ControlProblem problem = straight_ahead();
  for (StepTarget& target : problem.targets)
    target.weight.setZero();
  problem.command_weight.setZero();
  problem.change_weight.setZero();
  EXPECT_EQ(solve(problem).status, SolveStatus::Solved);
}

TEST_F(InteriorPointStatus, IterationLimitGivesAResultNoWorseThanTheGuess) {
  ControlProblem problem = straight_ahead();
  put_obstacle(problem, {1.0, 0.05}, 0.7);
  InteriorPointSettings settings;
  double before = std::numeric_limits<double>::infinity();
  for (settings.max_iterations = 0; settings.max_iterations < 4; ++settings.max_iterations) {
    const MpcSolution& solution = solve(problem, settings);
    EXPECT_EQ(solution.status, SolveStatus::IterationLimit);
    EXPECT_EQ(solution.iterations, settings.max_iterations);
    EXPECT_EQ(bound_violation(problem, solution.commands).max, 0.0);
    const double merit = solution.cost + problem.violation_weight * solution.sum_violation;
    if (settings.max_iterations == 0) before = merit;
    EXPECT_LE(merit, before);
  }
}

TEST_F(InteriorPointStatus, StalledWhenTheToleranceIsBelowRounding) {
  InteriorPointSettings settings;
  settings.tolerance = 1e-300;
  settings.max_iterations = 100000;
  const MpcSolution solution = solve(straight_ahead(), settings);
  EXPECT_EQ(solution.status, SolveStatus::Stalled);
  EXPECT_NEAR(solution.cost, solve(straight_ahead()).cost, 1e-4)
      << "the solution is good nevertheless";
}

TEST_F(InteriorPointStatus, InvalidProblemGivesZeroCommands) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto expect_invalid = [&](auto&& spoil) {
    ControlProblem problem = straight_ahead();
    put_obstacle(problem, {1.0, 0.05}, 0.7);
    spoil(problem);
    const MpcSolution& solution = solve(problem);
    EXPECT_EQ(solution.status, SolveStatus::InvalidProblem);
    for (const Twist2& command : solution.commands) {
      EXPECT_EQ(command.linear, 0.0);
      EXPECT_EQ(command.angular, 0.0);
    }
    for (const Pose2& pose : solution.poses)
      EXPECT_TRUE(is_finite(pose));
  };
  expect_invalid([&](ControlProblem& p) { p.start.heading = nan; });
  expect_invalid([&](ControlProblem& p) { p.targets[3].position.x() = nan; });
  expect_invalid([&](ControlProblem& p) { p.obstacles[0].position[2].y() = nan; });
  expect_invalid([&](ControlProblem& p) { p.previous_command.linear = 1e300; });
  expect_invalid([&](ControlProblem& p) { p.horizon = 0; });
  expect_invalid([&](ControlProblem& p) { p.horizon = kMaxHorizon + 1; });
  expect_invalid([&](ControlProblem& p) { p.num_obstacles = kMaxObstacles + 1; });
  expect_invalid([&](ControlProblem& p) { p.command_min.linear = 2.0; });
  expect_invalid([&](ControlProblem& p) { p.dt = 0.0; });
  expect_invalid([&](ControlProblem& p) { p.barrier_retention = 1.0; });
  expect_invalid([&](ControlProblem& p) { p.violation_weight = 0.0; });
}

TEST_F(InteriorPointStatus, GuessesMayContainAnyNumbers) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double cost = solve(straight_ahead()).cost;
  for (const double value : {nan, std::numeric_limits<double>::infinity(), 1e300, -1e300}) {
    InitialGuess guess;
    guess.count = 7;
    guess.commands.fill({.linear = value, .angular = value});
    const MpcSolution& solution = solver_->solve(straight_ahead(), guess);
    EXPECT_EQ(solution.status, SolveStatus::Solved);
    EXPECT_NEAR(solution.cost, cost, 1e-4);
  }
}

}  // namespace
}  // namespace fairway
