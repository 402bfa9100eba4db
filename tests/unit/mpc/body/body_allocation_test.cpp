// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include <gtest/gtest.h>

#include "fairway/mpc/interior_point/body/body_solver.hpp"
#include "support/random/random_body_problem.hpp"
#include "support/runs/allocation_guard.hpp"

namespace fairway {
namespace {

template <typename Motion>
void expect_no_allocation() {
  test::RandomBodyProblems problems(3);
  const auto solver = std::make_unique<BodySolver<Motion>>();
  for (int i = 0; i < 5; ++i) {
    const auto problem = problems.next<Motion>({});
    const test::AllocationGuard guard;
    static_cast<void>(solver->solve(problem));
    EXPECT_EQ(guard.count(), 0U);
  }
}

TEST(BodySolverAllocation, NeverAllocates) {
  if (!test::AllocationGuard::available) GTEST_SKIP() << "a sanitizer owns malloc";
  expect_no_allocation<UnicycleMotion>();
  expect_no_allocation<SteeredMotion>();
  expect_no_allocation<OmniMotion>();
}

}  // namespace
}  // namespace fairway
