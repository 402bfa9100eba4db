// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/ipopt/ipopt_solver.hpp"

#include <array>
#include <cmath>
#include <exception>
#include <stdexcept>

#include <IpIpoptApplication.hpp>
#include <IpSolveStatistics.hpp>

#include "fairway/mpc/evaluation.hpp"
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
  double guess_barrier;
  Ipopt::SmartPtr<Ipopt::IpoptApplication> application;
  Ipopt::SmartPtr<IpoptProblem> nlp;
  std::array<Twist2, kMaxHorizon> start;
  MpcSolution solution;

  explicit Session(const IpoptSettings& settings)
      : guess_barrier(settings.guess_barrier),
        application(new Ipopt::IpoptApplication(false)),
        nlp(new IpoptProblem(settings.constraints)) {
    Ipopt::OptionsList& options = *application->Options();
    options.SetIntegerValue("print_level", 0);
    options.SetStringValue("sb", "yes");  // no banner
    options.SetStringValue("linear_solver", "mumps");
    options.SetIntegerValue("max_iter", settings.max_iterations);
    options.SetNumericValue("tol", settings.tolerance);
    // Bounds hold exactly instead of within 1e-8.
    options.SetNumericValue("bound_relax_factor", 0.0);
    // The empty name prevents reading a file ipopt.opt in the working directory.
    if (application->Initialize("") != Ipopt::Solve_Succeeded)
      throw std::runtime_error("IPOPT could not be initialised with MUMPS");
  }

  // Sets how far IPOPT moves the start from its bounds, and the initial barrier parameter.
  void trust(bool guess) {
    Ipopt::OptionsList& options = *application->Options();
    options.SetNumericValue("mu_init", guess ? guess_barrier : 0.1);
    for (const char* push : {"bound_push", "bound_frac", "slack_bound_push", "slack_bound_frac"})
      options.SetNumericValue(push, guess ? 1e-4 : 1e-2);
  }

  void run(const ControlProblem& problem, const InitialGuess& guess) {
    expand_guess(problem, guess, start);
    solution.commands = start;
    nlp->set(problem, start);
    trust(guess.count > 0);
    const Ipopt::ApplicationReturnStatus status = application->OptimizeTNLP(GetRawPtr(nlp));
    const Ipopt::SmartPtr<Ipopt::SolveStatistics> statistics = application->Statistics();
    if (IsValid(statistics)) solution.iterations = statistics->IterationCount();
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
