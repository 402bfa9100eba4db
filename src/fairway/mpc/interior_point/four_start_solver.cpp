// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/interior_point/four_start_solver.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/base/simd_math.hpp"
#include "fairway/mpc/interior_point/barrier_iteration.hpp"
#include "fairway/mpc/interior_point/initial_point.hpp"
#include "fairway/mpc/interior_point/kernels.hpp"
#include "fairway/mpc/interior_point/report.hpp"
#include "fairway/mpc/interior_point/workspace/iteration_rules.hpp"

namespace fairway {
namespace interior_point {
namespace {

// Whether an obstacle or a violation shapes the solution. Otherwise it is the solution without
// obstacles, and there is nothing to pass on another side.
bool has_alternatives(const Workspace& w, const MpcSolution& solution) noexcept {
  constexpr double kActiveMultiplier = 1e-3;  // least multiplier
  const ControlProblem& problem = *w.problem;
  const double fastest =
      std::max(std::abs(problem.command_min.angular), std::abs(problem.command_max.angular));
  const double turn =
      problem.horizon * problem.dt * (fastest + std::abs(problem.previous_command.angular));
  if (w.num_soft_constraints == 0 || !(turn < 0.5 * kMostHeading)) return false;
  if (solution.status != SolveStatus::Solved) return true;
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    const ConstraintRange& range = w.constraint_ranges[b];
    for (std::size_t i = range.barrier; i < range.watched_barrier; ++i) {
      if (greatest_of(Lanes128(w.soft_constraints[i].dual)) > kActiveMultiplier) return true;
    }
  }
  return false;
}

// Loads the commands of four other starts. They drive past all obstacles on the left, on the right,
// begin slowly behind crossing obstacles, or otherwise than the first start.
void load_alternatives(const SimdKernels& kernels, Workspace& w, lockstep::Lockstep& s) noexcept {
  std::size_t count = 0;
  const auto keep = [&] {
    for (std::size_t j = 0; j < 2; ++j)
      std::copy_n(w.trial->commands[j].begin() + 1, w.horizon, s.commands[count][j].begin());
    ++count;
  };
  for (const double turn : {w.problem->command_max.angular, w.problem->command_min.angular}) {
    InitialGuess hard{.count = 1, .commands = {}};
    hard.commands[0] = {.linear = w.problem->command_max.linear, .angular = turn};
    load_guess(kernels, hard, w, *w.trial);
    keep();
  }
  const Drive first = load_drive(kernels, DriveStart::Any, w, *w.trial);
  for (const DriveStart begins :
       {DriveStart::Slow, DriveStart::Straight, DriveStart::Left, DriveStart::Right}) {
    if (begins == first.begins || count == lockstep::kStarts) continue;
    static_cast<void>(load_drive(kernels, begins, w, *w.trial));
    keep();
  }
}

// Makes every soft constraint a watched one again.
void watch_all(Workspace& w) noexcept {
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    ConstraintRange& range = w.constraint_ranges[b];
    range.watched_corridor = range.corridor;
    range.watched_barrier = range.barrier;
    w.model.now[b] = {};
  }
}

// Iterates four starts side by side as long as they may lead to something better than `w.now`.
// Loads the commands of the best one.
// @return Whether it may be better.
bool improve(const SimdKernels& kernels,
             const InteriorPointSettings& settings,
             Workspace& w,
             lockstep::Lockstep& s,
             double& barrier) noexcept {
  constexpr double kCoarse = 1e-2;              // tolerance that suffices to compare
  constexpr int kMostIterations = 30;           // of a start that is compared
  constexpr double kBarrierByViolation = 0.01;  // starts at the bounds violate much, and briefly
  constexpr double kWorthwhile = 1e-4;          // relative gain
  s.problem = &w;
  s.limit = penalised_cost(w, *w.now);
  std::copy_n(w.now->x.begin(), w.horizon + 1, s.best_x.begin());
  std::copy_n(w.now->y.begin(), w.horizon + 1, s.best_y.begin());
  load_alternatives(kernels, w, s);
  InteriorPointSettings cold;
  cold.max_iterations = std::min(kMostIterations, settings.max_iterations);
  cold.barrier_by_violation = kBarrierByViolation;
  cold.tolerance = std::max(kCoarse, settings.tolerance);
  lockstep::FourSettings four;
  four.fill(cold);
  kernels.iterate_lockstep(s, four);
  const lockstep::StartState* best = nullptr;
  for (const lockstep::StartState& start : s.starts) {
    if (start.given_up || !(start.merit < s.limit * (1.0 - kWorthwhile))) continue;
    if (best == nullptr || start.merit < best->merit) best = &start;
  }
  if (best == nullptr) return false;
  const auto index = static_cast<std::size_t>(best - s.starts.data());
  for (std::size_t j = 0; j < 2; ++j)
    std::copy_n(s.commands[index][j].begin(), w.horizon, w.now->commands[j].begin() + 1);
  barrier = best->barrier;
  watch_all(w);
  return true;
}

}  // namespace
}  // namespace interior_point

const MpcSolution& FourStartSolver::solve(const ControlProblem& problem,
                                          const InitialGuess& guess,
                                          const InteriorPointSettings& settings) noexcept {
  constexpr double kBarrierByViolation = 0.01;  // of the last iteration: it starts near its end
  constexpr double kFirstSlack = 1e-4;          // per mu [m]
  const MpcSolution& solution = solver_.solve(problem, guess, settings);
  interior_point::Workspace& w = solver_.workspace_;
  if (solution.status == SolveStatus::InvalidProblem ||
      !interior_point::has_alternatives(w, solution)) {
    return solution;
  }
  MpcSolution& best = solver_.best_;
  best = solution;
  InteriorPointSettings rest = settings;
  if (!interior_point::improve(*solver_.kernels_, settings, w, lockstep_, rest.initial_barrier))
    return best;
  rest.barrier_by_violation = kBarrierByViolation;
  rest.first_slack = kFirstSlack * rest.initial_barrier;
  solver_.resume(problem, guess, settings, rest);
  if (!interior_point::is_better(solution, best, problem.violation_weight)) return best;
  solver_.solution_.iterations += best.iterations;
  return solution;
}

}  // namespace fairway
