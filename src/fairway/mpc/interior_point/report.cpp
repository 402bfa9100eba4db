// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/interior_point/report.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/mpc/interior_point/barrier_iteration.hpp"

namespace fairway::interior_point {
namespace {

// Multipliers below this do not limit the solution; inactive constraints have about tolerance /
// slack.
constexpr double kActive = 1e-3;

constexpr std::array<ConstraintKind, 4> kBoundKinds = {
    ConstraintKind::LinearSpeed, ConstraintKind::AngularSpeed, ConstraintKind::LinearChange,
    ConstraintKind::AngularChange};

ConstraintName limiting_constraint(const Workspace& w) noexcept {
  ConstraintName name;
  double most = kActive;
  // Considers the duals of four constraints, the first of which is `first`.
  const auto take = [&](const Lanes128& dual, const ConstraintName& first) {
    if (!(greatest_of(dual) > most)) return;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (dual[lane] <= most) continue;
      most = dual[lane];
      name = first;
      name.step += static_cast<int>(lane);
    }
  };
  for (std::size_t kind = 0; kind < w.num_bounds; ++kind) {
    for (std::size_t b = 0; b < w.num_blocks; ++b) {
      const Bounds::Block& block = w.bounds[kind].blocks[b];
      take(greatest(Lanes128(block.dual_low), Lanes128(block.dual_high)),
           {.kind = kBoundKinds[kind], .step = static_cast<int>(kLanes * b), .index = 0});
    }
  }
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    const ConstraintRange& range = w.constraint_ranges[b];
    for (std::size_t i = range.corridor; i < range.watched_barrier; ++i) {
      if (i >= range.watched_corridor && i < range.barrier) continue;
      const SoftConstraintBlock& constraint = w.soft_constraints[i];
      take(constraint.dual,
           {.kind = constraint.kind, .step = constraint.first_step, .index = constraint.index});
    }
  }
  return name;
}

// The difference of a non-finite number from itself is NaN. The start position is added later and
// is far smaller.
bool all_finite(const Workspace& w, const Point& p) noexcept {
  Lanes128 difference = 0.0;
  for (const PoseArray* array :
       {p.commands.data(), &p.commands[kAngular], &p.x, &p.y, &p.heading}) {
    for (std::size_t k = 1; k <= kLanes * w.num_blocks; k += kLanes)
      difference += lanes<Lanes128>(*array, k) - lanes<Lanes128>(*array, k);
  }
  return sum_of(difference) == 0.0;
}

}  // namespace

void clip_commands(const Workspace& w, Point& point) noexcept {
  for (std::size_t j = 0; j < 2; ++j)
    clip_to_limits(w.limits[j], w.problem->horizon, point.commands[j].data() + 1);
}

bool report(const Workspace& w, MpcSolution& solution) noexcept {
  const ControlProblem& problem = *w.problem;
  const Point& p = *w.now;
  solution.horizon = problem.horizon;
  solution.cost = p.cost;
  const Violations violations = violations_of(w, p);
  solution.max_violation = violations.greatest;
  solution.sum_violation = violations.sum;
  const double x = problem.start.position.x();
  const double y = problem.start.position.y();
  for (std::size_t k = 0; k < w.horizon; ++k) {
    solution.commands[k].linear = p.commands[kLinear][k + 1];
    solution.commands[k].angular = p.commands[kAngular][k + 1];
  }
  for (std::size_t k = 0; k <= w.horizon; ++k) {
    solution.poses[k].position.x() = x + p.x[k];
    solution.poses[k].position.y() = y + p.y[k];
    solution.poses[k].heading = p.heading[k] + w.full_turns;
  }
  solution.limiting = limiting_constraint(w);
  return std::isfinite(p.cost) && std::isfinite(solution.sum_violation) && all_finite(w, p);
}

void report_invalid(const ControlProblem& problem, MpcSolution& solution) noexcept {
  const auto finite_or_zero = [](double a) { return std::isfinite(a) ? a : 0.0; };
  const Pose2 start = {.position = {finite_or_zero(problem.start.position.x()),
                                    finite_or_zero(problem.start.position.y())},
                       .heading = finite_or_zero(problem.start.heading)};
  solution = {};
  solution.status = SolveStatus::InvalidProblem;
  solution.horizon = std::clamp(problem.horizon, 0, kMaxHorizon);
  solution.commands.fill(Twist2{});
  solution.poses.fill(start);
}

}  // namespace fairway::interior_point
