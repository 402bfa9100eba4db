// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/candidate_solver.hpp"

#include <algorithm>
#include <utility>

#include "fairway/tracking/initial_guess.hpp"

namespace fairway {

namespace {

double merit(const MpcSolution& solution, const ControlProblem& problem) noexcept {
  return solution.cost + problem.violation_weight * solution.sum_violation;
}

bool is_better(const MpcSolution& a, const MpcSolution& b, const ControlProblem& problem) noexcept {
  const bool a_valid = a.status != SolveStatus::InvalidProblem;
  const bool b_valid = b.status != SolveStatus::InvalidProblem;
  if (a_valid != b_valid) return a_valid;
  return merit(a, problem) < merit(b, problem);
}

}  // namespace

void solve_candidates(ControlSolver& solver,
                      const TrackingSettings& settings,
                      const CorridorFollower& corridor,
                      const PathBands* bands,
                      const MpcSolution& last,
                      double shift,
                      ControlProblem& problem,
                      Candidates& candidates) noexcept {
  FixedVector<GuessedMotion, Candidates::capacity()> starts;
  if (last.horizon > 0) starts.push_back(shifted_guess(problem, last, shift));
  if (starts.empty() || settings.step_regions) starts.push_back(pursuit_guess(problem));
  candidates.clear();
  for (const GuessedMotion& start : starts) {
    if (bands != nullptr) {
      bind_along(*bands, start.poses, problem);
    } else if (settings.step_regions) {
      bind_along(corridor, start.poses, problem);
    } else {
      bind_to_current(corridor, problem);
    }
    candidates.push_back(solver.solve(problem, start.guess));
  }
  if (candidates.full() && is_better(candidates[1], candidates[0], problem))
    std::swap(candidates[0], candidates[1]);
}

void sample_commands(const MpcSolution& solution,
                     const Twist2& before,
                     double step_length,
                     double first,
                     double period,
                     std::array<Twist2, kMaxHorizon>& commands) noexcept {
  const auto n = static_cast<std::size_t>(solution.horizon);
  if (first == step_length && period == step_length) {
    std::copy_n(solution.commands.begin(), n, commands.begin());
    return;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double at = (first + static_cast<double>(i) * period) / step_length;
    const auto k = static_cast<std::size_t>(at);
    if (k >= n) {
      commands[i] = solution.commands[n - 1];
      continue;
    }
    const double share = at - static_cast<double>(k);
    const Twist2& from = k == 0 ? before : solution.commands[k - 1];
    const Twist2& to = solution.commands[k];
    commands[i] = {.linear = from.linear + share * (to.linear - from.linear),
                   .angular = from.angular + share * (to.angular - from.angular)};
  }
}

}  // namespace fairway
