// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/ipopt/ipopt_solver.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "experiments/solver/paper_problem.hpp"
#include "fairway/mpc/evaluation.hpp"
#include "support/oracles/first_order_oracle.hpp"
#include "support/random/random_control_problem.hpp"

namespace fairway {
namespace {

using test::Random;

// Checks what holds for every solution, with any status.
void expect_sound(const ControlProblem& problem, const MpcSolution& solution) {
  EXPECT_LE(bound_violation(problem, solution.commands).max, 1e-9);
  MpcSolution again;
  again.commands = solution.commands;
  assess(problem, again);
  EXPECT_EQ(again.cost, solution.cost);
  EXPECT_EQ(again.max_violation, solution.max_violation);
  for (int k = 0; k <= problem.horizon; ++k)
    EXPECT_TRUE(is_finite(solution.poses[static_cast<std::size_t>(k)]));
}

// A straight path to the target, with a wall in between if `wall` is below the target's x.
ControlProblem straight_ahead(double wall) {
  PaperScene scene;
  scene.current_target = scene.next_target = {.position = {2.0, 0.0}, .heading = 0.0};
  scene.region = {.min = {-1.0, -1.0}, .max = {wall, 1.0}};
  return paper_problem(paper_mpc_settings(), paper_robot_settings(), scene);
}

TEST(IpoptSolver, DrivesStraightAtFullSpeedToADistantTarget) {
  IpoptSolver solver;
  const ControlProblem problem = straight_ahead(5.0);
  const MpcSolution& solution = solver.solve(problem, {});
  EXPECT_EQ(solution.status, SolveStatus::Solved);
  EXPECT_GT(solution.iterations, 0);
  EXPECT_NEAR(solution.commands[0].linear, 1.0, 1e-6);
  EXPECT_NEAR(solution.commands[0].angular, 0.0, 1e-6);
  EXPECT_EQ(solution.limiting.kind, ConstraintKind::LinearSpeed);
  expect_sound(problem, solution);
}

TEST(IpoptSolver, StopsAtTheWallAndNamesIt) {
  IpoptSolver solver;
  const ControlProblem problem = straight_ahead(0.7);
  const MpcSolution& solution = solver.solve(problem, {});
  EXPECT_EQ(solution.status, SolveStatus::Solved);
  EXPECT_NEAR(solution.poses[10].position.x(), 0.7, 1e-6);
  EXPECT_LE(solution.max_violation, kFeasibilityTolerance);
  EXPECT_EQ(solution.limiting.kind, ConstraintKind::Corridor);
  EXPECT_EQ(solution.limiting.index, 1);
  expect_sound(problem, solution);
}

TEST(IpoptSolver, ReturnsTheLeastViolationWhereNothingIsFeasible) {
  // Outside by 0.2 m, driving away from the wall and never allowed to stop. The heading is slightly
  // off: exactly straight is a stationary point where both turns are better.
  ControlProblem problem = straight_ahead(-0.2);
  problem.start.heading = 0.1;
  for (const IpoptConstraints constraints : {IpoptConstraints::Soft, IpoptConstraints::Hard}) {
    IpoptSolver solver({.constraints = constraints});
    const MpcSolution& solution = solver.solve(problem, {});
    EXPECT_EQ(solution.status, SolveStatus::LeastViolation);
    EXPECT_GT(solution.max_violation, 0.0);
    expect_sound(problem, solution);
    if (constraints == IpoptConstraints::Hard) continue;
    // The slowest speed with full turns to either side, or straight ahead.
    for (const double turn : {-1.5, 0.0, 1.5}) {
      MpcSolution other;
      other.commands.fill({.linear = 0.05, .angular = turn});
      assess(problem, other);
      EXPECT_LE(solution.sum_violation, other.sum_violation + 1e-6);
    }
  }
}

TEST(IpoptSolver, KeepsItsDistanceFromAMovingObstacle) {
  PaperScene scene;
  scene.current_target = scene.next_target = {.position = {2.0, 0.0}, .heading = 0.0};
  scene.region = {.min = {-3.0, -3.0}, .max = {5.0, 3.0}};
  const std::array<MovingObstacle, 1> obstacles{
      MovingObstacle{.position = {1.5, 0.1}, .velocity = {-0.3, 0.0}, .radius = 0.8}};
  scene.obstacles = obstacles;
  const ControlProblem problem = paper_problem(paper_mpc_settings(), paper_robot_settings(), scene);
  IpoptSolver solver;
  const MpcSolution& solution = solver.solve(problem, {});
  EXPECT_EQ(solution.status, SolveStatus::Solved);
  EXPECT_EQ(solution.limiting.kind, ConstraintKind::Barrier);
  for (int k = 0; k <= problem.horizon; ++k) {
    const auto at = static_cast<std::size_t>(k);
    EXPECT_GE(barrier(problem.obstacles[0], k, solution.poses[at].position), 0.0);
  }
}

TEST(IpoptSolver, SolutionsAreFeasibleAndOptimalByIndependentChecks) {
  Random random(31);
  int solved = 0;
  int unfeasible = 0;
  constexpr int kTrials = 30;
  IpoptSolver solver;
  for (int trial = 0; trial < kTrials; ++trial) {
    const ControlProblem problem = test::random_control_problem(random);
    const MpcSolution& solution = solver.solve(problem, {});
    SCOPED_TRACE(testing::Message() << "trial " << trial << ": " << to_text(solution.status));
    expect_sound(problem, solution);
    if (solution.status == SolveStatus::Solved) {
      ++solved;
      EXPECT_LE(soft_violation(problem, solution.poses).max, kFeasibilityTolerance);
    } else if (solution.status == SolveStatus::LeastViolation) {
      ++unfeasible;
    } else {
      continue;
    }
    const test::Optimality optimality = test::first_order_optimality(problem, solution.commands);
    EXPECT_LT(optimality.residual, 1e-4 * optimality.scale);
    EXPECT_LT(optimality.complementarity, 1e-4);
  }
  EXPECT_GT(solved, kTrials / 2);
  EXPECT_GT(unfeasible, 0);
  EXPECT_GE(solved + unfeasible, kTrials - 1);
}

TEST(IpoptSolver, StopsAtTheEndWithinTheChangeBounds) {
  ControlProblem problem = straight_ahead(5.0);
  problem.command_min.linear = 0.0;
  problem.previous_command = {.linear = 0.9, .angular = 0.3};
  problem.max_change = {.linear = 0.15, .angular = 0.4};
  problem.stop_at_end = true;
  IpoptSolver solver;
  const MpcSolution& solution = solver.solve(problem, {});
  EXPECT_EQ(solution.status, SolveStatus::Solved);
  EXPECT_EQ(solution.commands[9].linear, 0.0);
  EXPECT_EQ(solution.commands[9].angular, 0.0);
  expect_sound(problem, solution);
}

TEST(IpoptSolver, ABetterGuessIsUsed) {
  IpoptSolver solver;
  const ControlProblem problem = straight_ahead(0.7);
  const MpcSolution cold = solver.solve(problem, {});
  InitialGuess guess;
  guess.count = 10;
  guess.commands = cold.commands;
  const MpcSolution& warm = solver.solve(problem, guess);
  EXPECT_EQ(warm.status, SolveStatus::Solved);
  EXPECT_NEAR(warm.cost, cold.cost, 1e-6 * cold.cost);
}

TEST(IpoptSolver, GivesUpAtTheIterationLimitWithUsableCommands) {
  IpoptSolver solver({.max_iterations = 2});
  const ControlProblem problem = straight_ahead(0.7);
  const MpcSolution& solution = solver.solve(problem, {});
  EXPECT_EQ(solution.status, SolveStatus::IterationLimit);
  expect_sound(problem, solution);
}

TEST(IpoptSolver, RefusesInvalidProblemsWithZeroCommands) {
  IpoptSolver solver;
  ControlProblem problem = straight_ahead(0.7);
  problem.start.heading = std::numeric_limits<double>::quiet_NaN();
  const MpcSolution& solution = solver.solve(problem, {});
  EXPECT_EQ(solution.status, SolveStatus::InvalidProblem);
  EXPECT_EQ(solution.commands[0].linear, 0.0);
  EXPECT_EQ(solution.cost, 0.0);
}

TEST(IpoptSolver, StaysFiniteOnExtremeProblems) {
  Random random(32);
  IpoptSolver solver({.max_iterations = 50});
  for (int trial = 0; trial < 20; ++trial) {
    ControlProblem problem = test::random_control_problem(random);
    for (auto& target : problem.targets) {
      target.position *= random.chance(0.5) ? 1e8 : 1e-8;
      target.weight *= random.chance(0.5) ? 1e6 : 0.0;
    }
    problem.violation_weight = random.chance(0.5) ? 1e9 : 1e-9;
    const MpcSolution& solution = solver.solve(problem, {});
    expect_sound(problem, solution);
  }
}

TEST(IpoptSolver, SameProblemSameBits) {
  Random random(33);
  const ControlProblem problem = test::random_control_problem(random);
  IpoptSolver solver;
  const MpcSolution first = solver.solve(problem, {});
  (void)solver.solve(straight_ahead(0.5), {});
  const MpcSolution& second = solver.solve(problem, {});
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(first.commands[k].linear, second.commands[k].linear);
    EXPECT_EQ(first.commands[k].angular, second.commands[k].angular);
  }
}

}  // namespace
}  // namespace fairway
