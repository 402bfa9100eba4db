// SPDX-License-Identifier: Apache-2.0
// The iteration and the penalty that the solvers of all robots share, docs/solver.md section 6.
#pragma once

#include "fairway/base/simd_math.hpp"
#include "fairway/mpc/interior_point/workspace/filter.hpp"
#include "fairway/mpc/interior_point/workspace/iteration_rules.hpp"
#include "fairway/mpc/interior_point/workspace/settings.hpp"
#include "fairway/mpc/solution.hpp"

namespace fairway::interior_point {

/// Violations of the soft constraints at a point; the slacks do not matter.
struct Violations {
  double sum = 0.0;
  double greatest = 0.0;  ///< of one of them
};

template <typename Workspace, typename Point>
[[nodiscard]] Violations violations_of(const Workspace& w, const Point& point) noexcept {
  Lanes128 sum = 0.0;
  Lanes128 worst = 0.0;
  for (std::size_t i = 0; i < w.num_soft_constraints; ++i) {
    const Lanes128 violation = greatest(-Lanes128(point.constraints[i].value), Lanes128(0.0));
    sum += violation;
    worst = greatest(worst, violation);
  }
  return {.sum = sum_of(sum), .greatest = greatest_of(worst)};
}

/// Returns the cost plus the penalty of all violations at `point`, Eq. (S2).
template <typename Workspace, typename Point>
[[nodiscard]] double penalised_cost(const Workspace& w, const Point& point) noexcept {
  return point.cost + w.problem->violation_weight * violations_of(w, point).sum;
}

/// Iterates from `w.now` until its error is below the tolerance.
/// @param is_rounding  Whether the step in `w.step` changes no command by more than rounding.
/// @param iterations  Set to the number of Newton steps.
template <typename Kernels, typename Workspace, typename Rounding>
[[nodiscard]] SolveStatus iterate_barrier(const Kernels& kernels,
                                          const InteriorPointSettings& settings,
                                          const Rounding& is_rounding,
                                          Workspace& w,
                                          int& iterations) noexcept {
  const double least = least_barrier(settings);
  w.step.convex = true;
  kernels.evaluate(w, *w.now);
  double mu =
      first_barrier(settings, violations_of(w, *w.now).greatest, w.problem->violation_weight);
  w.first_slack = settings.first_slack;
  kernels.start(w, mu);
  Filter filter;
  for (iterations = 0;; ++iterations) {
    const OptimalityError error = kernels.linearise(w, mu);
    if (error.at(0.0) <= settings.tolerance && error.residual <= kResidualTolerance)
      return SolveStatus::Solved;
    if (iterations >= settings.max_iterations) return SolveStatus::IterationLimit;

    const double next = next_barrier(mu, least, error);
    const bool lowered = next < mu;
    if (lowered) filter.clear();
    mu = next;
    if (!kernels.solve_newton_system(w, mu)) return SolveStatus::Stalled;
    if (!lowered && is_rounding(w)) return SolveStatus::Stalled;
    if (!kernels.take_step(w, mu, fraction_of_slack(mu, error), filter))
      return SolveStatus::Stalled;
  }
}

}  // namespace fairway::interior_point
