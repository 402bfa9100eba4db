// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/base/simd_math.hpp"
#include "fairway/mpc/interior_point/body/body_workspace.hpp"
#include "fairway/mpc/interior_point/newton/trajectory.hpp"

namespace fairway::interior_point {

/// Computes the twists of four steps from their inputs.
template <typename Lanes>
FAIRWAY_LANES void find_twists(const BodyWorkspace<UnicycleMotion>& /*w*/,
                               std::size_t k,
                               BodyPoint<UnicycleMotion>& p) noexcept {
  put(p.linear, k, lanes<Lanes>(p.inputs[0], k + 1));
  put(p.angular, k, lanes<Lanes>(p.inputs[1], k + 1));
}
template <typename Lanes>
FAIRWAY_LANES void find_twists(const BodyWorkspace<SteeredMotion>& w,
                               std::size_t k,
                               BodyPoint<SteeredMotion>& p) noexcept {
  const Direction<Lanes> steering = direction_of(lanes<Lanes>(p.inputs[1], k + 1));
  const Lanes speed = lanes<Lanes>(p.inputs[0], k + 1);
  put(p.steering_cosine, k, steering.cosine);
  put(p.steering_sine, k, steering.sine);
  put(p.linear, k, speed * steering.cosine);
  put(p.angular, k, (1.0 / w.problem->motion.wheelbase) * (speed * steering.sine));
}
template <typename Lanes>
FAIRWAY_LANES void find_twists(const BodyWorkspace<OmniMotion>& /*w*/,
                               std::size_t k,
                               BodyPoint<OmniMotion>& p) noexcept {
  put(p.linear, k, lanes<Lanes>(p.inputs[0], k + 1));
  put(p.lateral, k, lanes<Lanes>(p.inputs[1], k + 1));
  put(p.angular, k, lanes<Lanes>(p.inputs[2], k + 1));
}

/// Whether a base moves sideways.
template <typename Motion>
inline constexpr bool kLateral = false;
template <>
inline constexpr bool kLateral<OmniMotion> = true;

/// Computes the inputs of `w.trial`: those of `w.now`, moved by `length` of the Newton step.
template <typename Lanes, typename Motion>
FAIRWAY_LANES void move_inputs(BodyWorkspace<Motion>& w, double length) noexcept {
  for (std::size_t j = 0; j < Motion::kInputs; ++j) {
    for (std::size_t k = 1; k <= kLanes * w.num_blocks; k += kLanes)
      put(w.trial->inputs[j], k,
          lanes<Lanes>(w.now->inputs[j], k) + length * lanes<Lanes>(w.step.inputs[j], k));
  }
}

/// Computes the cost of the inputs of `p` and their poses.
template <typename Lanes, typename Motion>
FAIRWAY_LANES double body_cost(const BodyWorkspace<Motion>& w,
                               const BodyPoint<Motion>& p) noexcept {
  Lanes cost = 0.0;
  for (std::size_t k = 0; k < kLanes * w.num_blocks; k += kLanes) {
    const Lanes dx = lanes<Lanes>(p.x, k + 1) - lanes<Lanes>(w.target_x, k);
    const Lanes dy = lanes<Lanes>(p.y, k + 1) - lanes<Lanes>(w.target_y, k);
    const Lanes turn = lanes<Lanes>(p.heading, k + 1) - lanes<Lanes>(w.target_heading, k);
    cost += (lanes<Lanes>(w.weight_x, k) * square(dx) + lanes<Lanes>(w.weight_y, k) * square(dy)) +
            lanes<Lanes>(w.weight_heading, k) * square(turn);
    for (std::size_t j = 0; j < Motion::kInputs; ++j) {
      const Lanes input = lanes<Lanes>(p.inputs[j], k + 1);
      const Lanes change = input - lanes<Lanes>(p.inputs[j], k);
      cost += lanes<Lanes>(w.input_weight[j], k) * square(input) +
              lanes<Lanes>(w.change_weight[j], k) * square(change);
    }
  }
  return sum_of(cost);
}

/// Computes the places of all marks at the poses of `p`. Those at the start are constant.
template <typename Lanes, typename Motion>
FAIRWAY_LANES void place_marks(const BodyWorkspace<Motion>& w, BodyPoint<Motion>& p) noexcept {
  if (w.num_marks == 0) return;
  for (std::size_t k = 1; k <= kLanes * w.num_blocks; k += kLanes) {
    const Direction<Lanes> along = direction_of(lanes<Lanes>(p.heading, k));
    const Lanes x = lanes<Lanes>(p.x, k);
    const Lanes y = lanes<Lanes>(p.y, k);
    for (std::size_t m = 0; m < w.num_marks; ++m) {
      const double a = w.marks[m].x();
      const double b = w.marks[m].y();
      put(p.marks[m].x, k, x + (a * along.cosine - b * along.sine));
      put(p.marks[m].y, k, y + (a * along.sine + b * along.cosine));
    }
  }
}

/// Computes the poses, the marks and the cost of the inputs of `p`.
template <typename Lanes, typename Motion>
FAIRWAY_LANES void roll_out(const BodyWorkspace<Motion>& w, BodyPoint<Motion>& p) noexcept {
  const double dt = w.problem->dt;
  for (std::size_t k = 0; k < kLanes * w.num_blocks; k += kLanes)
    find_twists<Lanes>(w, k, p);
  for (std::size_t k = 0; k < w.horizon; ++k)
    p.heading[k + 1] = p.heading[k] + dt * p.angular[k];
  StepArray move_x;
  StepArray move_y;
  for (std::size_t k = 0; k < kLanes * w.num_blocks; k += kLanes) {
    const Lanes phi = lanes<Lanes>(p.heading, k) + 0.5 * dt * lanes<Lanes>(p.angular, k);
    const Direction<Lanes> along = direction_of(phi);
    const Lanes length = dt * lanes<Lanes>(p.linear, k);
    put(p.cosine, k, along.cosine);
    put(p.sine, k, along.sine);
    if constexpr (kLateral<Motion>) {
      const Lanes aside = dt * lanes<Lanes>(p.lateral, k);
      put(move_x, k, length * along.cosine - aside * along.sine);
      put(move_y, k, length * along.sine + aside * along.cosine);
    } else {
      put(move_x, k, length * along.cosine);
      put(move_y, k, length * along.sine);
    }
  }
  for (std::size_t k = 0; k < w.horizon; ++k) {
    p.x[k + 1] = p.x[k] + move_x[k];
    p.y[k + 1] = p.y[k] + move_y[k];
  }
  place_marks<Lanes>(w, p);
  p.cost = body_cost<Lanes>(w, p);
}

}  // namespace fairway::interior_point
