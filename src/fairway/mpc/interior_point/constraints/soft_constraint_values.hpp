// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "fairway/base/simd_math.hpp"
#include "fairway/mpc/interior_point/workspace/workspace.hpp"

// Values and slacks of the soft constraints. Distant constraints are only watched: they are
// evaluated once per iteration and are not part of the problem.

namespace fairway::interior_point {

/// Positions of the poses of one block, and of the poses before them.
template <typename Lanes>
struct Positions {
  Lanes x, y, before_x, before_y;
};

template <typename Lanes>
FAIRWAY_LANES Positions<Lanes> positions_of(const PoseArray& x,
                                            const PoseArray& y,
                                            std::size_t b) noexcept {
  const std::size_t k = kLanes * b;
  return {.x = lanes<Lanes>(x, k + 1),
          .y = lanes<Lanes>(y, k + 1),
          .before_x = lanes<Lanes>(x, k),
          .before_y = lanes<Lanes>(y, k)};
}

/// Values of constraints, Eq. (S3).
template <typename Lanes>
FAIRWAY_LANES Lanes corridor_value(const SoftConstraintBlock& constraint,
                                   const Positions<Lanes>& p) noexcept {
  return constraint.offset + (constraint.normal_x * p.x + constraint.normal_y * p.y);
}
template <typename Lanes>
FAIRWAY_LANES Lanes barrier_value(const SoftConstraintBlock& constraint,
                                  const Positions<Lanes>& p) noexcept {
  const Lanes dx = p.x - constraint.centre_x;
  const Lanes dy = p.y - constraint.centre_y;
  const Lanes before_x = p.before_x - constraint.centre_before_x;
  const Lanes before_y = p.before_y - constraint.centre_before_y;
  return (dx * dx + dy * dy) - constraint.retention * (before_x * before_x + before_y * before_y) -
         constraint.offset;
}

/// Evaluates all constraints at the poses of `point`.
template <typename Lanes>
FAIRWAY_LANES void evaluate_soft_constraints(const Workspace& w, Point& point) noexcept {
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    const ConstraintRange& range = w.constraint_ranges[b];
    const auto p = positions_of<Lanes>(point.x, point.y, b);
    for (std::size_t i = range.corridor; i < range.barrier; ++i)
      point.constraints[i].value = corridor_value(w.soft_constraints[i], p);
    for (std::size_t i = range.barrier; i < range.end; ++i)
      point.constraints[i].value = barrier_value(w.soft_constraints[i], p);
  }
}

/// Initialises the slacks and duals of a constraint of value `value` at `mu`.
template <typename Lanes, typename Constraint>
FAIRWAY_LANES void start_soft_constraint(const Lanes& value,
                                         double mu,
                                         double penalty_weight,
                                         double first_slack,
                                         Constraint& constraint,
                                         SoftConstraintState& state) noexcept {
  const Lanes slack = greatest(value, Lanes(first_slack));
  const Lanes dual = least(mu / slack, Lanes(0.5 * penalty_weight));
  constraint.dual = dual;
  constraint.violation_dual = penalty_weight - dual;
  constraint.dual_change = Lanes(0.0);
  state.value = value;
  state.slack = slack;
  state.violation_slack = mu / (penalty_weight - dual);
}

/// Admits watched constraint i if it is near at `w.now`, where it has value `value`. It is swapped
/// with the first watched one and initialised at `mu`.
template <typename Lanes>
FAIRWAY_LANES void admit_if_near(Workspace& w,
                                 double mu,
                                 std::size_t i,
                                 const Lanes& value,
                                 std::size_t& first_watched) noexcept {
  if (!(least_of(value - w.soft_constraints[i].near) < 0.0)) return;
  std::swap(w.soft_constraints[i], w.soft_constraints[first_watched]);
  start_soft_constraint(value, mu, w.problem->violation_weight, w.first_slack,
                        w.soft_constraints[first_watched], w.now->constraints[first_watched]);
  ++first_watched;
}

/// Admits the watched constraints that `w.now` has approached into the problem, with initial slacks
/// and duals at `mu`.
/// @return Whether there were any.
template <typename Lanes>
FAIRWAY_LANES bool admit_near_constraints(Workspace& w, double mu) noexcept {
  bool any = false;
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    ConstraintRange& range = w.constraint_ranges[b];
    const auto p = positions_of<Lanes>(w.now->x, w.now->y, b);
    Lanes closest = 1.0;
    for (std::size_t i = range.watched_corridor; i < range.barrier; ++i)
      closest =
          least(closest, corridor_value(w.soft_constraints[i], p) - w.soft_constraints[i].near);
    for (std::size_t i = range.watched_barrier; i < range.end; ++i)
      closest =
          least(closest, barrier_value(w.soft_constraints[i], p) - w.soft_constraints[i].near);
    if (!(least_of(closest) < 0.0)) continue;
    any = true;
    for (std::size_t i = range.watched_corridor; i < range.barrier; ++i)
      admit_if_near(w, mu, i, corridor_value(w.soft_constraints[i], p), range.watched_corridor);
    for (std::size_t i = range.watched_barrier; i < range.end; ++i)
      admit_if_near(w, mu, i, barrier_value(w.soft_constraints[i], p), range.watched_barrier);
  }
  return any;
}

/// Sums over soft constraints, for the line search.
template <typename Lanes>
struct SoftConstraintSums {
  Lanes violation_slack = 0.0;
  Lanes residual = 0.0;

  FAIRWAY_LANES void add(const SoftConstraintState& state, LogSum<Lanes>& logs) noexcept {
    logs.add(Lanes(state.slack) * state.violation_slack);
    violation_slack += state.violation_slack;
    residual += magnitude(Lanes(state.value) + state.violation_slack - state.slack);
  }
  template <typename AnyPoint>
  FAIRWAY_LANES void store(AnyPoint& point) const noexcept {
    point.violation_sum = sum_of(violation_slack);
    point.residual_sum = sum_of(residual);
  }
};

/// Computes the sums of `point` over the constraints; adds the logarithms of s and e.
template <typename Lanes>
FAIRWAY_LANES void sum_soft_constraints(const Workspace& w,
                                        Point& point,
                                        LogSum<Lanes>& logs) noexcept {
  SoftConstraintSums<Lanes> sums;
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    const ConstraintRange& range = w.constraint_ranges[b];
    for (std::size_t i = range.corridor; i < range.watched_corridor; ++i)
      sums.add(point.constraints[i], logs);
    for (std::size_t i = range.barrier; i < range.watched_barrier; ++i)
      sums.add(point.constraints[i], logs);
  }
  sums.store(point);
}

/// Computes the value and slacks of one constraint at `length` along the step. Slacks that are too
/// small for their constraint are reset, which lowers every merit function. Violation slacks are
/// usually tiny and must not shorten the step; one that would be used up keeps a part of itself.
template <typename Lanes, typename Constraint>
FAIRWAY_LANES void move_slacks(const Constraint& constraint,
                               const SoftConstraintState& now,
                               double length,
                               const Lanes& value,
                               SoftConstraintState& trial) noexcept {
  constexpr double kLeastPart = 1e-3;
  const Lanes part = greatest(1.0 + length * Lanes(constraint.violation_ratio), Lanes(kLeastPart));
  const Lanes violation_slack = now.violation_slack * part;
  const Lanes slack = now.slack * (1.0 + length * Lanes(constraint.slack_ratio));
  trial.value = value;
  trial.slack = greatest(slack, value + violation_slack);
  trial.violation_slack = violation_slack;
}

/// Computes values and slacks of `w.trial` at `length` along the step, given its poses, and their
/// sums.
template <typename Lanes>
FAIRWAY_LANES void move_soft_constraints(Workspace& w,
                                         double length,
                                         LogSum<Lanes>& logs) noexcept {
  Point& point = *w.trial;
  SoftConstraintSums<Lanes> sums;
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    const ConstraintRange& range = w.constraint_ranges[b];
    const auto p = positions_of<Lanes>(point.x, point.y, b);
    for (std::size_t i = range.corridor; i < range.watched_corridor; ++i) {
      move_slacks(w.soft_constraints[i], w.now->constraints[i], length,
                  corridor_value(w.soft_constraints[i], p), point.constraints[i]);
      sums.add(point.constraints[i], logs);
    }
    for (std::size_t i = range.barrier; i < range.watched_barrier; ++i) {
      move_slacks(w.soft_constraints[i], w.now->constraints[i], length,
                  barrier_value(w.soft_constraints[i], p), point.constraints[i]);
      sums.add(point.constraints[i], logs);
    }
  }
  sums.store(point);
}

/// Raises every e until its constraint has no residual.
template <typename Lanes>
FAIRWAY_LANES void absorb_residuals(Workspace& w) noexcept {
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    const ConstraintRange& range = w.constraint_ranges[b];
    for (std::size_t i = range.corridor; i < range.watched_barrier; ++i) {
      if (i >= range.watched_corridor && i < range.barrier) continue;
      SoftConstraintState& state = w.now->constraints[i];
      state.violation_slack =
          greatest(Lanes(state.violation_slack), Lanes(state.slack) - state.value);
      w.soft_constraints[i].dual_change = Lanes(0.0);
    }
  }
}

}  // namespace fairway::interior_point
