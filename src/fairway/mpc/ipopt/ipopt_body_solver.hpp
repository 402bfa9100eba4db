// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "fairway/mpc/body/body_evaluation.hpp"
#include "fairway/mpc/ipopt/ipopt_solver.hpp"

namespace fairway {

/// The reference solver of a body: IPOPT with multiple shooting and exact derivatives, as
/// `IpoptSolver` for a disc. It has the same bounds as `BodySolver`.
template <typename Motion>
class IpoptBodySolver {
 public:
  explicit IpoptBodySolver(const IpoptSettings& settings = {});
  IpoptBodySolver(const IpoptBodySolver&) = delete;
  IpoptBodySolver& operator=(const IpoptBodySolver&) = delete;
  ~IpoptBodySolver();

  /// Solves from `guess` and its rollout; without a guess, from inputs inside the bounds that
  /// nearly stop. Does not throw or print.
  [[nodiscard]] const BodySolution<Motion>& solve(const BodyProblem<Motion>& problem,
                                                  const BodyGuess<Motion>& guess = {}) noexcept;

 private:
  struct Session;
  std::unique_ptr<Session> session_;
};

}  // namespace fairway
