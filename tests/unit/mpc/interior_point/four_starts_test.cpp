// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstring>
#include <memory>

#include <gtest/gtest.h>

#include "fairway/mpc/evaluation.hpp"
#include "fairway/mpc/interior_point/four_start_solver.hpp"
#include "support/random/random_control_problem.hpp"

namespace fairway {
namespace {

using test::Random;
using test::RandomProblemOptions;

constexpr RandomProblemOptions kAllFeatures{.max_horizon = kMaxHorizon,
                                            .max_obstacles = kMaxObstacles};

double four_starts_merit(const ControlProblem& problem, const MpcSolution& solution) {
  return solution.cost + problem.violation_weight * solution.sum_violation;
}

TEST(FourStarts, AreNeverWorseThanOneAndKeepItsGuarantees) {
  const auto solver = std::make_unique<FourStartSolver>();
  int better = 0;
  for (const RandomProblemOptions& options : {RandomProblemOptions{}, kAllFeatures}) {
    Random random(81);
    for (int trial = 0; trial < 250; ++trial) {
      SCOPED_TRACE(trial);
      const ControlProblem problem = test::random_control_problem(random, options);
      const MpcSolution one = solver->single().solve(problem);
      const MpcSolution four = solver->solve(problem);
      EXPECT_LE(bound_violation(problem, four.commands).max, 0.0);
      MpcSolution assessed = four;
      assess(problem, assessed);
      EXPECT_NEAR(four.cost, assessed.cost, 1e-11 * (1.0 + std::abs(assessed.cost)));
      EXPECT_NEAR(four.max_violation, assessed.max_violation, 1e-11);
      EXPECT_TRUE(four.status == SolveStatus::Solved || one.status != SolveStatus::Solved);
      if (four.status == one.status) {
        EXPECT_LE(four_starts_merit(problem, four), four_starts_merit(problem, one));
      }
      if (four_starts_merit(problem, four) < 0.999 * four_starts_merit(problem, one)) ++better;
    }
  }
  EXPECT_GE(better, 10);
}

TEST(FourStarts, GiveTheSameBitsForAllRegisters) {
  const interior_point::SimdKernels* wide = interior_point::kernels_256();
  if (wide == nullptr) GTEST_SKIP() << "this processor has no registers of 256 bits";
  const auto solver = std::make_unique<FourStartSolver>(*wide);
  const auto other = std::make_unique<FourStartSolver>(interior_point::kernels_128());
  Random random(82);
  for (int trial = 0; trial < 150; ++trial) {
    const ControlProblem problem = test::random_control_problem(random, kAllFeatures);
    const MpcSolution& a = solver->solve(problem);
    const MpcSolution& b = other->solve(problem);
    ASSERT_EQ(a.iterations, b.iterations) << trial;
    ASSERT_EQ(a.cost, b.cost) << trial;
    const auto size = static_cast<std::size_t>(a.horizon) * sizeof(Twist2);
    ASSERT_EQ(std::memcmp(a.commands.data(), b.commands.data(), size), 0) << trial;
  }
}

TEST(FourStarts, DoNotDependOnWhatWasSolvedBefore) {
  const auto used = std::make_unique<FourStartSolver>();
  Random random(83);
  for (int trial = 0; trial < 60; ++trial) {
    const ControlProblem before = test::random_control_problem(random, kAllFeatures);
    const ControlProblem problem = test::random_control_problem(random, {});
    static_cast<void>(used->solve(before));
    const auto first = std::make_unique<FourStartSolver>();
    EXPECT_EQ(first->solve(problem).cost, used->solve(problem).cost) << trial;
  }
}

TEST(FourStarts, AnInvalidProblemStaysInvalid) {
  const auto solver = std::make_unique<FourStartSolver>();
  ControlProblem problem;
  problem.start.position.x() = std::nan("");
  EXPECT_EQ(solver->solve(problem).status, SolveStatus::InvalidProblem);
}

}  // namespace
}  // namespace fairway
