// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "fairway/base/simd_math.hpp"
#include "fairway/mpc/interior_point/body/body_workspace.hpp"
#include "fairway/mpc/interior_point/constraints/soft_constraint_values.hpp"

// Values and slacks of the soft constraints of a body. Distant constraints are only watched, as in
// constraints/soft_constraint_values.hpp.

namespace fairway::interior_point {

/// Value of a constraint at four places of its mark, and for obstacles at the places before.
template <typename Lanes, typename Motion>
FAIRWAY_LANES Lanes side_value(const BodyConstraintBlock& c,
                               const BodyPoint<Motion>& p,
                               std::size_t k) noexcept {
  const MarkPath& mark = p.marks[c.mark];
  return c.offset +
         (c.normal_x * lanes<Lanes>(mark.x, k + 1) + c.normal_y * lanes<Lanes>(mark.y, k + 1));
}
template <typename Lanes, typename Motion>
FAIRWAY_LANES Lanes obstacle_value(const BodyConstraintBlock& c,
                                   const BodyPoint<Motion>& p,
                                   std::size_t k) noexcept {
  const MarkPath& mark = p.marks[c.mark];
  const Lanes dx = lanes<Lanes>(mark.x, k + 1) - c.center_x;
  const Lanes dy = lanes<Lanes>(mark.y, k + 1) - c.center_y;
  const Lanes before_x = lanes<Lanes>(mark.x, k) - c.center_before_x;
  const Lanes before_y = lanes<Lanes>(mark.y, k) - c.center_before_y;
  return (dx * dx + dy * dy) - c.retention * (before_x * before_x + before_y * before_y) - c.offset;
}

/// Evaluates all constraints at the poses of `point`.
template <typename Lanes, typename Motion>
FAIRWAY_LANES void evaluate_body_constraints(const BodyWorkspace<Motion>& w,
                                             BodyPoint<Motion>& point) noexcept {
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    const ConstraintRange& range = w.constraint_ranges[b];
    for (std::size_t i = range.corridor; i < range.barrier; ++i)
      point.constraints[i].value = side_value<Lanes>(w.soft_constraints[i], point, kLanes * b);
    for (std::size_t i = range.barrier; i < range.end; ++i)
      point.constraints[i].value = obstacle_value<Lanes>(w.soft_constraints[i], point, kLanes * b);
  }
}

/// Admits watched constraint i if it is near at `w.now`, as `admit_if_near` of a disc.
template <typename Lanes, typename Motion>
FAIRWAY_LANES bool admit_body_constraint(BodyWorkspace<Motion>& w,
                                         double mu,
                                         std::size_t i,
                                         const Lanes& value,
                                         std::size_t& first_watched) noexcept {
  if (!(least_of(value - w.soft_constraints[i].near) < 0.0)) return false;
  if (i != first_watched) std::swap(w.soft_constraints[i], w.soft_constraints[first_watched]);
  BodyConstraintBlock& constraint = w.soft_constraints[first_watched];
  start_soft_constraint(value, mu, w.problem->violation_weight, w.first_slack, constraint,
                        w.now->constraints[first_watched]);
  ++first_watched;
  return true;
}

/// Admits the watched constraints that `w.now` has approached.
/// @return Whether there were any.
template <typename Lanes, typename Motion>
FAIRWAY_LANES bool admit_body_constraints(BodyWorkspace<Motion>& w, double mu) noexcept {
  bool any = false;
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    ConstraintRange& range = w.constraint_ranges[b];
    const std::size_t k = kLanes * b;
    for (std::size_t i = range.watched_corridor; i < range.barrier; ++i) {
      const Lanes value = side_value<Lanes>(w.soft_constraints[i], *w.now, k);
      any = admit_body_constraint(w, mu, i, value, range.watched_corridor) || any;
    }
    for (std::size_t i = range.watched_barrier; i < range.end; ++i) {
      const Lanes value = obstacle_value<Lanes>(w.soft_constraints[i], *w.now, k);
      any = admit_body_constraint(w, mu, i, value, range.watched_barrier) || any;
    }
  }
  return any;
}

/// Sums `point` over the constraints; adds the logarithms of the slacks.
template <typename Lanes, typename Motion>
FAIRWAY_LANES void sum_body_constraints(const BodyWorkspace<Motion>& w,
                                        BodyPoint<Motion>& point,
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

/// Computes values and slacks of `w.trial` at `length` along the step, and their sums.
template <typename Lanes, typename Motion>
FAIRWAY_LANES void move_body_constraints(BodyWorkspace<Motion>& w,
                                         double length,
                                         LogSum<Lanes>& logs) noexcept {
  BodyPoint<Motion>& point = *w.trial;
  SoftConstraintSums<Lanes> sums;
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    const ConstraintRange& range = w.constraint_ranges[b];
    for (std::size_t i = range.corridor; i < range.watched_corridor; ++i) {
      const Lanes value = side_value<Lanes>(w.soft_constraints[i], point, kLanes * b);
      move_slacks(w.soft_constraints[i], w.now->constraints[i], length, value,
                  point.constraints[i]);
      sums.add(point.constraints[i], logs);
    }
    for (std::size_t i = range.barrier; i < range.watched_barrier; ++i) {
      const Lanes value = obstacle_value<Lanes>(w.soft_constraints[i], point, kLanes * b);
      move_slacks(w.soft_constraints[i], w.now->constraints[i], length, value,
                  point.constraints[i]);
      sums.add(point.constraints[i], logs);
    }
  }
  sums.store(point);
}

/// Raises every violation slack until its constraint has no residual.
template <typename Lanes, typename Motion>
FAIRWAY_LANES void absorb_body_residuals(BodyWorkspace<Motion>& w) noexcept {
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
