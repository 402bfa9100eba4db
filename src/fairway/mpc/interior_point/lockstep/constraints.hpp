// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/interior_point/constraints/soft_constraints.hpp"
#include "fairway/mpc/interior_point/lockstep/lockstep.hpp"

// Command bounds and soft constraints of four starts; the formulas are those of constraints/.

namespace fairway::interior_point::lockstep {

/// The quantity that constraints of kind `kind` (index of Workspace::bounds) bound at step k.
template <typename Lanes>
FAIRWAY_LANES Lanes bounded(const std::array<std::array<Pack4d, kMaxHorizon + 2>, 2>& commands,
                            std::size_t kind,
                            std::size_t k) noexcept {
  const auto& command = commands[kind % 2];
  const Lanes now = command[k + 1];
  return kind < 2 ? now : now - command[k];
}

template <typename Lanes>
FAIRWAY_LANES BoundSlacks<Lanes> bound_slacks(const Workspace& w,
                                              const FourPoints& p,
                                              std::size_t kind,
                                              std::size_t k) noexcept {
  constexpr double kLeastSlack = 1e-15;  // avoids 0 after rounding at a bound
  const Bounds::Block& block = w.bounds[kind].blocks[k / kLanes];
  const Lanes t = bounded<Lanes>(p.commands, kind, k);
  return {.below = greatest(t - block.low[k % kLanes], Lanes(kLeastSlack)),
          .above = greatest(block.high[k % kLanes] - t, Lanes(kLeastSlack))};
}

/// Initialises the duals of the bounds on the central path.
template <typename Lanes>
FAIRWAY_LANES void start_bounds(Lockstep& s, const Lanes& mu) noexcept {
  const Workspace& w = *s.problem;
  for (std::size_t kind = 0; kind < w.num_bounds; ++kind) {
    for (std::size_t k = 0; k < w.horizon; ++k) {
      const auto slack = bound_slacks<Lanes>(w, s.points[s.now], kind, k);
      s.bounds[kind][k].dual_low = mu / slack.below;
      s.bounds[kind][k].dual_high = mu / slack.above;
    }
  }
}

/// Values of constraints at the pose after a step and the pose before it, Eq. (S3).
template <typename Lanes>
FAIRWAY_LANES Lanes side_value(const NearConstraint& c, const Lanes& x, const Lanes& y) noexcept {
  return c.offset + (c.normal_x * x + c.normal_y * y);
}
template <typename Lanes>
FAIRWAY_LANES Lanes obstacle_value(const NearConstraint& c,
                                   const Lanes& x,
                                   const Lanes& y,
                                   const Lanes& before_x,
                                   const Lanes& before_y) noexcept {
  const Lanes dx = x - c.centre_x;
  const Lanes dy = y - c.centre_y;
  const Lanes rx = before_x - c.centre_before_x;
  const Lanes ry = before_y - c.centre_before_y;
  return (dx * dx + dy * dy) - c.retention * (rx * rx + ry * ry) - c.offset;
}

/// Copies the geometry of one step of a constraint of the workspace.
inline void load_geometry(const SoftConstraintBlock& block,
                          std::size_t lane,
                          NearConstraint& c) noexcept {
  c.offset = block.offset[lane];
  if (block.kind == ConstraintKind::Corridor) {
    c.normal_x = block.normal_x[lane];
    c.normal_y = block.normal_y[lane];
    return;
  }
  c.centre_x = block.centre_x[lane];
  c.centre_y = block.centre_y[lane];
  c.centre_before_x = block.centre_before_x[lane];
  c.centre_before_y = block.centre_before_y[lane];
  c.retention = block.retention[lane];
}

/// Initialises slacks and duals of one constraint.
template <typename Lanes>
FAIRWAY_LANES void start_constraint(Lockstep& s, NearConstraint& c, const Lanes& mu) noexcept {
  const double penalty_weight = s.problem->problem->violation_weight;
  SoftConstraintState& state = c.states[s.now];
  const Lanes value = state.value;
  const Lanes slack = greatest(value, Lanes(s.first_slack));
  const Lanes dual = least(mu / slack, Lanes(0.5 * penalty_weight));
  c.dual = dual;
  c.violation_dual = penalty_weight - dual;
  c.dual_change = Lanes(0.0);
  state.slack = slack;
  state.violation_slack = mu / (penalty_weight - dual);
}

/// Admits all constraints that some start has come near. The new ones have values, but no slacks.
/// @return The greatest violation of each start.
template <typename Lanes>
FAIRWAY_LANES Lanes admit_near(Lockstep& s, bool start_them, const Lanes& mu, bool& any) noexcept {
  const Workspace& w = *s.problem;
  const FourPoints& p = s.points[s.now];
  Lanes violation = 0.0;
  s.moved = Lanes(0.0);
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    const ConstraintRange& range = w.constraint_ranges[b];
    for (std::size_t i = range.corridor; i < range.end; ++i) {
      const SoftConstraintBlock& block = w.soft_constraints[i];
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const std::size_t k = kLanes * b + lane;
        if (k >= w.horizon) break;
        if ((static_cast<unsigned>(s.admitted[i]) >> lane & 1U) != 0) continue;
        NearSet& near = s.near[k];
        const bool is_side = i < range.barrier;
        NearConstraint& c = near.constraints[is_side ? near.sides : near.end()];
        load_geometry(block, lane, c);
        const Lanes x = p.x[k + 1];
        const Lanes y = p.y[k + 1];
        const Lanes value =
            is_side ? side_value(c, x, y) : obstacle_value(c, x, y, Lanes(p.x[k]), Lanes(p.y[k]));
        violation = greatest(violation, -value);
        if (!(least_of(value) < block.near[lane])) continue;
        s.admitted[i] = static_cast<std::uint8_t>(s.admitted[i] | 1U << lane);
        c.states[s.now].value = value;
        if (start_them) start_constraint(s, c, mu);
        ++(is_side ? near.sides : near.obstacles);
        ++s.num_near;
        any = true;
      }
    }
  }
  return violation;
}

/// Computes the terms that the bounds add to the model; see linearise_bounds of the single solver.
template <typename Lanes>
FAIRWAY_LANES void linearise_bounds(Lockstep& s,
                                    const Lanes& mu,
                                    ConstraintErrors<Lanes>& errors) noexcept {
  const Workspace& w = *s.problem;
  const Lanes most = kCentrality * mu;
  const Lanes least_product = mu * (1.0 / kCentrality);
  for (std::size_t kind = 0; kind < w.num_bounds; ++kind) {
    for (std::size_t k = 0; k < w.horizon; ++k) {
      BoundDuals& bound = s.bounds[kind][k];
      const auto slack = bound_slacks<Lanes>(w, s.points[s.now], kind, k);
      const Lanes inverse = 1.0 / (slack.below * slack.above);
      const Lanes below = slack.above * inverse;
      const Lanes above = slack.below * inverse;
      const Lanes low = least(greatest(Lanes(bound.dual_low), least_product * below), most * below);
      const Lanes high =
          least(greatest(Lanes(bound.dual_high), least_product * above), most * above);
      bound.inverse_below = below;
      bound.inverse_above = above;
      bound.dual_low = low;
      bound.dual_high = high;
      bound.curvature = low * below + high * above;
      bound.by_mu = above - below;
      bound.dual = high - low;
      const Lanes low_product = slack.below * low;
      const Lanes high_product = slack.above * high;
      errors.least_product = least(errors.least_product, least(low_product, high_product));
      errors.greatest_product =
          greatest(errors.greatest_product, greatest(low_product, high_product));
    }
  }
}

/// Moves the duals of the near constraints along their step, and computes their terms in the model.
template <typename Lanes>
FAIRWAY_LANES void linearise_near(Lockstep& s,
                                  const Lanes& mu,
                                  ConstraintErrors<Lanes>& errors) noexcept {
  const Workspace& w = *s.problem;
  const double penalty_weight = w.problem->violation_weight;
  const FourPoints& p = s.points[s.now];
  for (std::size_t k = 0; k < w.horizon; ++k) {
    NearSet& near = s.near[k];
    PositionSums<Lanes> now{};
    for (std::size_t i = 0; i < near.sides; ++i) {
      NearConstraint& c = near.constraints[i];
      const SoftConstraintState& state = c.states[s.now];
      move_duals<Lanes>(state, mu, penalty_weight, c);
      eliminate(state, c, errors);
      const Lanes target = c.dual - Lanes(c.curvature) * state.value;
      now.add(c, target, Lanes(c.normal_x), Lanes(c.normal_y));
    }
    if (near.obstacles > 0) {
      const Lanes px = p.x[k + 1];
      const Lanes py = p.y[k + 1];
      const Lanes qx = p.x[k];
      const Lanes qy = p.y[k];
      PositionSums<Lanes> before{};
      Lanes xx = 0.0;
      Lanes xy = 0.0;
      Lanes yx = 0.0;
      Lanes yy = 0.0;
      for (std::size_t i = kMostSides; i < near.end(); ++i) {
        NearConstraint& c = near.constraints[i];
        const SoftConstraintState& state = c.states[s.now];
        move_duals<Lanes>(state, mu, penalty_weight, c);
        eliminate(state, c, errors);
        const double twice = -2.0 * c.retention;
        const Lanes x = 2.0 * (px - c.centre_x);
        const Lanes y = 2.0 * (py - c.centre_y);
        const Lanes before_x = twice * (qx - c.centre_before_x);
        const Lanes before_y = twice * (qy - c.centre_before_y);
        c.gradient_x = x;
        c.gradient_y = y;
        c.gradient_before_x = before_x;
        c.gradient_before_y = before_y;
        const Lanes target = c.dual - Lanes(c.curvature) * state.value;
        now.add(c, target, x, y);
        before.add(c, target, before_x, before_y);
        now.bend -= 2.0 * Lanes(c.dual);
        before.bend -= twice * Lanes(c.dual);
        const Lanes along_x = c.curvature * x;
        const Lanes along_y = c.curvature * y;
        xx += along_x * before_x;
        xy += along_x * before_y;
        yx += along_y * before_x;
        yy += along_y * before_y;
      }
      before.store(s.model_before[k]);
      s.coupling[k].xx = xx;
      s.coupling[k].xy = xy;
      s.coupling[k].yx = yx;
      s.coupling[k].yy = yy;
    }
    now.store(s.model_now[k]);
  }
}

/// Effect of the Newton step on all constraints. It holds the greatest share of a slack that the
/// step would use up, and the slope of their part of the barrier function.
template <typename Lanes>
struct StepEffect {
  Lanes used = 0.0;
  Lanes slope = 0.0;
};

template <typename Lanes>
[[nodiscard]] FAIRWAY_LANES StepEffect<Lanes> step_constraints(Lockstep& s,
                                                               const Lanes& mu) noexcept {
  const Workspace& w = *s.problem;
  const double penalty_weight = w.problem->violation_weight;
  StepEffect<Lanes> effect;
  for (std::size_t kind = 0; kind < w.num_bounds; ++kind) {
    for (std::size_t k = 0; k < w.horizon; ++k) {
      BoundDuals& bound = s.bounds[kind][k];
      const Lanes change = bounded<Lanes>(s.step_commands, kind, k);
      const Lanes down = -change * bound.inverse_below;
      const Lanes up = change * bound.inverse_above;
      effect.used = greatest(effect.used, greatest(down, up));
      bound.dual_low = mu * bound.inverse_below + bound.dual_low * down;
      bound.dual_high = mu * bound.inverse_above + bound.dual_high * up;
    }
  }
  SoftConstraintStep<Lanes> soft;
  for (std::size_t k = 0; k < w.horizon; ++k) {
    NearSet& near = s.near[k];
    const Lanes x = s.step_x[k + 1];
    const Lanes y = s.step_y[k + 1];
    for (std::size_t i = 0; i < near.sides; ++i) {
      NearConstraint& c = near.constraints[i];
      soft.add(c.states[s.now], mu, penalty_weight, x * c.normal_x + y * c.normal_y, c);
    }
    for (std::size_t i = kMostSides; i < near.end(); ++i) {
      NearConstraint& c = near.constraints[i];
      const Lanes change =
          (x * c.gradient_x + y * c.gradient_y) +
          (s.step_x[k] * Lanes(c.gradient_before_x) + s.step_y[k] * Lanes(c.gradient_before_y));
      soft.add(c.states[s.now], mu, penalty_weight, change, c);
    }
  }
  effect.used = greatest(effect.used, soft.used);
  effect.slope = soft.slope + soft.product;
  return effect;
}

}  // namespace fairway::interior_point::lockstep
