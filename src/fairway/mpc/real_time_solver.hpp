// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/control_solver.hpp"
#include "fairway/mpc/interior_point_solver.hpp"
#include "fairway/mpc/mpc_settings.hpp"

namespace fairway {

<<<<<<< HEAD
/// The structured interior-point solver behind the interface that the navigator drives with.
class RealTimeSolver final : public ControlSolver {
 public:
  explicit RealTimeSolver(const MpcSettings& settings) noexcept {
    settings_.max_iterations = settings.max_iterations;
  }

  [[nodiscard]] const MpcSolution& solve(const ControlProblem& problem,
                                         const InitialGuess& guess) noexcept override {
    return solver_.solve(problem, guess, settings_);
=======
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
>>>>>>> solver
  }

 private:
  InteriorPointSolver solver_;
<<<<<<< HEAD
  InteriorPointSettings settings_;
=======
  int max_iterations_;
>>>>>>> solver
};

}  // namespace fairway
