// SPDX-License-Identifier: Apache-2.0
// Compares the interior-point solver with IPOPT on random problems. FAIRWAY_AGREEMENT_PROBLEMS sets
// their number; 2000 take some minutes.
#include <cmath>
#include <cstdlib>
#include <memory>

#include <gtest/gtest.h>

#include "fairway/mpc/evaluation.hpp"
#include "fairway/mpc/interior_point/solver.hpp"
#include "fairway/mpc/ipopt/ipopt_solver.hpp"
#include "support/random/random_control_problem.hpp"

namespace fairway {
namespace {

// The objective of both solvers: cost plus penalty.
double objective(const ControlProblem& problem, const MpcSolution& solution) {
  return solution.cost + problem.violation_weight * solution.sum_violation;
}

bool converged(const MpcSolution& solution) {
  return solution.status == SolveStatus::Solved || solution.status == SolveStatus::LeastViolation;
}

struct Tally {
  int problems = 0;
  int compared = 0;         // both converged
  int same = 0;             // to 0.1 %
  int worse = 0;            // ours exceeds IPOPT's by more
  int missed_feasible = 0;  // only IPOPT found a feasible point
  int not_a_minimum = 0;    // IPOPT, started from ours, finds a better one
  int not_converged = 0;    // ours
};

constexpr double kSame = 1e-3;  // relative; least violations have the penalty weight 1e4

Tally compare(std::uint64_t seed, int count, const test::RandomProblemOptions& options) {
  Tally tally;
  test::Random random(seed);
  const auto ours = std::make_unique<InteriorPointSolver>();
  IpoptSolver reference;
  for (int i = 0; i < count; ++i) {
    const ControlProblem problem = test::random_control_problem(random, options);
    const MpcSolution& a = ours->solve(problem, {});
    const MpcSolution b = reference.solve(problem, {});
    ++tally.problems;
    EXPECT_LE(bound_violation(problem, a.commands).max, 1e-9);
    if (!converged(a)) ++tally.not_converged;
    if (!converged(a) || !converged(b)) continue;
    ++tally.compared;
    const double difference = objective(problem, a) - objective(problem, b);
    const double scale = kSame * (1.0 + std::abs(objective(problem, b)));
    if (b.status == SolveStatus::Solved && a.status != SolveStatus::Solved) ++tally.missed_feasible;
    if (std::abs(difference) <= scale) {
      ++tally.same;
      continue;
    }
    if (difference > 0.0) ++tally.worse;
    // This must be another local minimum, where IPOPT stays.
    InitialGuess guess;
    guess.count = problem.horizon;
    guess.commands = a.commands;
    const MpcSolution& polished = reference.solve(problem, guess);
    if (objective(problem, polished) < objective(problem, a) - scale) ++tally.not_a_minimum;
  }
  return tally;
}

int number_of_problems(int fallback) {
  const char* text = std::getenv("FAIRWAY_AGREEMENT_PROBLEMS");  // NOLINT(concurrency-mt-unsafe)
  const int number = text == nullptr ? 0 : std::atoi(text);
  return number > 0 ? number : fallback;
}

void expect_agreement(const Tally& tally) {
  SCOPED_TRACE(testing::Message() << tally.problems << " problems: " << tally.compared
                                  << " compared, " << tally.same << " same, " << tally.worse
                                  << " worse, " << tally.missed_feasible << " missed feasible, "
                                  << tally.not_a_minimum << " no minimum, " << tally.not_converged
                                  << " not converged");
  const auto share = [&](double part) {
    return static_cast<int>(std::ceil(part * tally.problems));
  };
  EXPECT_GE(tally.compared, tally.problems - share(0.02));
  // The others are in another local minimum, better as often as worse.
  EXPECT_GE(tally.same, tally.compared - share(0.10));
  EXPECT_LE(tally.worse, share(0.03));
  EXPECT_LE(tally.missed_feasible, share(0.01));
  EXPECT_LE(tally.not_a_minimum, share(0.01));
  EXPECT_LE(tally.not_converged, share(0.01));
}

TEST(SolverAgreement, OnThePapersProblem) {
  expect_agreement(compare(51, number_of_problems(40), {.every_feature = false}));
}

TEST(SolverAgreement, OnEveryFeature) { expect_agreement(compare(52, number_of_problems(40), {})); }

}  // namespace
}  // namespace fairway
