// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <utility>

#include "fairway/mpc/solution.hpp"

namespace fairway {

/// Measures the time of another solver with a given clock. Both must outlive it.
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

  /// The solver's time since the last call [s].
  [[nodiscard]] double take_seconds() noexcept { return std::exchange(seconds_, 0.0); }

 private:
  ControlSolver& solver_;
  const std::function<double()>& clock_;
  double seconds_ = 0.0;
};

}  // namespace fairway
