// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "fairway/mpc/control_problem.hpp"
#include "fairway/mpc/control_solver.hpp"
#include "fairway/mpc/solution.hpp"

namespace fairway {

/// How IPOPT treats the constraints that a problem may be unable to satisfy.
enum class IpoptConstraints : std::uint8_t {
  Soft,  ///< a slack each, at violation_weight: an infeasible problem returns least violation
  Hard,  ///< as the paper has them: an infeasible problem ends wherever IPOPT gives up
};

struct IpoptSettings {
  IpoptConstraints constraints = IpoptConstraints::Soft;
  int max_iterations = 500;
  double tolerance = 1e-8;  ///< of IPOPT's scaled optimality error
  /// Barrier parameter that IPOPT starts from when a guess is given: small enough that it stays on
  /// the guess's side of an obstacle. Without a guess IPOPT's own 0.1.
  double guess_barrier = 1e-3;
};

/// The reference solver: IPOPT with MUMPS, multiple shooting, exact first and second derivatives.
///
/// Solves the same ControlProblem as the real-time solver, hundreds of times slower, with other
/// people's well-tried code: the oracle. Allocates; not thread-safe, not even two objects in two
/// threads (MUMPS). Status Solved means: IPOPT converged and no constraint is violated beyond
/// kFeasibilityTolerance; LeastViolation: it converged, but constraints are violated. Bounds that
/// contradict each other make the problem invalid here; the real-time solver still answers those.
class IpoptSolver final : public ControlSolver {
 public:
  explicit IpoptSolver(const IpoptSettings& settings = {});
  IpoptSolver(const IpoptSolver&) = delete;
  IpoptSolver& operator=(const IpoptSolver&) = delete;
  ~IpoptSolver() override;

  /// Solves from `guess` and its rollout. Nothing is thrown or printed; the returned numbers are
  /// finite and the commands within the bounds, whatever the status.
  [[nodiscard]] const MpcSolution& solve(const ControlProblem& problem,
                                         const InitialGuess& guess) noexcept override;

 private:
  struct Session;
  std::unique_ptr<Session> session_;
};

}  // namespace fairway
