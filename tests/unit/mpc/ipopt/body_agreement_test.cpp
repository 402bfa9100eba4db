// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include <gtest/gtest.h>

#include "fairway/mpc/interior_point/body/body_solver.hpp"
#include "fairway/mpc/ipopt/ipopt_body_solver.hpp"
#include "support/random/random_body_problem.hpp"

namespace fairway {
namespace {

// A sample of what benchmarks/body_solver_benchmark measures.
constexpr int kProblems = 12;
constexpr double kNear = 1e-4;

template <typename Motion>
class BodyAgreement : public testing::Test {};
using Motions = testing::Types<UnicycleMotion, SteeredMotion, OmniMotion>;
TYPED_TEST_SUITE(BodyAgreement, Motions);

// IPOPT starts from our solution, so both are at the same local minimum.
TYPED_TEST(BodyAgreement, IpoptFindsNothingBetterNearby) {
  const auto solver = std::make_unique<BodySolver<TypeParam>>();
  IpoptBodySolver<TypeParam> ipopt;
  test::RandomBodyProblems problems(23);
  int solved = 0;
  for (int i = 0; i < kProblems; ++i) {
    const auto problem = problems.next<TypeParam>({.horizon = 12});
    const BodySolution<TypeParam> ours = solver->solve(problem);
    if (ours.status != SolveStatus::Solved) continue;
    ++solved;
    BodyGuess<TypeParam> guess;
    guess.count = problem.horizon;
    guess.inputs = ours.inputs;
    const BodySolution<TypeParam>& theirs = ipopt.solve(problem, guess);
    EXPECT_EQ(theirs.status, SolveStatus::Solved);
    EXPECT_NEAR(ours.cost, theirs.cost, kNear * theirs.cost);
  }
  EXPECT_GE(solved, kProblems / 4);
}

TYPED_TEST(BodyAgreement, MissesNoFeasibleProblem) {
  const auto solver = std::make_unique<BodySolver<TypeParam>>();
  IpoptBodySolver<TypeParam> ipopt;
  test::RandomBodyProblems problems(24);
  for (int i = 0; i < kProblems; ++i) {
    const auto problem = problems.next<TypeParam>({.horizon = 12});
    if (ipopt.solve(problem).status != SolveStatus::Solved) continue;
    EXPECT_EQ(solver->solve(problem).status, SolveStatus::Solved) << "problem " << i;
  }
}

// Hard constraints, which an infeasible problem does not have, give the same answer.
TYPED_TEST(BodyAgreement, HardConstraintsGiveTheSameCost) {
  const auto solver = std::make_unique<BodySolver<TypeParam>>();
  IpoptBodySolver<TypeParam> ipopt({.constraints = IpoptConstraints::Hard});
  test::RandomBodyProblems problems(25);
  int solved = 0;
  for (int i = 0; i < kProblems; ++i) {
    const auto problem = problems.next<TypeParam>({.horizon = 12, .obstacles = 0});
    const BodySolution<TypeParam> ours = solver->solve(problem);
    if (ours.status != SolveStatus::Solved) continue;
    const BodySolution<TypeParam>& theirs = ipopt.solve(problem);
    if (theirs.status != SolveStatus::Solved) continue;
    ++solved;
    EXPECT_NEAR(ours.cost, theirs.cost, kNear * theirs.cost);
  }
  EXPECT_GE(solved, kProblems / 4);
}

}  // namespace
}  // namespace fairway
