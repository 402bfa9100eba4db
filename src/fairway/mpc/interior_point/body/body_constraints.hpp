// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/base/simd_math.hpp"
#include "fairway/mpc/interior_point/body/body_constraint_values.hpp"
#include "fairway/mpc/interior_point/constraints/soft_constraints.hpp"

// The soft constraints of a body in the model. Duals are eliminated as for a disc; gradients have a
// third part, by the turn about the origin.

namespace fairway::interior_point {

/// PoseTerms as accumulated in registers.
template <typename Lanes>
struct PoseSums {
  Lanes xx, xy, yy, xh, yh, hh, bend, bend_xh, bend_yh, bend_hh;
  Lanes dual_x, dual_y, dual_h, target_x, target_y, target_h, by_mu_x, by_mu_y, by_mu_h;

  /// Adds a constraint with gradient (x, y, h).
  FAIRWAY_LANES void add(const BodyConstraintBlock& constraint,
                         const Lanes& target,
                         const Lanes& x,
                         const Lanes& y,
                         const Lanes& h) noexcept {
    const Lanes along_x = constraint.curvature * x;
    const Lanes along_y = constraint.curvature * y;
    xx += along_x * x;
    xy += along_x * y;
    yy += along_y * y;
    xh += along_x * h;
    yh += along_y * h;
    hh += constraint.curvature * (h * h);
    dual_x += constraint.dual * x;
    dual_y += constraint.dual * y;
    dual_h += constraint.dual * h;
    target_x += target * x;
    target_y += target * y;
    target_h += target * h;
    by_mu_x += constraint.dual_by_mu * x;
    by_mu_y += constraint.dual_by_mu * y;
    by_mu_h += constraint.dual_by_mu * h;
  }
  /// Adds `factor` times the curvature of |V - o|^2 of a mark V, at `offset` from the reference
  /// point and `away` from o.
  FAIRWAY_LANES void bend_square(const Lanes& factor,
                                 const Lanes& x,
                                 const Lanes& y,
                                 const Lanes& away_offset) noexcept {
    const Lanes twice = 2.0 * factor;
    bend += twice;
    bend_xh -= twice * y;
    bend_yh += twice * x;
    bend_hh += twice * ((x * x + y * y) - away_offset);
  }
  FAIRWAY_LANES void store(PoseTerms& t) const noexcept {
    t.xx = xx;
    t.xy = xy;
    t.yy = yy;
    t.xh = xh;
    t.yh = yh;
    t.hh = hh;
    t.bend = bend;
    t.bend_xh = bend_xh;
    t.bend_yh = bend_yh;
    t.bend_hh = bend_hh;
    t.dual_x = dual_x;
    t.dual_y = dual_y;
    t.dual_h = dual_h;
    t.target_x = target_x;
    t.target_y = target_y;
    t.target_h = target_h;
    t.by_mu_x = by_mu_x;
    t.by_mu_y = by_mu_y;
    t.by_mu_h = by_mu_h;
  }
};

/// Adds the sides of the rectangles in block b.
template <typename Lanes, typename Motion>
FAIRWAY_LANES void linearise_sides(BodyWorkspace<Motion>& w,
                                   std::size_t b,
                                   double mu,
                                   PoseSums<Lanes>& now,
                                   ConstraintErrors<Lanes>& errors) noexcept {
  const BodyPoint<Motion>& point = *w.now;
  const std::size_t k = kLanes * b + 1;
  const Lanes pose_x = lanes<Lanes>(point.x, k);
  const Lanes pose_y = lanes<Lanes>(point.y, k);
  const ConstraintRange& range = w.constraint_ranges[b];
  for (std::size_t i = range.corridor; i < range.watched_corridor; ++i) {
    const SoftConstraintState& state = point.constraints[i];
    BodyConstraintBlock& constraint = w.soft_constraints[i];
    move_duals<Lanes>(state, mu, w.problem->violation_weight, constraint);
    eliminate(state, constraint, errors);
    const MarkPath& mark = point.marks[constraint.mark];
    const Lanes x = lanes<Lanes>(mark.x, k);
    const Lanes y = lanes<Lanes>(mark.y, k);
    const Lanes h = constraint.normal_y * x - constraint.normal_x * y;
    constraint.normal_h = h;
    const Lanes target = constraint.dual - Lanes(constraint.curvature) * state.value;
    now.add(constraint, target, constraint.normal_x, constraint.normal_y, h);
    now.bend_hh +=
        constraint.dual * (constraint.normal_x * (x - pose_x) + constraint.normal_y * (y - pose_y));
  }
}

/// Adds the obstacles in block b.
template <typename Lanes, typename Motion>
FAIRWAY_LANES void linearise_obstacles(BodyWorkspace<Motion>& w,
                                       std::size_t b,
                                       double mu,
                                       PoseSums<Lanes>& now,
                                       ConstraintErrors<Lanes>& errors) noexcept {
  const BodyPoint<Motion>& point = *w.now;
  const std::size_t k = kLanes * b + 1;
  const ConstraintRange& range = w.constraint_ranges[b];
  PoseSums<Lanes> before{};
  std::array<std::array<Lanes, 3>, 3> coupling{};
  for (std::size_t i = range.barrier; i < range.watched_barrier; ++i) {
    const SoftConstraintState& state = point.constraints[i];
    BodyConstraintBlock& constraint = w.soft_constraints[i];
    move_duals<Lanes>(state, mu, w.problem->violation_weight, constraint);
    eliminate(state, constraint, errors);
    const MarkPath& mark = point.marks[constraint.mark];
    const Lanes retention = constraint.retention;
    const Lanes x = lanes<Lanes>(mark.x, k);
    const Lanes y = lanes<Lanes>(mark.y, k);
    const Lanes before_x = lanes<Lanes>(mark.x, k - 1);
    const Lanes before_y = lanes<Lanes>(mark.y, k - 1);
    const Lanes dx = x - constraint.center_x;
    const Lanes dy = y - constraint.center_y;
    const Lanes ex = before_x - constraint.center_before_x;
    const Lanes ey = before_y - constraint.center_before_y;
    const std::array<Lanes, 3> g = {2.0 * dx, 2.0 * dy, 2.0 * (dy * x - dx * y)};
    const Lanes scale = -2.0 * retention;
    const std::array<Lanes, 3> h = {scale * ex, scale * ey,
                                    scale * (ey * before_x - ex * before_y)};
    constraint.normal_x = g[0];
    constraint.normal_y = g[1];
    constraint.normal_h = g[2];
    constraint.normal_before_x = h[0];
    constraint.normal_before_y = h[1];
    constraint.normal_before_h = h[2];
    const Lanes target = constraint.dual - Lanes(constraint.curvature) * state.value;
    now.add(constraint, target, g[0], g[1], g[2]);
    before.add(constraint, target, h[0], h[1], h[2]);
    now.bend_square(-Lanes(constraint.dual), x, y,
                    dx * (x - lanes<Lanes>(point.x, k)) + dy * (y - lanes<Lanes>(point.y, k)));
    before.bend_square(retention * constraint.dual, before_x, before_y,
                       ex * (before_x - lanes<Lanes>(point.x, k - 1)) +
                           ey * (before_y - lanes<Lanes>(point.y, k - 1)));
    for (std::size_t r = 0; r < 3; ++r) {
      const Lanes along = constraint.curvature * g[r];
      for (std::size_t c = 0; c < 3; ++c)
        coupling[r][c] += along * h[c];
    }
  }
  before.store(w.model.before[b]);
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c)
      w.model.coupling[b].entries[r][c] = coupling[r][c];
  }
}

/// Moves the duals along their step, and then computes the terms that the constraints add to the
/// model at `w.now`.
template <typename Lanes, typename Motion>
FAIRWAY_LANES void linearise_body_constraints(BodyWorkspace<Motion>& w,
                                              double mu,
                                              ConstraintErrors<Lanes>& errors) noexcept {
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    const ConstraintRange& range = w.constraint_ranges[b];
    if (!range.has_corridors() && !range.has_barriers()) continue;
    PoseSums<Lanes> now{};
    linearise_sides(w, b, mu, now, errors);
    if (range.has_barriers()) linearise_obstacles(w, b, mu, now, errors);
    now.store(w.model.now[b]);
  }
}

/// Computes the effect of the Newton step on the soft constraints.
template <typename Lanes, typename Motion>
[[nodiscard]] FAIRWAY_LANES SoftConstraintStep<Lanes> step_body_constraints(
    BodyWorkspace<Motion>& w, double mu) noexcept {
  const double penalty_weight = w.problem->violation_weight;
  SoftConstraintStep<Lanes> step;
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    const ConstraintRange& range = w.constraint_ranges[b];
    const std::size_t k = kLanes * b + 1;
    const Lanes x = lanes<Lanes>(w.step.x, k);
    const Lanes y = lanes<Lanes>(w.step.y, k);
    const Lanes h = lanes<Lanes>(w.step.turn, k);
    for (std::size_t i = range.corridor; i < range.watched_corridor; ++i) {
      BodyConstraintBlock& c = w.soft_constraints[i];
      const Lanes change = x * c.normal_x + y * c.normal_y + h * c.normal_h;
      step.add(w.now->constraints[i], mu, penalty_weight, change, c);
    }
    if (!range.has_barriers()) continue;
    const Lanes before_x = lanes<Lanes>(w.step.x, k - 1);
    const Lanes before_y = lanes<Lanes>(w.step.y, k - 1);
    const Lanes before_h = lanes<Lanes>(w.step.turn, k - 1);
    for (std::size_t i = range.barrier; i < range.watched_barrier; ++i) {
      BodyConstraintBlock& c = w.soft_constraints[i];
      const Lanes change = (x * c.normal_x + y * c.normal_y + h * c.normal_h) +
                           (before_x * c.normal_before_x + before_y * c.normal_before_y +
                            before_h * c.normal_before_h);
      step.add(w.now->constraints[i], mu, penalty_weight, change, c);
    }
  }
  return step;
}

}  // namespace fairway::interior_point
