// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/interior_point/body/body_solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fairway/mpc/interior_point/barrier_iteration.hpp"
#include "fairway/mpc/interior_point/body/body_setup.hpp"

namespace fairway {
namespace interior_point {
namespace {

template <typename Motion>
bool is_rounding(const BodyWorkspace<Motion>& w) noexcept {
  return std::all_of(w.step.inputs.begin(), w.step.inputs.end(), [&](const PoseArray& inputs) {
    return std::all_of(inputs.begin() + 1, inputs.begin() + 1 + static_cast<int>(w.horizon),
                       [](double change) { return std::abs(change) < kRoundingStep; });
  });
}

template <typename Motion>
SolveStatus iterate_body(const BodyKernels<Motion>& kernels,
                         const InteriorPointSettings& settings,
                         BodyWorkspace<Motion>& w,
                         int& iterations) noexcept {
  return iterate_barrier(
      kernels, settings, [](const BodyWorkspace<Motion>& at) { return is_rounding(at); }, w,
      iterations);
}

// Continues from a stationary point that is not a minimum, as `leave_saddle` of a disc: the input
// that turns the body is moved towards its upper bound.
template <typename Motion>
void leave_body_saddle(const BodyKernels<Motion>& kernels,
                       const InteriorPointSettings& settings,
                       BodyWorkspace<Motion>& w,
                       int& iterations) noexcept {
  constexpr double kNudge = 0.2;  // share of the distance to the bound
  const auto saddle = w.now->inputs;
  const double merit = penalised_cost(w, *w.now);
  BodyGuess<Motion> beside;
  beside.count = static_cast<int>(w.horizon);
  for (std::size_t k = 0; k < w.horizon; ++k) {
    for (int j = 0; j < Motion::kInputs; ++j)
      beside.inputs[k][j] = saddle[static_cast<std::size_t>(j)][k + 1];
    double& turn = beside.inputs[k][Motion::kTurn];
    turn += kNudge * (w.input_bounds.high[k][Motion::kTurn] - turn);
  }
  load_body_guess(kernels, beside, w, *w.now);
  InteriorPointSettings rest = settings;
  rest.max_iterations -= iterations;
  int more = 0;
  const SolveStatus status = iterate_body(kernels, rest, w, more);
  iterations += more;
  if (status == SolveStatus::Solved && penalised_cost(w, *w.now) < merit) return;
  w.now->inputs = saddle;
  kernels.evaluate(w, *w.now);
}

// Returns the soft constraint with the greatest multiplier.
template <typename Motion>
BodyConstraintName limiting_constraint(const BodyWorkspace<Motion>& w) noexcept {
  double most = 1e-3;  // multipliers below this do not limit the solution
  BodyConstraintName name;
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    const ConstraintRange& range = w.constraint_ranges[b];
    for (std::size_t i = range.corridor; i < range.watched_barrier; ++i) {
      if (i >= range.watched_corridor && i < range.barrier) continue;
      const BodyConstraintBlock& constraint = w.soft_constraints[i];
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        if (!(constraint.dual[lane] > most)) continue;
        most = constraint.dual[lane];
        name = constraint.name;
        name.step += static_cast<int>(lane);
      }
    }
  }
  return name;
}

// Fills in the inputs of `w.now` and what follows from them. @return Whether all is finite.
template <typename Motion>
bool report_body(const BodyWorkspace<Motion>& w, BodySolution<Motion>& solution) noexcept {
  const BodyPoint<Motion>& p = *w.now;
  const Eigen::Vector2d& origin = w.problem->start.position;
  solution.horizon = w.problem->horizon;
  solution.cost = p.cost;
  const Violations violation = violations_of(w, p);
  solution.max_violation = violation.greatest;
  solution.sum_violation = violation.sum;
  solution.limiting = limiting_constraint(w);
  bool finite = std::isfinite(p.cost) && std::isfinite(violation.sum);
  for (std::size_t k = 0; k < w.horizon; ++k) {
    for (int j = 0; j < Motion::kInputs; ++j)
      solution.inputs[k][j] = p.inputs[static_cast<std::size_t>(j)][k + 1];
    finite = finite && solution.inputs[k].allFinite();
  }
  for (std::size_t k = 0; k <= w.horizon; ++k) {
    solution.poses[k] = {.position = origin + Eigen::Vector2d(p.x[k], p.y[k]),
                         .heading = p.heading[k] + w.full_turns};
    finite = finite && is_finite(solution.poses[k]);
  }
  return finite;
}

template <typename Motion>
void report_invalid_body(const BodyProblem<Motion>& problem,
                         BodySolution<Motion>& solution) noexcept {
  const Pose2 start = is_finite(problem.start) ? problem.start : Pose2{};
  solution.status = SolveStatus::InvalidProblem;
  solution.horizon = std::clamp(problem.horizon, 0, kMaxHorizon);
  solution.iterations = 0;
  solution.cost = solution.max_violation = solution.sum_violation = 0.0;
  solution.limiting = {};
  solution.inputs.fill(Motion::Input::Zero());
  solution.poses.fill(start);
}

}  // namespace
}  // namespace interior_point

template <typename Motion>
BodySolver<Motion>::BodySolver() noexcept
    : kernels_(interior_point::body_kernels_256<Motion>() != nullptr
                   ? interior_point::body_kernels_256<Motion>()
                   : &interior_point::body_kernels_128<Motion>()) {}

template <typename Motion>
const BodySolution<Motion>& BodySolver<Motion>::solve(
    const BodyProblem<Motion>& problem,
    const BodyGuess<Motion>& guess,
    const InteriorPointSettings& settings) noexcept {
  if (validate(problem) != ProblemFault::None) {
    interior_point::report_invalid_body(problem, solution_);
    return solution_;
  }
  interior_point::BodyWorkspace<Motion>& w = workspace_;
  interior_point::load_body_problem(problem, w);
  interior_point::load_body_guess(*kernels_, guess, w, *w.now);
  solution_.status = interior_point::iterate_body(*kernels_, settings, w, solution_.iterations);
  if (solution_.status == SolveStatus::Solved && !w.step.convex)
    interior_point::leave_body_saddle(*kernels_, settings, w, solution_.iterations);
  kernels_->evaluate(w, *w.now);
  if (solution_.status != SolveStatus::Solved) {
    // The result of an unfinished solve must not be worse than the guess.
    interior_point::load_body_guess(*kernels_, guess, w, *w.trial);
    kernels_->evaluate(w, *w.trial);
    if (!(interior_point::penalised_cost(w, *w.now) <= interior_point::penalised_cost(w, *w.trial)))
      std::swap(w.now, w.trial);
  }
  if (!interior_point::report_body(w, solution_)) {
    interior_point::report_invalid_body(problem, solution_);
    return solution_;
  }
  const bool violated = solution_.max_violation > kFeasibilityTolerance || w.input_bounds.relaxed;
  if (solution_.status == SolveStatus::Solved && violated)
    solution_.status = SolveStatus::LeastViolation;
  return solution_;
}

template <typename Motion>
const BodySolution<Motion>& BodySolver<Motion>::solve_with_restarts(
    const BodyProblem<Motion>& problem,
    const BodyGuess<Motion>& guess,
    const InteriorPointSettings& settings) noexcept {
  constexpr std::array<double, 3> kTurns = {0.0, 0.5, -0.5};  // [rad/s], or steering angle [rad]
  best_ = solve(problem, guess, settings);
  int iterations = best_.iterations;
  for (std::size_t i = 0; i < kTurns.size() && best_.status != SolveStatus::Solved; ++i) {
    if (best_.status == SolveStatus::InvalidProblem) break;
    BodyGuess<Motion> other;
    other.count = 1;
    other.inputs[0].setZero();
    other.inputs[0][Motion::kTurn] = kTurns[i];
    const BodySolution<Motion>& result = solve(problem, other, settings);
    iterations += result.iterations;
    const auto merit = [&](const BodySolution<Motion>& s) {
      return s.cost + problem.violation_weight * s.sum_violation;
    };
    if (result.status == SolveStatus::Solved || merit(result) < merit(best_)) best_ = result;
  }
  best_.iterations = iterations;
  return best_;
}

template class BodySolver<UnicycleMotion>;
template class BodySolver<SteeredMotion>;
template class BodySolver<OmniMotion>;

}  // namespace fairway
