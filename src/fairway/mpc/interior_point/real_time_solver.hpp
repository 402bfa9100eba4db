// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "fairway/mpc/control_problem.hpp"
#include "fairway/mpc/mpc_settings.hpp"
#include "fairway/mpc/solution.hpp"

namespace fairway {

/// The interior-point solver in the form that the control loop uses. It starts warm if there is a
/// guess, and takes its iteration budget from the settings. It allocates only when it is
/// constructed.
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
