// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "fairway/mpc/control_problem.hpp"
#include "fairway/mpc/interior_point_workspace.hpp"
#include "fairway/mpc/solution.hpp"

namespace fairway {

/// When the interior-point solver stops.
struct InteriorPointSettings {
  int max_iterations = 100;  ///< Newton steps of one start
  double tolerance = 1e-6;   ///< on the optimality conditions, docs/solver.md Eq. (S14)
  /// Barrier parameter mu of the first step. Smaller trusts the guess more.
  double initial_barrier = 5.0;

  /// For a guess that is the shifted answer of the cycle before.
  [[nodiscard]] static constexpr InteriorPointSettings warm() noexcept {
    return {.max_iterations = 100, .tolerance = 1e-3, .initial_barrier = 1e-2};
  }
};

/// The real-time solver of Eq. (15): a structured elastic interior-point method, docs/solver.md.
///
/// Every answer is finite and obeys the command and change bounds exactly; `status` tells what else
/// it is. The same input gives the same bits, whatever was solved before. Does not allocate, lock
/// or throw. About 0.3 MB, so keep it out of small stacks. One solver per thread.
///
/// Where hard rows contradict each other, the change bound wins: from a previous command outside
/// its range the commands head back as fast as it allows; a stop that is out of reach is
/// approached as fast as it allows. The status is then LeastViolation.
class InteriorPointSolver {
 public:
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
  interior_point::Workspace workspace_;
  MpcSolution solution_;
  MpcSolution best_;
};

}  // namespace fairway
