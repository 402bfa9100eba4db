// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "fairway/mpc/evaluation.hpp"
#include "fairway/mpc/interior_point/solver.hpp"
#include "support/random/extreme_control_problem.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

class RandomSource {
 public:
  explicit RandomSource(std::uint64_t seed) : random_(seed) {}
  double usual(double low, double high) { return random_.uniform(low, high); }
  int integer(int low, int high) { return random_.integer(low, high); }
  bool chance(double probability) { return random_.chance(probability); }
  double number() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const std::array<double, 8> odd{nan, infinity, -infinity, 0.0, -0.0, 1e-310, 1e308, -1e9};
    if (chance(0.5)) return odd[static_cast<std::size_t>(integer(0, 7))];
    return std::ldexp(usual(-1.0, 1.0), integer(-60, 60));
  }

 private:
  test::Random random_;
};

TEST(InteriorPointFuzz, AnswersAreFiniteAndWithinTheBoundsForAnyNumbers) {
  const auto solver = std::make_unique<InteriorPointSolver>();
  RandomSource source(101);
  std::array<int, 5> seen{};
  for (int trial = 0; trial < 1500; ++trial) {
    SCOPED_TRACE(trial);
    const ControlProblem problem = test::extreme_control_problem(source);
    const InitialGuess guess = test::extreme_guess(source);
    const MpcSolution& solution = solver->solve(problem, guess, {.max_iterations = 50});
    ++seen[static_cast<std::size_t>(solution.status)];
    ASSERT_TRUE(test::is_finite_solution(solution));
    if (solution.status == SolveStatus::InvalidProblem) continue;
    ASSERT_TRUE(test::keeps_change_bounds(problem, solution));
    if (solution.status == SolveStatus::Solved) {
      ASSERT_LE(bound_violation(problem, solution.commands).max, 1e-6);
      ASSERT_LE(solution.max_violation, kFeasibilityTolerance);
    }
  }
  for (const SolveStatus status : {SolveStatus::Solved, SolveStatus::LeastViolation,
                                   SolveStatus::IterationLimit, SolveStatus::InvalidProblem})
    EXPECT_GT(seen[static_cast<std::size_t>(status)], 0) << to_text(status);
}

}  // namespace
}  // namespace fairway
