// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/ipopt/ipopt_solver.hpp"

#include <array>
#include <cmath>
#include <exception>

#include "fairway/mpc/evaluation.hpp"
#include "fairway/mpc/ipopt/configured_ipopt.hpp"
#include "fairway/mpc/ipopt/ipopt_problem.hpp"

namespace fairway {
namespace {

SolveStatus solve_status(Ipopt::ApplicationReturnStatus status, double max_violation) {
  // No switch over IPOPT's thirty statuses: all others mean that it could not continue.
  if (status == Ipopt::Solve_Succeeded || status == Ipopt::Solved_To_Acceptable_Level ||
      status == Ipopt::Infeasible_Problem_Detected) {
    if (max_violation > kFeasibilityTolerance) return SolveStatus::LeastViolation;
    return status == Ipopt::Infeasible_Problem_Detected ? SolveStatus::Stalled
                                                        : SolveStatus::Solved;
  }
  if (status == Ipopt::Maximum_Iterations_Exceeded) return SolveStatus::IterationLimit;
  return SolveStatus::Stalled;
}

}  // namespace

struct IpoptSolver::Session {
  ConfiguredIpopt ipopt;
  Ipopt::SmartPtr<IpoptProblem> nlp;
  std::array<Twist2, kMaxHorizon> start;
  MpcSolution solution;

  explicit Session(const IpoptSettings& settings)
      : ipopt(settings),
        nlp(new IpoptProblem(settings.constraints)) {}

  void run(const ControlProblem& problem, const InitialGuess& guess) {
    expand_guess(problem, guess, start);
    solution.commands = start;
    nlp->set(problem, start);
    const Ipopt::ApplicationReturnStatus status =
        ipopt.solve(GetRawPtr(nlp), guess.count > 0, solution.iterations);
    solution.commands = nlp->commands();
    solution.limiting = nlp->limiting();
    clip_to_bounds(problem, solution.commands);
    assess(problem, solution);
    solution.status = solve_status(status, solution.max_violation);
  }
};

IpoptSolver::IpoptSolver(const IpoptSettings& settings)
    : session_(std::make_unique<Session>(settings)) {}
IpoptSolver::~IpoptSolver() = default;

const MpcSolution& IpoptSolver::solve(const ControlProblem& problem,
                                      const InitialGuess& guess) noexcept {
  MpcSolution& solution = session_->solution;
  solution = {};
  if (validate(problem) != ProblemFault::None) return solution;
  try {
    session_->run(problem, guess);
  } catch (const std::exception&) {
    // Out of memory, or an error that IPOPT does not catch itself: the start is still usable.
    solution.commands = session_->start;
    assess(problem, solution);
    solution.status = SolveStatus::Stalled;
  }
  return solution;
}

}  // namespace fairway
