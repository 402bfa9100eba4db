// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/interior_point/real_time_solver.hpp"

#include "fairway/mpc/interior_point/solver.hpp"
#include "fairway/mpc/interior_point/workspace/settings.hpp"

namespace fairway {

struct RealTimeSolver::Session {
  InteriorPointSolver solver;
  int max_iterations;

  explicit Session(const MpcSettings& settings) : max_iterations(settings.max_iterations) {}
};

RealTimeSolver::RealTimeSolver(const MpcSettings& settings)
    : session_(std::make_unique<Session>(settings)) {}
RealTimeSolver::~RealTimeSolver() = default;

const MpcSolution& RealTimeSolver::solve(const ControlProblem& problem,
                                         const InitialGuess& guess) noexcept {
  InteriorPointSettings settings =
      guess.count > 0 ? InteriorPointSettings::warm() : InteriorPointSettings{};
  settings.max_iterations = session_->max_iterations;
  return session_->solver.solve(problem, guess, settings);
}

}  // namespace fairway
