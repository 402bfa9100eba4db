// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/interior_point/solver.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <memory>

#include <gtest/gtest.h>

#include "fairway/mpc/evaluation.hpp"
#include "fairway/mpc/start_guesses.hpp"
#include "support/oracles/optimality_oracle.hpp"
#include "support/random/random_control_problem.hpp"

namespace fairway {
namespace {

using test::Random;
using test::RandomProblemOptions;

/// Calls check(problem, solver) for many random problems.
template <typename Check>
void for_each_problem(std::uint64_t seed,
                      int count,
                      const RandomProblemOptions& options,
                      Check&& check) {
  const auto solver = std::make_unique<InteriorPointSolver>();
  Random random(seed);
  for (int trial = 0; trial < count; ++trial) {
    SCOPED_TRACE(testing::Message() << "seed " << seed << " trial " << trial);
    const ControlProblem problem = test::random_control_problem(random, options);
    check(problem, *solver);
  }
}

constexpr RandomProblemOptions kPaper{.every_feature = false};
constexpr RandomProblemOptions kLong{.max_horizon = kMaxHorizon, .max_obstacles = kMaxObstacles};

TEST(InteriorPointSolver, AgreesWithAnIndependentRollout) {
  for (const RandomProblemOptions& options : {kPaper, RandomProblemOptions{}, kLong}) {
    for_each_problem(71, 300, options, [](const ControlProblem& problem, auto& solver) {
      const MpcSolution& solution = solver.solve(problem);
      EXPECT_LE(bound_violation(problem, solution.commands).max, 0.0);
      MpcSolution assessed = solution;
      assess(problem, assessed);
      EXPECT_NEAR(solution.cost, assessed.cost, 1e-11 * (1.0 + std::abs(assessed.cost)));
      EXPECT_NEAR(solution.max_violation, assessed.max_violation, 1e-11);
      EXPECT_NEAR(solution.sum_violation, assessed.sum_violation, 1e-10);
      ASSERT_EQ(solution.horizon, problem.horizon);
      for (int k = 0; k <= problem.horizon; ++k) {
        const auto i = static_cast<std::size_t>(k);
        EXPECT_LT((solution.poses[i].position - assessed.poses[i].position).norm(), 1e-12);
        EXPECT_NEAR(solution.poses[i].heading, assessed.poses[i].heading, 1e-12);
      }
    });
  }
}

TEST(InteriorPointSolver, SatisfiesTheOptimalityConditions) {
  int solved = 0;
  int total = 0;
  for (const RandomProblemOptions& options : {kPaper, RandomProblemOptions{}}) {
    for_each_problem(72, 60, options, [&](const ControlProblem& problem, auto& solver) {
      const MpcSolution& solution = solver.solve(problem);
      ++total;
      if (solution.status != SolveStatus::Solved && solution.status != SolveStatus::LeastViolation)
        return;
      ++solved;
      // Gradients are of order 100; the residuals are rounding and the last barrier.
      EXPECT_LT(test::optimality_residual(problem, solution), 5e-2);
    });
  }
  EXPECT_GE(solved, total * 95 / 100);
}

TEST(InteriorPointSolver, GivesTheSameBitsForTheSameInput) {
  for_each_problem(73, 50, {}, [](const ControlProblem& problem, auto& solver) {
    const MpcSolution first = solver.solve(problem);
    solver.solve(ControlProblem{});
    const MpcSolution& second = solver.solve(problem);
    for (std::size_t k = 0; k < static_cast<std::size_t>(problem.horizon); ++k) {
      EXPECT_EQ(std::memcmp(&first.commands[k], &second.commands[k], sizeof(Twist2)), 0);
      EXPECT_EQ(first.poses[k].position, second.poses[k].position);
      EXPECT_EQ(first.poses[k].heading, second.poses[k].heading);
    }
    EXPECT_EQ(first.iterations, second.iterations);
  });
}

TEST(InteriorPointSolver, GivesTheSameBitsInRegistersOfAnyWidth) {
  const interior_point::SimdKernels* wide = interior_point::kernels_256();
  if (wide == nullptr) GTEST_SKIP() << "this processor or this build has none of 256 bits";
  const auto other = std::make_unique<InteriorPointSolver>(interior_point::kernels_128());
  for (const RandomProblemOptions& options : {kPaper, RandomProblemOptions{}, kLong}) {
    for_each_problem(75, 100, options, [&](const ControlProblem& problem, auto& solver) {
      const MpcSolution& a = solver.solve(problem);
      const MpcSolution& b = other->solve(problem);
      EXPECT_EQ(a.iterations, b.iterations);
      EXPECT_EQ(a.cost, b.cost);
      for (std::size_t k = 0; k < static_cast<std::size_t>(problem.horizon); ++k)
        EXPECT_EQ(std::memcmp(&a.commands[k], &b.commands[k], sizeof(Twist2)), 0);
    });
  }
}

// An obstacle exactly ahead, with equal clearance on both sides, and a guess straight at it. By
// symmetry every iterate would stay between both passages, at the maximum.
TEST(InteriorPointSolver, PassesAnObstacleThatIsExactlyAhead) {
  const auto solver = std::make_unique<InteriorPointSolver>();
  int total = 0;
  int beaten = 0;
  int turned = 0;
  for (const int horizon : {10, 20, 30}) {
    for (const double keep_out : {0.3, 0.5, 0.8}) {
      for (double ahead = keep_out + 0.05; ahead < 2.5; ahead += 0.15) {
        ControlProblem problem;
        problem.horizon = horizon;
        problem.max_change = {.linear = 0.2, .angular = 0.4};
        problem.num_obstacles = 1;
        problem.obstacles[0].position.fill({ahead, 0.0});
        problem.obstacles[0].keep_out.fill(keep_out);
        for (StepTarget& target : problem.targets)
          target = {.position = {4.0, 0.0}, .heading = 0.0, .weight = {5.0, 5.0, 0.1}};
        const auto from_turn = [&](double angular) {
          InitialGuess guess{.count = 1, .commands = {}};
          guess.commands[0] = {.linear = 0.5, .angular = angular};
          return solver->solve(problem, guess, InteriorPointSettings::warm());
        };
        const auto merit = [&](const MpcSolution& s) {
          return s.cost + problem.violation_weight * s.sum_violation;
        };
        const MpcSolution straight = from_turn(0.0);
        ++total;
        if (merit(straight) > 1.01 * merit(from_turn(0.3))) ++beaten;
        if (std::abs(straight.poses[static_cast<std::size_t>(horizon)].position.y()) > 0.01)
          ++turned;
      }
    }
  }
  EXPECT_LE(beaten, total / 20);
  EXPECT_GE(turned, total / 4);
}

TEST(InteriorPointSolver, KeepsTheBestOfSeveralStarts) {
  for_each_problem(74, 200, {}, [](const ControlProblem& problem, auto& solver) {
    std::array<InitialGuess, 3> starts;
    spread_guesses(problem, {}, starts);
    const auto merit = [&](const MpcSolution& s) {
      return s.cost + problem.violation_weight * s.sum_violation;
    };
    const MpcSolution best = solver.solve_best(problem, starts);
    for (const InitialGuess& start : starts) {
      const MpcSolution& one = solver.solve(problem, start);
      EXPECT_TRUE(best.status == SolveStatus::Solved || one.status != SolveStatus::Solved);
      if (best.status == one.status) {
        EXPECT_LE(merit(best), merit(one));
      }
    }
  });
}

}  // namespace
}  // namespace fairway
