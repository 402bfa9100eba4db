// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "fairway/mpc/control_problem.hpp"
#include "fairway/mpc/evaluation.hpp"
#include "fairway/mpc/interior_point/kernels.hpp"
#include "fairway/mpc/interior_point/workspace/settings.hpp"
#include "fairway/mpc/interior_point/workspace/workspace.hpp"
#include "fairway/mpc/solution.hpp"

namespace fairway {
namespace interior_point {

/// Whether a result is better than another one: Solved before all others, then the least cost plus
/// penalty.
[[nodiscard]] bool is_better(const MpcSolution& a,
                             const MpcSolution& b,
                             double penalty_weight) noexcept;

}  // namespace interior_point

/// The real-time solver of Eq. (15): a structured interior-point method with soft constraints,
/// derived in docs/solver.md.
///
/// Every result is finite and satisfies the command and change bounds exactly; `status` gives its
/// quality. The same input gives the same bits, whatever was solved before. The solver does not
/// allocate, lock or throw. An object has about 1.3 MB, so keep it off small stacks. Use one solver
/// per thread.
///
/// If bounds contradict each other, the change bound takes precedence. From a previous command
/// outside its range, the commands return as fast as the change bound allows; a stop out of reach
/// is approached as fast as it allows. The status is then LeastViolation.
class InteriorPointSolver {
 public:
  /// Selects the widest registers of this processor; the results do not depend on them.
  InteriorPointSolver() noexcept;
  explicit InteriorPointSolver(const interior_point::SimdKernels& kernels) noexcept
      : kernels_(&kernels) {}

  /// Solves from one guess; without a guess, from initial commands of its own (`load_guess`). The
  /// reference stays valid until the next call.
  const MpcSolution& solve(const ControlProblem& problem,
                           const InitialGuess& guess = {},
                           const InteriorPointSettings& settings = {}) noexcept;

  /// Solves from each guess and keeps the best result: Solved before all others, then the least
  /// cost plus penalty. Ties go to the earlier guess. Without guesses it solves as `solve`.
  /// `iterations` is the sum over all guesses.
  const MpcSolution& solve_best(const ControlProblem& problem,
                                std::span<const InitialGuess> guesses,
                                const InteriorPointSettings& settings = {}) noexcept;

 private:
  friend class FourStartSolver;

  bool load(const ControlProblem& problem, ProblemFault fault) noexcept;
  // Continues from the commands in the workspace with the settings `rest`.
  // @pre `solve` has loaded this problem.
  void resume(const ControlProblem& problem,
              const InitialGuess& guess,
              const InteriorPointSettings& settings,
              const InteriorPointSettings& rest) noexcept;
  void finish(const ControlProblem& problem,
              const InitialGuess& guess,
              const InteriorPointSettings& settings,
              bool contradiction) noexcept;

  const interior_point::SimdKernels* kernels_;  // the fastest that this processor supports
  interior_point::Workspace workspace_;
  MpcSolution solution_;
  MpcSolution best_;
};

}  // namespace fairway
