// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/control_problem.hpp"
#include "fairway/mpc/solution.hpp"

namespace fairway::test {

/// A solver that never moves, and says that it has solved the problem.
class IdleSolver final : public ControlSolver {
 public:
  const MpcSolution& solve(const ControlProblem& problem,
                           const InitialGuess& /*guess*/) noexcept override {
    solution_ = MpcSolution{};
    solution_.status = SolveStatus::Solved;
    solution_.horizon = problem.horizon;
    solution_.poses.fill(problem.start);
    return solution_;
  }

 private:
  MpcSolution solution_;
};

}  // namespace fairway::test
