// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/interior_point/solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fairway/mpc/evaluation.hpp"
#include "fairway/mpc/interior_point/barrier_iteration.hpp"
#include "fairway/mpc/interior_point/initial_point.hpp"
#include "fairway/mpc/interior_point/kernels.hpp"
#include "fairway/mpc/interior_point/report.hpp"
#include "fairway/mpc/interior_point/setup.hpp"

namespace fairway {
namespace interior_point {
namespace {

bool is_rounding(const NewtonStep& step, std::size_t horizon) noexcept {
  for (const PoseArray& commands : step.commands) {
    for (std::size_t k = 1; k <= horizon; ++k) {
      if (!(std::abs(commands[k]) < kRoundingStep)) return false;
    }
  }
  return true;
}

SolveStatus iterate(const SimdKernels& kernels,
                    const InteriorPointSettings& settings,
                    Workspace& w,
                    int& iterations) noexcept {
  return iterate_barrier(
      kernels, settings, [](const Workspace& at) { return is_rounding(at.step, at.horizon); }, w,
      iterations);
}

// Continues from a stationary point that is not a minimum: the Hessian was not positive definite on
// the last step. This happens straight behind an obstacle with equal clearance on both sides. The
// solution is replaced only if a better one is found to the left.
void leave_saddle(const SimdKernels& kernels,
                  const InteriorPointSettings& settings,
                  Workspace& w,
                  int& iterations) noexcept {
  constexpr double kNudge = 0.2;  // share of the distance to the bound of the angular speed
  const std::array<PoseArray, 2> saddle = w.now->commands;
  const double merit = penalised_cost(w, *w.now);
  InitialGuess beside{.count = static_cast<int>(w.horizon), .commands = {}};
  for (std::size_t k = 0; k < w.horizon; ++k) {
    const double angular = saddle[kAngular][k + 1];
    beside.commands[k] = {
        .linear = saddle[kLinear][k + 1],
        .angular = angular + kNudge * (w.limits[kAngular].reach_high[k] - angular)};
  }
  load_guess(kernels, beside, w, *w.now);
  InteriorPointSettings rest = settings;
  rest.max_iterations -= iterations;
  int more = 0;
  const SolveStatus status = iterate(kernels, rest, w, more);
  iterations += more;
  if (status == SolveStatus::Solved && penalised_cost(w, *w.now) < merit) return;
  w.now->commands = saddle;
  kernels.evaluate(w, *w.now);
}

}  // namespace

bool is_better(const MpcSolution& a, const MpcSolution& b, double penalty_weight) noexcept {
  const bool a_solved = a.status == SolveStatus::Solved;
  const bool b_solved = b.status == SolveStatus::Solved;
  if (a_solved != b_solved) return a_solved;
  return a.cost + penalty_weight * a.sum_violation < b.cost + penalty_weight * b.sum_violation;
}

}  // namespace interior_point

InteriorPointSolver::InteriorPointSolver() noexcept
    : kernels_(interior_point::kernels_256() != nullptr ? interior_point::kernels_256()
                                                        : &interior_point::kernels_128()) {}

const MpcSolution& InteriorPointSolver::solve(const ControlProblem& problem,
                                              const InitialGuess& guess,
                                              const InteriorPointSettings& settings) noexcept {
  const ProblemFault fault = validate(problem);
  if (!load(problem, fault)) return solution_;
  interior_point::Workspace& w = workspace_;
  interior_point::load_guess(*kernels_, guess, w, *w.now);
  solution_.status = interior_point::iterate(*kernels_, settings, w, solution_.iterations);
  finish(problem, guess, settings, fault == ProblemFault::Contradiction);
  return solution_;
}

bool InteriorPointSolver::load(const ControlProblem& problem, ProblemFault fault) noexcept {
  if (fault != ProblemFault::None && fault != ProblemFault::Contradiction) {
    interior_point::report_invalid(problem, solution_);
    return false;
  }
  interior_point::load_problem(problem, workspace_);
  return true;
}

void InteriorPointSolver::finish(const ControlProblem& problem,
                                 const InitialGuess& guess,
                                 const InteriorPointSettings& settings,
                                 bool contradiction) noexcept {
  interior_point::Workspace& w = workspace_;
  const interior_point::SimdKernels& kernels = *kernels_;
  if (solution_.status == SolveStatus::Solved && !w.step.convex)
    interior_point::leave_saddle(kernels, settings, w, solution_.iterations);

  // The result of an unfinished solve must not be worse than the guess.
  interior_point::clip_commands(w, *w.now);
  kernels.evaluate(w, *w.now);
  if (solution_.status != SolveStatus::Solved) {
    interior_point::load_guess(kernels, guess, w, *w.trial);
    interior_point::clip_commands(w, *w.trial);
    kernels.evaluate(w, *w.trial);
    if (!(interior_point::penalised_cost(w, *w.now) <= interior_point::penalised_cost(w, *w.trial)))
      std::swap(w.now, w.trial);
  }
  if (!interior_point::report(w, solution_)) {
    interior_point::report_invalid(problem, solution_);
    return;
  }
  const bool violated = solution_.max_violation > kFeasibilityTolerance || contradiction;
  if (solution_.status == SolveStatus::Solved && violated)
    solution_.status = SolveStatus::LeastViolation;
}

void InteriorPointSolver::resume(const ControlProblem& problem,
                                 const InitialGuess& guess,
                                 const InteriorPointSettings& settings,
                                 const InteriorPointSettings& rest) noexcept {
  solution_.status = interior_point::iterate(*kernels_, rest, workspace_, solution_.iterations);
  finish(problem, guess, settings, validate(problem) == ProblemFault::Contradiction);
}

const MpcSolution& InteriorPointSolver::solve_best(const ControlProblem& problem,
                                                   std::span<const InitialGuess> guesses,
                                                   const InteriorPointSettings& settings) noexcept {
  if (guesses.empty()) return solve(problem, {}, settings);
  int iterations = 0;
  for (const InitialGuess& guess : guesses) {
    const bool first = &guess == guesses.data();
    solve(problem, guess, settings);
    iterations += solution_.iterations;
    if (first || interior_point::is_better(solution_, best_, problem.violation_weight))
      best_ = solution_;
  }
  best_.iterations = iterations;
  return best_;
}

}  // namespace fairway
