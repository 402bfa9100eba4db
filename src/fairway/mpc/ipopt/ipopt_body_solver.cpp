// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/ipopt/ipopt_body_solver.hpp"

#include <algorithm>
#include <exception>
#include <stdexcept>

#include <IpIpoptApplication.hpp>
#include <IpSolveStatistics.hpp>

#include "fairway/mpc/ipopt/ipopt_body_derivatives.hpp"
#include "fairway/mpc/ipopt/ipopt_body_problem.hpp"
#include "fairway/mpc/step_index.hpp"

namespace fairway {

template <typename Motion>
struct IpoptBodySolver<Motion>::Session {
  double guess_barrier;
  Ipopt::SmartPtr<Ipopt::IpoptApplication> application;
  Ipopt::SmartPtr<IpoptBodyProblem<Motion>> nlp;
  BodySolution<Motion> solution;

  explicit Session(const IpoptSettings& settings)
      : guess_barrier(settings.guess_barrier),
        application(new Ipopt::IpoptApplication(false)),
        nlp(new IpoptBodyProblem<Motion>(settings.constraints)) {
    Ipopt::OptionsList& options = *application->Options();
    options.SetIntegerValue("print_level", 0);
    options.SetStringValue("sb", "yes");  // no banner
    options.SetStringValue("linear_solver", "mumps");
    options.SetIntegerValue("max_iter", settings.max_iterations);
    options.SetNumericValue("tol", settings.tolerance);
    options.SetNumericValue("bound_relax_factor", 0.0);
    if (application->Initialize("") != Ipopt::Solve_Succeeded)
      throw std::runtime_error("IPOPT could not be initialised with MUMPS");
  }

  void trust(bool guess) {
    Ipopt::OptionsList& options = *application->Options();
    options.SetNumericValue("mu_init", guess ? guess_barrier : 0.1);
    for (const char* push : {"bound_push", "bound_frac", "slack_bound_push", "slack_bound_frac"})
      options.SetNumericValue(push, guess ? 1e-4 : 1e-2);
  }

  void run(const BodyProblem<Motion>& problem, const BodyGuess<Motion>& guess) {
    InputBounds<Motion> bounds;
    find_input_bounds(problem, bounds);
    for (std::size_t k = 0; k < step_index(problem.horizon); ++k)
      solution.inputs[k] = guess.count > 0 ? guess.inputs[std::min(k, step_index(guess.count - 1))]
                                           : bounds.inside[k];
    nlp->set(problem, solution.inputs);
    trust(guess.count > 0);
    const Ipopt::ApplicationReturnStatus status = application->OptimizeTNLP(GetRawPtr(nlp));
    const Ipopt::SmartPtr<Ipopt::SolveStatistics> statistics = application->Statistics();
    if (IsValid(statistics)) solution.iterations = statistics->IterationCount();
    solution.inputs = nlp->inputs();
    assess(problem, solution);
    const bool converged =
        status == Ipopt::Solve_Succeeded || status == Ipopt::Solved_To_Acceptable_Level;
    if (status == Ipopt::Maximum_Iterations_Exceeded) {
      solution.status = SolveStatus::IterationLimit;
    } else if (!converged) {
      solution.status = SolveStatus::Stalled;
    } else {
      const bool violated = solution.max_violation > kFeasibilityTolerance || bounds.relaxed;
      solution.status = violated ? SolveStatus::LeastViolation : SolveStatus::Solved;
    }
  }
};

template <typename Motion>
IpoptBodySolver<Motion>::IpoptBodySolver(const IpoptSettings& settings)
    : session_(std::make_unique<Session>(settings)) {}
template <typename Motion>
IpoptBodySolver<Motion>::~IpoptBodySolver() = default;

template <typename Motion>
const BodySolution<Motion>& IpoptBodySolver<Motion>::solve(
    const BodyProblem<Motion>& problem, const BodyGuess<Motion>& guess) noexcept {
  BodySolution<Motion>& solution = session_->solution;
  solution = {};
  if (validate(problem) != ProblemFault::None) return solution;
  try {
    session_->run(problem, guess);
  } catch (const std::exception&) {
    // Out of memory, or an error that IPOPT does not catch itself.
    solution.status = SolveStatus::Stalled;
  }
  return solution;
}

template class IpoptBodySolver<UnicycleMotion>;
template class IpoptBodySolver<SteeredMotion>;
template class IpoptBodySolver<OmniMotion>;

}  // namespace fairway
