// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/solution.hpp"

namespace fairway {

/// Interface of the solvers of the optimal control problem: the real-time solver and IPOPT.
class ControlSolver {
 public:
  ControlSolver() = default;
  ControlSolver(const ControlSolver&) = delete;
  ControlSolver& operator=(const ControlSolver&) = delete;
  virtual ~ControlSolver() = default;

  /// Solves `problem` from `guess`. The result is finite and satisfies the hard constraints; it
  /// stays valid until the next call.
  [[nodiscard]] virtual const MpcSolution& solve(const ControlProblem& problem,
                                                 const InitialGuess& guess) noexcept = 0;
};

}  // namespace fairway
