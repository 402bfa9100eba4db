// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/base/simd_math.hpp"
#include "fairway/mpc/interior_point/lockstep/lockstep.hpp"

// Poses, cost and costate of four starts; the formulas are those of newton/trajectory.hpp.

namespace fairway::interior_point::lockstep {

/// Computes the poses and the cost of the commands of `p`, Eq. (S1) and (S2).
template <typename Lanes>
FAIRWAY_LANES void roll_out(const Workspace& w, FourPoints& p) noexcept {
  const double dt = w.problem->dt;
  Lanes cost = 0.0;
  Lanes x = p.x[0];
  Lanes y = p.y[0];
  Lanes heading = p.heading[0];
  Lanes linear_before = p.commands[kLinear][0];
  Lanes angular_before = p.commands[kAngular][0];
  for (std::size_t k = 0; k < w.horizon; ++k) {
    const Lanes linear = p.commands[kLinear][k + 1];
    const Lanes angular = p.commands[kAngular][k + 1];
    const Direction<Lanes> along = direction_within(heading + w.half_turn * angular);
    p.cosine[k] = along.cosine;
    p.sine[k] = along.sine;
    const Lanes length = dt * linear;
    x += length * along.cosine;
    y += length * along.sine;
    heading += dt * angular;
    p.x[k + 1] = x;
    p.y[k + 1] = y;
    p.heading[k + 1] = heading;
    const Lanes dx = x - w.target_x[k];
    const Lanes dy = y - w.target_y[k];
    const Lanes turn = heading - w.target_heading[k];
    const Lanes linear_change = linear - linear_before;
    const Lanes angular_change = angular - angular_before;
    cost += (w.weight_x[k] * dx * dx + w.weight_y[k] * dy * dy) +
            (w.weight_heading[k] * turn * turn + w.command_weight[kLinear][k] * linear * linear) +
            (w.command_weight[kAngular][k] * angular * angular +
             w.change_weight[kLinear][k] * linear_change * linear_change) +
            w.change_weight[kAngular][k] * angular_change * angular_change;
    linear_before = linear;
    angular_before = angular;
  }
  p.cost = cost + w.problem->cost_offset;
}

/// Gradient of the cost by command k of coordinate j.
template <typename Lanes>
FAIRWAY_LANES Lanes
command_gradient(const Workspace& w, const FourPoints& p, std::size_t j, std::size_t k) noexcept {
  const Lanes now = p.commands[j][k + 1];
  const Lanes change = now - p.commands[j][k];
  const Lanes next_change = p.commands[j][k + 2] - now;
  return 2.0 * (w.command_weight[j][k] * now + w.change_weight[j][k] * change -
                w.change_weight[j][k + 1] * next_change);
}

/// Computes the costate backwards. From it follow the curvature of the dynamics and the gradient of
/// the cost by the commands, Eq. (S6).
/// @return The stationarity of each start.
template <typename Lanes>
[[nodiscard]] FAIRWAY_LANES Lanes linearise_motion(Lockstep& s) noexcept {
  const Workspace& w = *s.problem;
  const FourPoints& p = s.points[s.now];
  const double dt = w.problem->dt;
  Lanes lx = 0.0;
  Lanes ly = 0.0;
  Lanes lh = 0.0;
  Lanes stationarity = 0.0;
  s.phi_phi[w.horizon] = Lanes(0.0);
  for (std::size_t k = w.horizon; k-- > 0;) {
    const PositionTerms& terms = s.model_now[k];
    lx += 2.0 * w.weight_x[k] * (p.x[k + 1] - Lanes(w.target_x[k])) - terms.dual_x;
    ly += 2.0 * w.weight_y[k] * (p.y[k + 1] - Lanes(w.target_y[k])) - terms.dual_y;
    lh += 2.0 * w.weight_heading[k] * (p.heading[k + 1] - Lanes(w.target_heading[k]));
    const Lanes linear = p.commands[kLinear][k + 1];
    const Lanes along = dt * (lx * p.cosine[k] + ly * p.sine[k]);
    const Lanes across = dt * (ly * p.cosine[k] - lx * p.sine[k]);
    s.phi_phi[k] = -linear * along;
    s.linear_phi[k] = across;
    for (std::size_t j = 0; j < 2; ++j) {
      const Lanes by_motion = j == kLinear ? along : w.half_turn * linear * across + dt * lh;
      const Lanes gradient = command_gradient<Lanes>(w, p, j, k);
      s.gradient[j][k] = gradient;
      Lanes derivative = by_motion + gradient + s.bounds[j][k].dual;
      if (w.num_bounds > 2) {
        derivative += s.bounds[2 + j][k].dual;
        if (k + 1 < w.horizon) derivative -= s.bounds[2 + j][k + 1].dual;
      }
      stationarity = greatest(stationarity, magnitude(w.is_free[j][k] * derivative));
    }
    lh += linear * across;
    if (s.near[k].obstacles > 0) {
      lx -= s.model_before[k].dual_x;
      ly -= s.model_before[k].dual_y;
    }
  }
  return stationarity;
}

}  // namespace fairway::interior_point::lockstep
