// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <utility>

#include "fairway/mpc/control_solver.hpp"

namespace fairway {

/// A solver that adds up what another one takes, on a lent clock. Both outlive it.
class TimedSolver final : public ControlSolver {
 public:
  TimedSolver(ControlSolver& solver, const std::function<double()>& clock)
      : solver_(solver),
        clock_(clock) {}

  const MpcSolution& solve(const ControlProblem& problem,
                           const InitialGuess& guess) noexcept override {
    const double before = clock_();
    const MpcSolution& solution = solver_.solve(problem, guess);
    seconds_ += clock_() - before;
    return solution;
  }

  /// What was taken since the last call [s].
  [[nodiscard]] double take_seconds() noexcept { return std::exchange(seconds_, 0.0); }

 private:
  ControlSolver& solver_;
  const std::function<double()>& clock_;
  double seconds_ = 0.0;
};

}  // namespace fairway
