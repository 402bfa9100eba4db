// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/control_solver.hpp"
#include "fairway/mpc/interior_point_solver.hpp"
#include "fairway/mpc/mpc_settings.hpp"

namespace fairway {

/// The structured interior-point solver behind the interface that the navigator drives with.
class RealTimeSolver final : public ControlSolver {
 public:
  explicit RealTimeSolver(const MpcSettings& settings) noexcept {
    settings_.max_iterations = settings.max_iterations;
  }

  [[nodiscard]] const MpcSolution& solve(const ControlProblem& problem,
                                         const InitialGuess& guess) noexcept override {
    return solver_.solve(problem, guess, settings_);
  }

 private:
  InteriorPointSolver solver_;
  InteriorPointSettings settings_;
};

}  // namespace fairway
