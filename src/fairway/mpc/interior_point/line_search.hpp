// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <utility>

#include "fairway/mpc/interior_point/constraints/bounds.hpp"
#include "fairway/mpc/interior_point/constraints/soft_constraint_values.hpp"
#include "fairway/mpc/interior_point/constraints/soft_constraints.hpp"
#include "fairway/mpc/interior_point/newton/trajectory.hpp"
#include "fairway/mpc/interior_point/workspace/filter.hpp"
#include "fairway/mpc/interior_point/workspace/workspace.hpp"

namespace fairway::interior_point {

/// Computes everything that the commands of `point` determine, except slacks.
template <typename Lanes>
FAIRWAY_LANES void evaluate(const Workspace& w, Point& point) noexcept {
  roll_out<Lanes>(w, point);
  evaluate_soft_constraints<Lanes>(w, point);
}

/// Sums `point` over all constraints, for the line search.
template <typename Lanes>
FAIRWAY_LANES void sum_constraints(const Workspace& w, Point& point) noexcept {
  LogSum<Lanes> logs;
  add_bound_logs(w, point, logs);
  sum_soft_constraints(w, point, logs);
  point.log_sum = logs.value();
}

/// Initialises slacks and duals at `mu`. @pre `w.now` is evaluated.
template <typename Lanes>
FAIRWAY_LANES void start(Workspace& w, double mu) noexcept {
  start_bounds<Lanes>(w, mu);
  admit_near_constraints<Lanes>(w, mu);
  sum_constraints<Lanes>(w, *w.now);
}

/// Computes `w.trial` at `length` along the step.
template <typename Lanes>
FAIRWAY_LANES void move_to_trial(Workspace& w, double length) noexcept {
  move_commands<Lanes>(w, length);
  roll_out<Lanes>(w, *w.trial);
  LogSum<Lanes> logs;
  add_bound_logs(w, *w.trial, logs);
  move_soft_constraints(w, length, logs);
  w.trial->log_sum = logs.value();
}

/// Computes the pair of Eq. (S15).
inline Progress progress(const Workspace& w, double mu, const Point& p) noexcept {
  return {.barrier = p.cost + w.problem->violation_weight * p.violation_sum - mu * p.log_sum,
          .residual = p.residual_sum};
}

/// Computes the steps of all constraints for the Newton step in `w.step`, and searches along it.
/// @return Whether a trial point was accepted and became `w.now`.
template <typename Lanes>
[[nodiscard]] FAIRWAY_LANES bool search_line(Workspace& w,
                                             double mu,
                                             double fraction_to_boundary,
                                             Filter& filter) noexcept {
  const double used_by_bounds = step_bounds<Lanes>(w, mu);
  const auto soft = step_soft_constraints<Lanes>(w, mu);
  const double used = std::max(used_by_bounds, greatest_of(soft.used));
  const LineSearch search(progress(w, mu, *w.now),
                          w.step.slope + sum_of(soft.product + soft.slope));
  double length = used > fraction_to_boundary ? fraction_to_boundary / used : 1.0;
  for (int halvings = 0; halvings <= kMaxHalvings; ++halvings, length *= 0.5) {
    move_to_trial<Lanes>(w, length);
    if (!search.accepts(progress(w, mu, *w.trial), length, filter)) continue;
    std::swap(w.now, w.trial);
    return true;
  }
  return false;
}

/// See SimdKernels.
template <typename Lanes>
[[nodiscard]] FAIRWAY_LANES bool take_step(Workspace& w,
                                           double mu,
                                           double fraction_to_boundary,
                                           Filter& filter) noexcept {
  bool changed = false;  // whether the merit function is another one now
  if (search_line<Lanes>(w, mu, fraction_to_boundary, filter)) {
    changed = admit_near_constraints<Lanes>(w, mu);
  } else {
    if (w.now->residual_sum <= kNoResidual) return false;
    absorb_residuals<Lanes>(w);
    changed = true;
  }
  if (changed) {
    sum_constraints<Lanes>(w, *w.now);
    filter.clear();
  }
  return true;
}

}  // namespace fairway::interior_point
