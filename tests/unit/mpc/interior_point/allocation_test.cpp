// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cstdlib>
#include <memory>

#include <gtest/gtest.h>

#include "fairway/mpc/interior_point/four_start_solver.hpp"
#include "fairway/mpc/start_guesses.hpp"
#include "support/random/random_control_problem.hpp"
#include "support/runs/allocation_guard.hpp"

namespace fairway {
namespace {

TEST(AllocationGuard, CountsMalloc) {
  if (!test::AllocationGuard::available) GTEST_SKIP() << "a sanitizer owns malloc";
  const test::AllocationGuard guard;
  void* volatile block = std::malloc(10);  // NOLINT(cppcoreguidelines-no-malloc)
  std::free(block);                        // NOLINT(cppcoreguidelines-no-malloc)
  EXPECT_EQ(guard.count(), 1U);
}

TEST(InteriorPointSolver, NeverAllocates) {
  if (!test::AllocationGuard::available) GTEST_SKIP() << "a sanitizer owns malloc";
  const auto solver = std::make_unique<FourStartSolver>();
  test::Random random(81);
  for (int trial = 0; trial < 50; ++trial) {
    const ControlProblem problem = test::random_control_problem(
        random, {.max_horizon = kMaxHorizon, .max_obstacles = kMaxObstacles});
    std::array<InitialGuess, 3> guesses;
    const test::AllocationGuard guard;
    spread_guesses(problem, {}, guesses);
    static_cast<void>(solver->single().solve_best(problem, guesses));
    static_cast<void>(solver->solve(problem));
    EXPECT_EQ(guard.count(), 0U);
  }
}

}  // namespace
}  // namespace fairway
