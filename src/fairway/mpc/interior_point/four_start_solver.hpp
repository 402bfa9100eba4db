// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/interior_point/lockstep/lockstep.hpp"
#include "fairway/mpc/interior_point/solver.hpp"

namespace fairway {

/// The interior-point solver from several starts: it also iterates four others side by side, one
/// per lane of a register.
///
/// It has all guarantees of InteriorPointSolver. Use one solver per thread.
class FourStartSolver {
 public:
  FourStartSolver() noexcept = default;
  explicit FourStartSolver(const interior_point::SimdKernels& kernels) noexcept
      : solver_(kernels) {}

  /// Solves as InteriorPointSolver::solve; then, if obstacles shape the result, iterates four other
  /// starts: to the left, to the right, behind and before what is in front. The result is never
  /// worse than from one start: Solved before all others, then the least cost plus penalty.
  const MpcSolution& solve(const ControlProblem& problem,
                           const InitialGuess& guess = {},
                           const InteriorPointSettings& settings = {}) noexcept;

  /// The solver from one start.
  [[nodiscard]] InteriorPointSolver& single() noexcept { return solver_; }

 private:
  InteriorPointSolver solver_;
  interior_point::lockstep::Lockstep lockstep_;
};

}  // namespace fairway
