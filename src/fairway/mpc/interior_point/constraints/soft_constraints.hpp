// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "fairway/base/simd_math.hpp"
#include "fairway/mpc/interior_point/constraints/soft_constraint_values.hpp"
#include "fairway/mpc/interior_point/workspace/optimality.hpp"
#include "fairway/mpc/interior_point/workspace/workspace.hpp"

// Corridor sides and obstacles as soft constraints: c + e = s with penalty weight w on every e. The
// formulas are derived in docs/solver.md.

namespace fairway::interior_point {

// Lanes are steps here, and starts in lockstep/, where each lane has its own mu.

/// Moves the duals along their step, and keeps them within a factor of the central path, Eq. (S13).
template <typename Lanes, typename Barrier, typename Constraint>
FAIRWAY_LANES void move_duals(const SoftConstraintState& state,
                              const Barrier& mu,
                              double penalty_weight,
                              Constraint& constraint) noexcept {
  const Lanes slack = state.slack;
  const Lanes violation_slack = state.violation_slack;
  const Lanes old_y = constraint.dual;
  const Lanes inverse = mu / (slack * violation_slack);
  const Lanes central_y = violation_slack * inverse;
  const Lanes central_z = slack * inverse;
  const Lanes least_y = least(central_y * (1.0 / kCentrality), Lanes(0.5 * penalty_weight));
  const Lanes least_z = least(central_z * (1.0 / kCentrality), Lanes(0.5 * penalty_weight));
  const Lanes y = greatest(least(old_y + constraint.dual_change, kCentrality * central_y), least_y);
  const Lanes z = greatest(constraint.violation_dual - (y - old_y), least_z);
  constraint.dual = where_greater(z, least_z, y, penalty_weight - z);
  constraint.violation_dual = z;
}

/// Eliminates slack, violation slack and dual step of a constraint, Eq. (S5) and (S7), and records
/// its errors.
template <typename Lanes, typename Constraint>
FAIRWAY_LANES void eliminate(const SoftConstraintState& state,
                             Constraint& constraint,
                             ConstraintErrors<Lanes>& errors) noexcept {
  const Lanes slack = state.slack;
  const Lanes violation_slack = state.violation_slack;
  const Lanes y = constraint.dual;
  const Lanes z = constraint.violation_dual;
  const Lanes inverse = 1.0 / (slack * z + violation_slack * y);
  constraint.curvature = y * z * inverse;
  constraint.dual_by_mu = (z - y) * inverse;
  const Lanes sy = slack * y;
  const Lanes ez = violation_slack * z;
  errors.least_product = least(errors.least_product, least(sy, ez));
  errors.greatest_product = greatest(errors.greatest_product, greatest(sy, ez));
  errors.residual = greatest(errors.residual, magnitude(state.value + violation_slack - slack));
  errors.dual_sum += y;
  ++errors.num_soft_constraints;
}

/// PositionTerms as accumulated in registers.
template <typename Lanes>
struct PositionSums {
  Lanes xx, xy, yy, bend, dual_x, dual_y, target_x, target_y, by_mu_x, by_mu_y;

  /// Adds a constraint with gradient (x, y) by the position.
  template <typename Constraint>
  FAIRWAY_LANES void add(const Constraint& constraint,
                         const Lanes& target,
                         const Lanes& x,
                         const Lanes& y) noexcept {
    const Lanes along_x = constraint.curvature * x;
    xx += along_x * x;
    xy += along_x * y;
    yy += constraint.curvature * y * y;
    dual_x += constraint.dual * x;
    dual_y += constraint.dual * y;
    target_x += target * x;
    target_y += target * y;
    by_mu_x += constraint.dual_by_mu * x;
    by_mu_y += constraint.dual_by_mu * y;
  }
  FAIRWAY_LANES void store(PositionTerms& terms) const noexcept {
    terms.xx = xx;
    terms.xy = xy;
    terms.yy = yy;
    terms.bend = bend;
    terms.dual_x = dual_x;
    terms.dual_y = dual_y;
    terms.target_x = target_x;
    terms.target_y = target_y;
    terms.by_mu_x = by_mu_x;
    terms.by_mu_y = by_mu_y;
  }
};

/// Moves the duals along their step, and then computes the terms that the constraints add to the
/// model at `w.now`.
template <typename Lanes>
FAIRWAY_LANES void linearise_soft_constraints(Workspace& w,
                                              double mu,
                                              ConstraintErrors<Lanes>& errors) noexcept {
  const double penalty_weight = w.problem->violation_weight;
  const Point& point = *w.now;
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    const ConstraintRange& range = w.constraint_ranges[b];
    if (!range.has_corridors() && !range.has_barriers()) continue;
    PositionSums<Lanes> now{};
    for (std::size_t i = range.corridor; i < range.watched_corridor; ++i) {
      const SoftConstraintState& state = point.constraints[i];
      SoftConstraintBlock& constraint = w.soft_constraints[i];
      move_duals<Lanes>(state, mu, penalty_weight, constraint);
      eliminate(state, constraint, errors);
      const Lanes target = constraint.dual - Lanes(constraint.curvature) * state.value;
      now.add(constraint, target, constraint.normal_x, constraint.normal_y);
    }
    if (!range.has_barriers()) {
      now.store(w.model.now[b]);
      continue;
    }
    const auto p = positions_of<Lanes>(point.x, point.y, b);
    PositionSums<Lanes> before{};
    Lanes xx = 0.0;
    Lanes xy = 0.0;
    Lanes yx = 0.0;
    Lanes yy = 0.0;
    for (std::size_t i = range.barrier; i < range.watched_barrier; ++i) {
      const SoftConstraintState& state = point.constraints[i];
      SoftConstraintBlock& constraint = w.soft_constraints[i];
      move_duals<Lanes>(state, mu, penalty_weight, constraint);
      eliminate(state, constraint, errors);
      const Lanes retention = constraint.retention;
      const Lanes x = 2.0 * (p.x - constraint.centre_x);
      const Lanes y = 2.0 * (p.y - constraint.centre_y);
      const Lanes before_x = -2.0 * retention * (p.before_x - constraint.centre_before_x);
      const Lanes before_y = -2.0 * retention * (p.before_y - constraint.centre_before_y);
      constraint.normal_x = x;
      constraint.normal_y = y;
      constraint.normal_before_x = before_x;
      constraint.normal_before_y = before_y;
      const Lanes target = constraint.dual - Lanes(constraint.curvature) * state.value;
      now.add(constraint, target, x, y);
      before.add(constraint, target, before_x, before_y);
      now.bend -= 2.0 * Lanes(constraint.dual);
      before.bend += 2.0 * retention * constraint.dual;
      const Lanes along_x = constraint.curvature * x;
      const Lanes along_y = constraint.curvature * y;
      xx += along_x * before_x;
      xy += along_x * before_y;
      yx += along_y * before_x;
      yy += along_y * before_y;
    }
    now.store(w.model.now[b]);
    before.store(w.model.before[b]);
    CouplingTerms& coupling = w.model.coupling[b];
    coupling.xx = xx;
    coupling.xy = xy;
    coupling.yx = yx;
    coupling.yy = yy;
  }
}

/// Effect of the Newton step on the soft constraints, Eq. (S12).
template <typename Lanes>
struct SoftConstraintStep {
  Lanes used = 0.0;     ///< greatest share of any s that the step would use up
  Lanes slope = 0.0;    ///< derivative of the barrier and the penalty along the step
  Lanes product = 0.0;  ///< sum of y hat dc

  /// Adds a constraint that changes by `change`, to first order.
  template <typename Barrier, typename Constraint>
  FAIRWAY_LANES void add(const SoftConstraintState& state,
                         const Barrier& mu,
                         double penalty_weight,
                         const Lanes& change,
                         Constraint& constraint) noexcept {
    const Lanes slack = state.slack;
    const Lanes violation_slack = state.violation_slack;
    const Lanes curvature = constraint.curvature;
    const Lanes sy = slack * constraint.dual;
    const Lanes ez = violation_slack * constraint.violation_dual;
    const Lanes inverse = 1.0 / (sy * ez);
    const Lanes target_change = mu * Lanes(constraint.dual_by_mu) - curvature * state.value;
    const Lanes dy = target_change - curvature * change;
    const Lanes ds = (mu - slack * dy) * (ez * inverse) - 1.0;
    const Lanes de = (mu + violation_slack * dy) * (sy * inverse) - 1.0;
    constraint.dual_change = dy;
    constraint.slack_ratio = ds;
    constraint.violation_ratio = de;
    used = greatest(used, -ds);
    slope += penalty_weight * violation_slack * de - mu * (ds + de);
    product += (constraint.dual + target_change) * change;
  }
};

template <typename Lanes>
[[nodiscard]] FAIRWAY_LANES SoftConstraintStep<Lanes> step_soft_constraints(Workspace& w,
                                                                            double mu) noexcept {
  const double penalty_weight = w.problem->violation_weight;
  SoftConstraintStep<Lanes> step;
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    const ConstraintRange& range = w.constraint_ranges[b];
    const auto p = positions_of<Lanes>(w.step.x, w.step.y, b);
    for (std::size_t i = range.corridor; i < range.watched_corridor; ++i) {
      SoftConstraintBlock& constraint = w.soft_constraints[i];
      const Lanes change = p.x * constraint.normal_x + p.y * constraint.normal_y;
      step.add(w.now->constraints[i], mu, penalty_weight, change, constraint);
    }
    for (std::size_t i = range.barrier; i < range.watched_barrier; ++i) {
      SoftConstraintBlock& constraint = w.soft_constraints[i];
      const Lanes change =
          (p.x * constraint.normal_x + p.y * constraint.normal_y) +
          (p.before_x * constraint.normal_before_x + p.before_y * constraint.normal_before_y);
      step.add(w.now->constraints[i], mu, penalty_weight, change, constraint);
    }
  }
  return step;
}

}  // namespace fairway::interior_point
