// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "fairway/mpc/control_problem.hpp"
#include "fairway/mpc/solution.hpp"

namespace fairway {

/// Treatment of the constraints that a problem may be unable to satisfy.
enum class IpoptConstraints : std::uint8_t {
  Soft,  ///< one slack each, with violation_weight: an infeasible problem gives the least violation
  Hard,  ///< as in the paper: an infeasible problem ends wherever IPOPT gives up
};

/// Settings of the reference solver.
struct IpoptSettings {
  IpoptConstraints constraints = IpoptConstraints::Soft;
  int max_iterations = 500;
  double tolerance = 1e-8;  ///< on IPOPT's scaled optimality error
  /// Initial barrier parameter with a guess, small enough to stay on the guess's side of an
  /// obstacle. Without a guess IPOPT's default of 0.1 is used.
  double guess_barrier = 1e-3;
};

/// The reference solver: IPOPT with MUMPS, multiple shooting, and exact first and second
/// derivatives.
///
/// It solves the same ControlProblem as the real-time solver with independent, well-tested code,
/// but takes hundreds of times longer. It allocates and is not thread-safe: MUMPS does not allow
/// two objects in two threads either. Solved means that IPOPT converged and no constraint is
/// violated beyond kFeasibilityTolerance; LeastViolation means that it converged with violations.
/// Contradicting bounds make the problem invalid here; the real-time solver still solves it.
class IpoptSolver final : public ControlSolver {
 public:
  explicit IpoptSolver(const IpoptSettings& settings = {});
  IpoptSolver(const IpoptSolver&) = delete;
  IpoptSolver& operator=(const IpoptSolver&) = delete;
  ~IpoptSolver() override;

  /// Solves from `guess` and its rollout. Does not throw or print. The result is finite and the
  /// commands are within the bounds, whatever the status.
  [[nodiscard]] const MpcSolution& solve(const ControlProblem& problem,
                                         const InitialGuess& guess) noexcept override;

 private:
  struct Session;
  std::unique_ptr<Session> session_;
};

}  // namespace fairway
