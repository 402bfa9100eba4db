// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "fairway/mpc/control_problem.hpp"
#include "fairway/mpc/interior_point/kernels.hpp"
#include "fairway/mpc/interior_point/settings.hpp"
#include "fairway/mpc/interior_point/workspace/workspace.hpp"
#include "fairway/mpc/solution.hpp"

namespace fairway {

/// The real-time solver of Eq. (15): a structured elastic interior-point method, docs/solver.md.
///
/// Every answer is finite and obeys the command and change bounds exactly; `status` tells what else
/// it is. The same input gives the same bits, whatever was solved before. Does not allocate, lock
/// or throw. About 0.3 MB, so keep it out of small stacks. One solver per thread.
///
/// Where bounds contradict each other, the change bound wins: from a previous command outside
/// its range the commands head back as fast as it allows; a stop that is out of reach is
/// approached as fast as it allows. The status is then LeastViolation.
class InteriorPointSolver {
 public:
  /// Uses the widest registers of this processor; the answers are the same with any.
  InteriorPointSolver() noexcept;
  explicit InteriorPointSolver(const interior_point::SimdKernels& kernels) noexcept
      : kernels_(&kernels) {}

  /// Solves from one start; without a guess, from one of its own (`load_guess`).
  /// The reference stays valid until the next call.
  const MpcSolution& solve(const ControlProblem& problem,
                           const InitialGuess& guess = {},
                           const InteriorPointSettings& settings = {}) noexcept;

  /// Solves from each guess and keeps the best: the least cost plus price of violations, with
  /// Solved before all else; ties go to the earlier. Without guesses as `solve`. `iterations` is
  /// the sum over the starts.
  const MpcSolution& solve_best(const ControlProblem& problem,
                                std::span<const InitialGuess> guesses,
                                const InteriorPointSettings& settings = {}) noexcept;

 private:
  const interior_point::SimdKernels* kernels_;  // as this processor can best
  interior_point::Workspace workspace_;
  MpcSolution solution_;
  MpcSolution best_;
};

}  // namespace fairway
