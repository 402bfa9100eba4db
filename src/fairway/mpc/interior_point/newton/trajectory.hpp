// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/base/simd_math.hpp"
#include "fairway/mpc/interior_point/workspace/workspace.hpp"

namespace fairway::interior_point {

template <typename Lanes>
FAIRWAY_LANES Lanes square(const Lanes& a) noexcept {
  return a * a;
}

/// Computes the commands of `w.trial`: those of `w.now`, moved by `length` of the Newton step.
template <typename Lanes>
FAIRWAY_LANES void move_commands(Workspace& w, double length) noexcept {
  for (std::size_t j = 0; j < 2; ++j) {
    for (std::size_t k = 1; k <= kLanes * w.num_blocks; k += kLanes)
      put(w.trial->commands[j], k,
          lanes<Lanes>(w.now->commands[j], k) + length * lanes<Lanes>(w.step.commands[j], k));
  }
}

/// Computes the cost of the commands of `p` and their poses, Eq. (S2).
template <typename Lanes>
FAIRWAY_LANES double cost_of(const Workspace& w, const Point& p) noexcept {
  Lanes cost = 0.0;
  for (std::size_t k = 0; k < kLanes * w.num_blocks; k += kLanes) {
    const Lanes dx = lanes<Lanes>(p.x, k + 1) - lanes<Lanes>(w.target_x, k);
    const Lanes dy = lanes<Lanes>(p.y, k + 1) - lanes<Lanes>(w.target_y, k);
    const Lanes turn = lanes<Lanes>(p.heading, k + 1) - lanes<Lanes>(w.target_heading, k);
    cost += (lanes<Lanes>(w.weight_x, k) * square(dx) + lanes<Lanes>(w.weight_y, k) * square(dy)) +
            lanes<Lanes>(w.weight_heading, k) * square(turn);
    for (std::size_t j = 0; j < 2; ++j) {
      const Lanes command = lanes<Lanes>(p.commands[j], k + 1);
      const Lanes change = command - lanes<Lanes>(p.commands[j], k);
      cost += lanes<Lanes>(w.command_weight[j], k) * square(command) +
              lanes<Lanes>(w.change_weight[j], k) * square(change);
    }
  }
  return w.problem->cost_offset + sum_of(cost);
}

/// Computes the poses and the cost of the commands of `p`, Eq. (S1).
template <typename Lanes>
FAIRWAY_LANES void roll_out(const Workspace& w, Point& p) noexcept {
  const double dt = w.problem->dt;
  const PoseArray& linear = p.commands[kLinear];
  const PoseArray& angular = p.commands[kAngular];
  for (std::size_t k = 0; k < w.horizon; ++k)
    p.heading[k + 1] = p.heading[k] + dt * angular[k + 1];
  StepArray move_x;
  StepArray move_y;
  for (std::size_t k = 0; k < kLanes * w.num_blocks; k += kLanes) {
    const Lanes phi = lanes<Lanes>(p.heading, k) + w.half_turn * lanes<Lanes>(angular, k + 1);
    const Direction<Lanes> along = direction_of(phi);
    const Lanes length = dt * lanes<Lanes>(linear, k + 1);
    put(p.cosine, k, along.cosine);
    put(p.sine, k, along.sine);
    put(move_x, k, length * along.cosine);
    put(move_y, k, length * along.sine);
  }
  for (std::size_t k = 0; k < w.horizon; ++k) {
    p.x[k + 1] = p.x[k] + move_x[k];
    p.y[k + 1] = p.y[k] + move_y[k];
  }
  p.cost = cost_of<Lanes>(w, p);
}

/// Gradient of the cost by four commands of coordinate j.
template <typename Lanes>
FAIRWAY_LANES Lanes command_gradient(const Workspace& w, std::size_t j, std::size_t k) noexcept {
  const PoseArray& command = w.now->commands[j];
  const Lanes now = lanes<Lanes>(command, k + 1);
  const Lanes change = now - lanes<Lanes>(command, k);
  const Lanes next_change = lanes<Lanes>(command, k + 2) - now;
  return 2.0 * (lanes<Lanes>(w.command_weight[j], k) * now +
                lanes<Lanes>(w.change_weight[j], k) * change -
                lanes<Lanes>(w.change_weight[j], k + 1) * next_change);
}

/// Derivative of everything after each step by the pose that it leads to, at the present duals.
struct Costate {
  StepArray x, y, heading;
};

/// Computes the costate backwards, Eq. (S6).
template <typename Lanes>
FAIRWAY_LANES void find_costate(const Workspace& w, Costate& costate) noexcept {
  const Point& p = *w.now;
  const Model& m = w.model;
  auto& [x, y, heading] = costate;
  StepArray before_x;
  StepArray before_y;
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    const std::size_t k = kLanes * b;
    const Lanes dx = lanes<Lanes>(p.x, k + 1) - lanes<Lanes>(w.target_x, k);
    const Lanes dy = lanes<Lanes>(p.y, k + 1) - lanes<Lanes>(w.target_y, k);
    const Lanes turn = lanes<Lanes>(p.heading, k + 1) - lanes<Lanes>(w.target_heading, k);
    put(x, k, 2.0 * lanes<Lanes>(w.weight_x, k) * dx - m.now[b].dual_x);
    put(y, k, 2.0 * lanes<Lanes>(w.weight_y, k) * dy - m.now[b].dual_y);
    put(heading, k, 2.0 * lanes<Lanes>(w.weight_heading, k) * turn);
    const bool barriers = w.constraint_ranges[b].has_barriers();
    put(before_x, k, barriers ? -Lanes(m.before[b].dual_x) : Lanes(0.0));
    put(before_y, k, barriers ? -Lanes(m.before[b].dual_y) : Lanes(0.0));
  }
  const double dt = w.problem->dt;
  double lx = 0.0;
  double ly = 0.0;
  double lh = 0.0;
  for (std::size_t k = w.horizon; k-- > 0;) {
    lx += x[k];
    ly += y[k];
    lh += heading[k];
    x[k] = lx;
    y[k] = ly;
    heading[k] = lh;
    lh += dt * p.commands[kLinear][k + 1] * (ly * p.cosine[k] - lx * p.sine[k]);
    lx += before_x[k];
    ly += before_y[k];
  }
}

/// Computes the curvature of the dynamics times the costate, Eq. (S6), and the gradient of the cost
/// by the commands.
/// @return The stationarity of the Lagrangian: its greatest derivative by a command.
template <typename Lanes>
[[nodiscard]] FAIRWAY_LANES double linearise_trajectory(Workspace& w) noexcept {
  Costate costate;
  find_costate<Lanes>(w, costate);
  const Point& p = *w.now;
  const double dt = w.problem->dt;
  Lanes stationarity = 0.0;
  for (std::size_t k = 0; k < kLanes * w.num_blocks; k += kLanes) {
    const Lanes cosine = lanes<Lanes>(p.cosine, k);
    const Lanes sine = lanes<Lanes>(p.sine, k);
    const Lanes linear = lanes<Lanes>(p.commands[kLinear], k + 1);
    const Lanes lx = lanes<Lanes>(costate.x, k);
    const Lanes ly = lanes<Lanes>(costate.y, k);
    const Lanes along = dt * (lx * cosine + ly * sine);
    const Lanes across = dt * (ly * cosine - lx * sine);
    put(w.model.phi_phi, k, -linear * along);
    put(w.model.linear_phi, k, across);
    for (std::size_t j = 0; j < 2; ++j) {
      const Lanes by_motion =
          j == kLinear ? along
                       : w.half_turn * linear * across + dt * lanes<Lanes>(costate.heading, k);
      const Lanes gradient = command_gradient<Lanes>(w, j, k);
      put(w.model.gradient[j], k, gradient);
      Lanes derivative = by_motion + gradient + lanes<Lanes>(w.bounds[j].dual, k);
      if (w.num_bounds > 2) {
        const PoseArray& dual = w.bounds[2 + j].dual;
        derivative += lanes<Lanes>(dual, k) - lanes<Lanes>(dual, k + 1);
      }
      stationarity = greatest(stationarity, magnitude(lanes<Lanes>(w.is_free[j], k) * derivative));
    }
  }
  return greatest_of(stationarity);
}

}  // namespace fairway::interior_point
