// SPDX-License-Identifier: Apache-2.0
// Solves problems of any numbers: the answer is finite and within the change bounds, or refused.
#include <cstdint>
#include <cstdlib>
#include <memory>

#include "fairway/mpc/interior_point/solver.hpp"
#include "fuzz/byte_source.hpp"
#include "support/random/extreme_control_problem.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto solver = std::make_unique<fairway::InteriorPointSolver>();
  fairway::test::ByteSource source(data, size);
  const fairway::ControlProblem problem = fairway::test::extreme_control_problem(source);
  const fairway::InitialGuess guess = fairway::test::extreme_guess(source);
  const fairway::MpcSolution& solution = solver->solve(problem, guess, {.max_iterations = 50});
  if (!fairway::test::is_finite_solution(solution)) std::abort();
  if (solution.status != fairway::SolveStatus::InvalidProblem &&
      !fairway::test::keeps_change_bounds(problem, solution))
    std::abort();
  return 0;
}
