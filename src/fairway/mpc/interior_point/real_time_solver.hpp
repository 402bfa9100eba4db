// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "fairway/mpc/control_problem.hpp"
#include "fairway/mpc/control_solver.hpp"
#include "fairway/mpc/mpc_settings.hpp"
#include "fairway/mpc/solution.hpp"

namespace fairway {

/// The interior-point solver as the control loop uses it: warm where there is a guess, with the
/// iteration budget of the settings. Allocates when it is constructed, and never again.
class RealTimeSolver final : public ControlSolver {
 public:
  explicit RealTimeSolver(const MpcSettings& settings);
  RealTimeSolver(const RealTimeSolver&) = delete;
  RealTimeSolver& operator=(const RealTimeSolver&) = delete;
  ~RealTimeSolver() override;

  [[nodiscard]] const MpcSolution& solve(const ControlProblem& problem,
                                         const InitialGuess& guess) noexcept override;

 private:
  struct Session;
  std::unique_ptr<Session> session_;
};

}  // namespace fairway
