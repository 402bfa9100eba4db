// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "fairway/mpc/interior_point/body/body_bounds.hpp"
#include "fairway/mpc/interior_point/body/body_constraint_values.hpp"
#include "fairway/mpc/interior_point/body/body_constraints.hpp"
#include "fairway/mpc/interior_point/body/body_motion.hpp"
#include "fairway/mpc/interior_point/body/body_riccati.hpp"
#include "fairway/mpc/interior_point/body/body_rollout.hpp"
#include "fairway/mpc/interior_point/workspace/filter.hpp"

// The parts of one iteration for a body; those of a disc are in newton/ and line_search.hpp.

namespace fairway::interior_point {

/// Computes everything that the inputs of `point` determine, except slacks.
template <typename Lanes, typename Motion>
FAIRWAY_LANES void evaluate(const BodyWorkspace<Motion>& w, BodyPoint<Motion>& point) noexcept {
  roll_out<Lanes>(w, point);
  evaluate_body_constraints<Lanes>(w, point);
}

/// Sums `point` over all constraints, for the line search.
template <typename Lanes, typename Motion>
FAIRWAY_LANES void sum_constraints(const BodyWorkspace<Motion>& w,
                                   BodyPoint<Motion>& point) noexcept {
  LogSum<Lanes> logs;
  add_input_logs(w, point, logs);
  sum_body_constraints(w, point, logs);
  point.log_sum = logs.value();
}

/// Initialises slacks and duals at `mu`. @pre `w.now` is evaluated.
template <typename Lanes, typename Motion>
FAIRWAY_LANES void start(BodyWorkspace<Motion>& w, double mu) noexcept {
  start_input_bounds<Lanes>(w, mu);
  admit_body_constraints<Lanes>(w, mu);
  sum_constraints<Lanes>(w, *w.now);
}

/// Evaluates the optimality conditions at the iterate, and prepares the next Newton system.
template <typename Lanes, typename Motion>
[[nodiscard]] FAIRWAY_LANES OptimalityError linearise(BodyWorkspace<Motion>& w,
                                                      double mu) noexcept {
  ConstraintErrors<Lanes> errors;
  linearise_input_bounds(w, mu, errors);
  linearise_body_constraints(w, mu, errors);
  return optimality_error(errors, linearise_motion<Lanes>(w));
}

/// Solves the Newton system. If it is not convex, the curvature of constraints and motion is
/// omitted.
template <typename Lanes, typename Motion>
[[nodiscard]] FAIRWAY_LANES bool solve_newton_system(BodyWorkspace<Motion>& w, double mu) noexcept {
  constexpr double kLeastDamping = 1e-6;
  constexpr double kMostDamping = 1e12;
  bool exact = true;
  for (double damping = 0.0; damping < kMostDamping;) {
    build_body_stages<Lanes>(w, mu, exact);
    if (body_riccati_backward<Lanes>(w, damping)) {
      body_riccati_forward(w);
      w.step.convex = exact;
      return true;
    }
    if (!exact) damping = 10.0 * damping + kLeastDamping;
    exact = false;
  }
  return false;
}

/// Computes the pair of Eq. (S15).
template <typename Motion>
[[nodiscard]] Progress progress(const BodyWorkspace<Motion>& w,
                                double mu,
                                const BodyPoint<Motion>& p) noexcept {
  return {.barrier = p.cost + w.problem->violation_weight * p.violation_sum - mu * p.log_sum,
          .residual = p.residual_sum};
}

/// Computes `w.trial` at `length` along the step.
template <typename Lanes, typename Motion>
FAIRWAY_LANES void move_to_trial(BodyWorkspace<Motion>& w, double length) noexcept {
  move_inputs<Lanes>(w, length);
  roll_out<Lanes>(w, *w.trial);
  LogSum<Lanes> logs;
  add_input_logs(w, *w.trial, logs);
  move_body_constraints(w, length, logs);
  w.trial->log_sum = logs.value();
}

/// Searches along the Newton step in `w.step`, by the rules of `search_line` of a disc.
/// @return Whether a trial point was accepted and became `w.now`.
template <typename Lanes, typename Motion>
[[nodiscard]] FAIRWAY_LANES bool search_line(BodyWorkspace<Motion>& w,
                                             double mu,
                                             double fraction_to_boundary,
                                             Filter& filter) noexcept {
  const double used_by_bounds = step_input_bounds<Lanes>(w, mu);
  const auto soft = step_body_constraints<Lanes>(w, mu);
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

/// Moves along the step as far as the filter allows; see SimdKernels::take_step.
template <typename Lanes, typename Motion>
[[nodiscard]] FAIRWAY_LANES bool take_step(BodyWorkspace<Motion>& w,
                                           double mu,
                                           double fraction_to_boundary,
                                           Filter& filter) noexcept {
  bool changed = false;
  if (search_line<Lanes>(w, mu, fraction_to_boundary, filter)) {
    changed = admit_body_constraints<Lanes>(w, mu);
  } else {
    if (w.now->residual_sum <= kNoResidual) return false;
    absorb_body_residuals<Lanes>(w);
    changed = true;
  }
  if (changed) {
    sum_constraints<Lanes>(w, *w.now);
    filter.clear();
  }
  return true;
}

}  // namespace fairway::interior_point
