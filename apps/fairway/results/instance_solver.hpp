// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>

#include "fairway/base/error.hpp"
#include "fairway/mpc/solution.hpp"
#include "fairway/mpc/start_guesses.hpp"

namespace fairway::app {

/// A solver that runs once for each of the given initial guesses.
class InstanceSolver {
 public:
  InstanceSolver() = default;
  InstanceSolver(const InstanceSolver&) = delete;
  InstanceSolver& operator=(const InstanceSolver&) = delete;
  virtual ~InstanceSolver() = default;

  /// Solves from each guess (at least one) and keeps the best result. A solved one comes first,
  /// then the least cost plus penalty. Valid until the next call.
  [[nodiscard]] virtual const MpcSolution& solve(const ControlProblem& problem,
                                                 std::span<const InitialGuess> guesses) = 0;
};

/// Makes a solver by name; an error if this build lacks it. The names are `interior_point`, `ipopt`
/// (the paper's method with soft constraints) and `ipopt_hard` (the paper's method).
[[nodiscard]] Expected<std::unique_ptr<InstanceSolver>> make_instance_solver(
    const std::string& name);

}  // namespace fairway::app
