// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/ipopt/ipopt_body_solver.hpp"

#include <algorithm>
#include <exception>

#include "fairway/mpc/ipopt/configured_ipopt.hpp"
#include "fairway/mpc/ipopt/ipopt_body_derivatives.hpp"
#include "fairway/mpc/ipopt/ipopt_body_problem.hpp"
#include "fairway/mpc/step_index.hpp"

namespace fairway {

template <typename Motion>
struct IpoptBodySolver<Motion>::Session {
  ConfiguredIpopt ipopt;
  Ipopt::SmartPtr<IpoptBodyProblem<Motion>> nlp;
  BodySolution<Motion> solution;

  explicit Session(const IpoptSettings& settings)
      : ipopt(settings),
        nlp(new IpoptBodyProblem<Motion>(settings.constraints)) {}

  void run(const BodyProblem<Motion>& problem, const BodyGuess<Motion>& guess) {
    InputBounds<Motion> bounds;
    find_input_bounds(problem, bounds);
    for (std::size_t k = 0; k < step_index(problem.horizon); ++k)
      solution.inputs[k] = guess.count > 0 ? guess.inputs[std::min(k, step_index(guess.count - 1))]
                                           : bounds.inside[k];
    nlp->set(problem, solution.inputs);
    const Ipopt::ApplicationReturnStatus status =
        ipopt.solve(GetRawPtr(nlp), guess.count > 0, solution.iterations);
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
