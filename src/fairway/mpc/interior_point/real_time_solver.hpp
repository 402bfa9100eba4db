// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/control_solver.hpp"
#include "fairway/mpc/interior_point/solver.hpp"
#include "fairway/mpc/mpc_settings.hpp"

namespace fairway {

/// The interior-point solver as the control loop uses it: warm where there is a guess, with the
/// iteration budget of the settings.
class RealTimeSolver final : public ControlSolver {
 public:
  explicit RealTimeSolver(const MpcSettings& settings) : max_iterations_(settings.max_iterations) {}

  [[nodiscard]] const MpcSolution& solve(const ControlProblem& problem,
                                         const InitialGuess& guess) noexcept override {
    InteriorPointSettings settings =
        guess.count > 0 ? InteriorPointSettings::warm() : InteriorPointSettings{};
    settings.max_iterations = max_iterations_;
    return solver_.solve(problem, guess, settings);
  }

 private:
  InteriorPointSolver solver_;
  int max_iterations_;
};

}  // namespace fairway
