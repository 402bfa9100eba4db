// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "fairway/base/simd_math.hpp"
#include "fairway/mpc/interior_point/lockstep/constraints.hpp"
#include "fairway/mpc/interior_point/lockstep/lockstep.hpp"
#include "fairway/mpc/interior_point/lockstep/motion.hpp"

// The line searches of four starts. Each has its own length; a start that has accepted its length
// keeps it while the others shorten theirs.

namespace fairway::interior_point::lockstep {

/// Sums over all constraints of the point with index `at`.
template <typename Lanes>
struct PointSums {
  LogSum<Lanes> logs;
  Lanes violation_slack = 0.0;
  Lanes residual = 0.0;

  FAIRWAY_LANES void add_bounds(const Workspace& w, const FourPoints& p) noexcept {
    for (std::size_t kind = 0; kind < w.num_bounds; ++kind) {
      for (std::size_t k = 0; k < w.horizon; ++k) {
        const auto slack = bound_slacks<Lanes>(w, p, kind, k);
        logs.add(slack.below * slack.above);
      }
    }
  }
  FAIRWAY_LANES void add(const Lanes& value, const Lanes& slack, const Lanes& violation) noexcept {
    logs.add(slack * violation);
    violation_slack += violation;
    residual += magnitude(value + violation - slack);
  }
  FAIRWAY_LANES void store(FourPoints& p) const noexcept {
    p.log_sum = logs.values();
    p.violation_sum = violation_slack;
    p.residual_sum = residual;
  }
};

/// Sums the iterate over all constraints.
template <typename Lanes>
FAIRWAY_LANES void sum_now(Lockstep& s) noexcept {
  const Workspace& w = *s.problem;
  PointSums<Lanes> sums;
  sums.add_bounds(w, s.points[s.now]);
  for (std::size_t k = 0; k < w.horizon; ++k) {
    const NearSet& near = s.near[k];
    for (std::size_t i = 0; i < near.end(); ++i) {
      if (i >= near.sides && i < kMostSides) continue;
      const SoftConstraintState& state = near.constraints[i].states[s.now];
      sums.add(state.value, state.slack, state.violation_slack);
    }
  }
  sums.store(s.points[s.now]);
}

/// Computes slacks of one constraint of the trial point; see move_slacks.
template <typename Lanes>
FAIRWAY_LANES void move_slacks(NearConstraint& c,
                               std::size_t now,
                               const Lanes& length,
                               const Lanes& value,
                               PointSums<Lanes>& sums) noexcept {
  constexpr double kLeastPart = 1e-3;
  const SoftConstraintState& from = c.states[now];
  SoftConstraintState& to = c.states[1 - now];
  const Lanes part = greatest(1.0 + length * c.violation_ratio, Lanes(kLeastPart));
  const Lanes violation = from.violation_slack * part;
  const Lanes slack = greatest(from.slack * (1.0 + length * c.slack_ratio), value + violation);
  to.value = value;
  to.slack = slack;
  to.violation_slack = violation;
  sums.add(value, slack, violation);
}

/// Computes the trial point at the lengths of all starts.
template <typename Lanes>
FAIRWAY_LANES void move_to_trial(Lockstep& s, const Lanes& length) noexcept {
  const Workspace& w = *s.problem;
  const FourPoints& from = s.points[s.now];
  FourPoints& to = s.points[1 - s.now];
  for (std::size_t j = 0; j < 2; ++j) {
    for (std::size_t k = 1; k <= w.horizon; ++k) {
      // A start that does not move keeps its commands, even if its step is not finite.
      const Lanes command = from.commands[j][k];
      to.commands[j][k] =
          where_greater(length, Lanes(0.0), command + length * s.step_commands[j][k], command);
    }
  }
  roll_out<Lanes>(w, to);
  PointSums<Lanes> sums;
  sums.add_bounds(w, to);
  for (std::size_t k = 0; k < w.horizon; ++k) {
    NearSet& near = s.near[k];
    const Lanes x = to.x[k + 1];
    const Lanes y = to.y[k + 1];
    for (std::size_t i = 0; i < near.sides; ++i) {
      NearConstraint& c = near.constraints[i];
      move_slacks(c, s.now, length, side_value(c, x, y), sums);
    }
    for (std::size_t i = kMostSides; i < near.end(); ++i) {
      NearConstraint& c = near.constraints[i];
      const Lanes value = obstacle_value(c, x, y, Lanes(to.x[k]), Lanes(to.y[k]));
      move_slacks(c, s.now, length, value, sums);
    }
  }
  sums.store(to);
}

/// Adds the greatest displacement of a pose to `s.moved`.
template <typename Lanes>
FAIRWAY_LANES void add_displacement(Lockstep& s) noexcept {
  const FourPoints& from = s.points[s.now];
  const FourPoints& to = s.points[1 - s.now];
  Lanes most = 0.0;
  for (std::size_t k = 1; k <= s.problem->horizon; ++k) {
    most = greatest(most,
                    magnitude(to.x[k] - Lanes(from.x[k])) + magnitude(to.y[k] - Lanes(from.y[k])));
  }
  s.moved = s.moved + most;
}

/// Raises every e of a start until its constraint has no residual.
inline void absorb_residuals(Lockstep& s, std::size_t start) noexcept {
  for (std::size_t k = 0; k < s.problem->horizon; ++k) {
    NearSet& near = s.near[k];
    for (std::size_t i = 0; i < near.end(); ++i) {
      if (i >= near.sides && i < kMostSides) continue;
      NearConstraint& c = near.constraints[i];
      SoftConstraintState& state = c.states[s.now];
      state.violation_slack[start] =
          std::max(state.violation_slack[start], state.slack[start] - state.value[start]);
      c.dual_change[start] = 0.0;
    }
  }
}

/// Searches along the Newton steps of all active starts; the trial point becomes the iterate. A
/// start without an acceptable length absorbs its residuals, or ends if it has none.
/// @param fraction_to_boundary  Greatest share of a slack that a step may use, by start.
/// @return Whether some start absorbed residuals.
template <typename Lanes>
FAIRWAY_LANES bool take_steps(Lockstep& s,
                              const Lanes& mu,
                              const Pack4d& fraction_to_boundary) noexcept {
  constexpr double kSufficient = 1e-4;
  constexpr double kRounding = 1e-12;
  constexpr int kMaxHalvings = 15;
  const double penalty_weight = s.problem->problem->violation_weight;
  const StepEffect<Lanes> effect = step_constraints(s, mu);
  Pack4d used;
  Pack4d slope;
  used = effect.used;
  slope = s.step_slope + effect.slope;
  std::array<Progress, kStarts> before;
  std::array<bool, kStarts> accepted{};
  Pack4d length;
  const FourPoints& now = s.points[s.now];
  const FourPoints& trial = s.points[1 - s.now];
  for (std::size_t i = 0; i < kStarts; ++i) {
    const StartState& start = s.starts[i];
    before[i] = {.barrier = now.cost[i] + penalty_weight * now.violation_sum[i] -
                            start.barrier * now.log_sum[i],
                 .residual = now.residual_sum[i]};
    length[i] = used[i] > fraction_to_boundary[i] ? fraction_to_boundary[i] / used[i] : 1.0;
    if (!start.active) length[i] = 0.0;
    accepted[i] = !start.active;
  }
  bool pending = true;
  for (int halvings = 0; pending && halvings <= kMaxHalvings; ++halvings) {
    move_to_trial(s, Lanes(length));
    pending = false;
    for (std::size_t i = 0; i < kStarts; ++i) {
      if (accepted[i]) continue;
      StartState& start = s.starts[i];
      Progress after = {.barrier = trial.cost[i] + penalty_weight * trial.violation_sum[i] -
                                   start.barrier * trial.log_sum[i],
                        .residual = trial.residual_sum[i]};
      after.barrier -= kRounding * std::abs(before[i].barrier);
      if (std::isfinite(after.barrier + after.residual) && start.filter.accepts(after)) {
        const double decrease = length[i] * slope[i];
        const bool falls = slope[i] < 0.0 && (before[i].residual <= kNoResidual ||
                                              decrease * slope[i] > before[i].residual);
        accepted[i] = falls ? after.barrier <= before[i].barrier + kSufficient * decrease
                            : Filter::improves(after, before[i]);
        if (accepted[i] && !falls) start.filter.add(before[i]);
      }
      if (accepted[i]) continue;
      length[i] *= 0.5;
      pending = true;
    }
  }
  bool absorbed = false;
  if (pending) {
    for (std::size_t i = 0; i < kStarts; ++i) {
      if (accepted[i]) continue;
      length[i] = 0.0;
      if (before[i].residual <= kNoResidual) s.starts[i].active = false;
    }
    move_to_trial(s, Lanes(length));
  }
  add_displacement<Lanes>(s);
  s.now = 1 - s.now;
  for (std::size_t i = 0; i < kStarts; ++i) {
    if (accepted[i] || !s.starts[i].active) continue;
    absorb_residuals(s, i);
    s.starts[i].filter.clear();
    absorbed = true;
  }
  return absorbed;
}

}  // namespace fairway::interior_point::lockstep
