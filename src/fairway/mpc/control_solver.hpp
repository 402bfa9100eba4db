// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/solution.hpp"

namespace fairway {

/// Something that solves the optimal control problem: the structured real-time solver, or IPOPT.
class ControlSolver {
 public:
  ControlSolver() = default;
  ControlSolver(const ControlSolver&) = delete;
  ControlSolver& operator=(const ControlSolver&) = delete;
  virtual ~ControlSolver() = default;

  /// Solves from a guess. The result is finite, obeys the hard rows, and stays valid until the next
  /// call.
  [[nodiscard]] virtual const MpcSolution& solve(const ControlProblem& problem,
                                                 const InitialGuess& guess) noexcept = 0;
};

}  // namespace fairway
