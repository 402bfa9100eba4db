// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/base/simd_math.hpp"
#include "fairway/mpc/interior_point/body/body_rollout.hpp"

// First and second derivatives of the motion, times the costate.

namespace fairway::interior_point {

/// Derivatives of four steps by the twist (u, v, r): the displacement that each part adds, its
/// product with the costate, and the curvature. That by u and v alone is zero.
template <typename Lanes>
struct TwistTerms {
  Lanes ux, uy, rx, ry, rh;                 ///< B; the displacement by v is (-uy, ux, 0)
  Lanes by_u, by_v, by_r;                   ///< B^T lambda
  Lanes turn_u, turn_v, turn_r, turn_turn;  ///< by the heading before the step
  Lanes ur, vr, rr;
};

/// Input-dependent parts of the model of four steps: derivatives by input j are `by_input[j]`.
template <typename Lanes>
FAIRWAY_LANES void chain(const BodyWorkspace<UnicycleMotion>& w,
                         std::size_t k,
                         const TwistTerms<Lanes>& t,
                         BodyModel<UnicycleMotion>& m,
                         std::array<Lanes, 2>& by_input) noexcept {
  static_cast<void>(w);
  put(m.motion_x[0], k, t.ux);
  put(m.motion_y[0], k, t.uy);
  put(m.motion_h[0], k, Lanes(0.0));
  put(m.motion_x[1], k, t.rx);
  put(m.motion_y[1], k, t.ry);
  put(m.motion_h[1], k, t.rh);
  put(m.turn_input[0], k, t.turn_u);
  put(m.turn_input[1], k, t.turn_r);
  put(m.input_input[lower(0, 0)], k, Lanes(0.0));
  put(m.input_input[lower(1, 0)], k, t.ur);
  put(m.input_input[lower(1, 1)], k, t.rr);
  by_input = {t.by_u, t.by_r};
}
template <typename Lanes>
FAIRWAY_LANES void chain(const BodyWorkspace<OmniMotion>& w,
                         std::size_t k,
                         const TwistTerms<Lanes>& t,
                         BodyModel<OmniMotion>& m,
                         std::array<Lanes, 3>& by_input) noexcept {
  static_cast<void>(w);
  put(m.motion_x[0], k, t.ux);
  put(m.motion_y[0], k, t.uy);
  put(m.motion_h[0], k, Lanes(0.0));
  put(m.motion_x[1], k, -t.uy);
  put(m.motion_y[1], k, t.ux);
  put(m.motion_h[1], k, Lanes(0.0));
  put(m.motion_x[2], k, t.rx);
  put(m.motion_y[2], k, t.ry);
  put(m.motion_h[2], k, t.rh);
  put(m.turn_input[0], k, t.turn_u);
  put(m.turn_input[1], k, t.turn_v);
  put(m.turn_input[2], k, t.turn_r);
  put(m.input_input[lower(0, 0)], k, Lanes(0.0));
  put(m.input_input[lower(1, 0)], k, Lanes(0.0));
  put(m.input_input[lower(1, 1)], k, Lanes(0.0));
  put(m.input_input[lower(2, 0)], k, t.ur);
  put(m.input_input[lower(2, 1)], k, t.vr);
  put(m.input_input[lower(2, 2)], k, t.rr);
  by_input = {t.by_u, t.by_v, t.by_r};
}
// u = s cos(delta), r = s sin(delta) / wheelbase.
template <typename Lanes>
FAIRWAY_LANES void chain(const BodyWorkspace<SteeredMotion>& w,
                         std::size_t k,
                         const TwistTerms<Lanes>& t,
                         BodyModel<SteeredMotion>& m,
                         std::array<Lanes, 2>& by_input) noexcept {
  const Lanes speed = lanes<Lanes>(w.now->inputs[0], k + 1);
  const Lanes u_s = lanes<Lanes>(w.now->steering_cosine, k);
  const Lanes sine = lanes<Lanes>(w.now->steering_sine, k);
  const double inverse = 1.0 / w.problem->motion.wheelbase;
  const Lanes r_s = inverse * sine;
  const Lanes u_d = -speed * sine;
  const Lanes r_d = inverse * (speed * u_s);
  put(m.motion_x[0], k, u_s * t.ux + r_s * t.rx);
  put(m.motion_y[0], k, u_s * t.uy + r_s * t.ry);
  put(m.motion_h[0], k, r_s * t.rh);
  put(m.motion_x[1], k, u_d * t.ux + r_d * t.rx);
  put(m.motion_y[1], k, u_d * t.uy + r_d * t.ry);
  put(m.motion_h[1], k, r_d * t.rh);
  put(m.turn_input[0], k, u_s * t.turn_u + r_s * t.turn_r);
  put(m.turn_input[1], k, u_d * t.turn_u + r_d * t.turn_r);
  put(m.input_input[lower(0, 0)], k, r_s * (2.0 * u_s * t.ur + r_s * t.rr));
  put(m.input_input[lower(1, 0)], k,
      (u_s * r_d + u_d * r_s) * t.ur + r_s * r_d * t.rr +
          (inverse * (u_s * t.by_r) - sine * t.by_u));
  put(m.input_input[lower(1, 1)], k,
      r_d * (2.0 * u_d * t.ur + r_d * t.rr) - speed * (u_s * t.by_u + r_s * t.by_r));
  by_input = {u_s * t.by_u + r_s * t.by_r, u_d * t.by_u + r_d * t.by_r};
}

/// Derivative of everything after each step by the pose that it leads to, at the present duals.
struct PoseCostate {
  StepArray x, y, turn;
};

/// Computes the costate backwards. In these coordinates it is a sum, because the transition is the
/// identity.
template <typename Lanes, typename Motion>
FAIRWAY_LANES void find_costate(const BodyWorkspace<Motion>& w, PoseCostate& costate) noexcept {
  const BodyPoint<Motion>& p = *w.now;
  PoseCostate before;
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    const std::size_t k = kLanes * b;
    const Lanes x = lanes<Lanes>(p.x, k + 1);
    const Lanes y = lanes<Lanes>(p.y, k + 1);
    const Lanes gx = 2.0 * lanes<Lanes>(w.weight_x, k) * (x - lanes<Lanes>(w.target_x, k));
    const Lanes gy = 2.0 * lanes<Lanes>(w.weight_y, k) * (y - lanes<Lanes>(w.target_y, k));
    const Lanes gh = 2.0 * lanes<Lanes>(w.weight_heading, k) *
                     (lanes<Lanes>(p.heading, k + 1) - lanes<Lanes>(w.target_heading, k));
    const PoseTerms& now = w.model.now[b];
    put(costate.x, k, gx - now.dual_x);
    put(costate.y, k, gy - now.dual_y);
    put(costate.turn, k, (gh - now.dual_h) + (gy * x - gx * y));
    const bool barriers = w.constraint_ranges[b].has_barriers();
    const PoseTerms& earlier = w.model.before[b];
    put(before.x, k, barriers ? -Lanes(earlier.dual_x) : Lanes(0.0));
    put(before.y, k, barriers ? -Lanes(earlier.dual_y) : Lanes(0.0));
    put(before.turn, k, barriers ? -Lanes(earlier.dual_h) : Lanes(0.0));
  }
  double lx = 0.0;
  double ly = 0.0;
  double lh = 0.0;
  for (std::size_t k = w.horizon; k-- > 0;) {
    costate.x[k] = lx += costate.x[k];
    costate.y[k] = ly += costate.y[k];
    costate.turn[k] = lh += costate.turn[k];
    lx += before.x[k];
    ly += before.y[k];
    lh += before.turn[k];
  }
}

/// Computes the derivatives of four steps at the costate.
template <typename Lanes, typename Motion>
FAIRWAY_LANES TwistTerms<Lanes> twist_terms(const BodyWorkspace<Motion>& w,
                                            const PoseCostate& costate,
                                            std::size_t k) noexcept {
  const BodyPoint<Motion>& p = *w.now;
  const double dt = w.problem->dt;
  const double half = 0.5 * dt;
  const Lanes lx = lanes<Lanes>(costate.x, k);
  const Lanes ly = lanes<Lanes>(costate.y, k);
  TwistTerms<Lanes> t;
  t.ux = dt * lanes<Lanes>(p.cosine, k);
  t.uy = dt * lanes<Lanes>(p.sine, k);
  // A step turns about the middle of the line that it moves along.
  t.rx = half * (lanes<Lanes>(p.y, k) + lanes<Lanes>(p.y, k + 1));
  t.ry = -half * (lanes<Lanes>(p.x, k) + lanes<Lanes>(p.x, k + 1));
  t.rh = Lanes(dt);
  t.by_u = lx * t.ux + ly * t.uy;
  t.by_v = ly * t.ux - lx * t.uy;
  t.by_r = (lx * t.rx + ly * t.ry) + dt * lanes<Lanes>(costate.turn, k);
  t.turn_turn = -lanes<Lanes>(p.linear, k) * t.by_u;
  if constexpr (kLateral<Motion>) t.turn_turn -= lanes<Lanes>(p.lateral, k) * t.by_v;
  t.turn_u = t.by_v;
  t.turn_v = -t.by_u;
  t.turn_r = half * t.turn_turn;
  t.ur = half * t.turn_u;
  t.vr = half * t.turn_v;
  t.rr = half * t.turn_r;
  return t;
}

/// Gradient of the cost by four values of input j.
template <typename Lanes, typename Motion>
FAIRWAY_LANES Lanes input_gradient(const BodyWorkspace<Motion>& w,
                                   std::size_t j,
                                   std::size_t k) noexcept {
  const PoseArray& input = w.now->inputs[j];
  const Lanes now = lanes<Lanes>(input, k + 1);
  const Lanes change = now - lanes<Lanes>(input, k);
  const Lanes next_change = lanes<Lanes>(input, k + 2) - now;
  return 2.0 *
         (lanes<Lanes>(w.input_weight[j], k) * now + lanes<Lanes>(w.change_weight[j], k) * change -
          lanes<Lanes>(w.change_weight[j], k + 1) * next_change);
}

/// Computes the motion part of the model, and the gradient of the cost by the inputs.
/// @return The stationarity of the Lagrangian: its greatest derivative by an input.
template <typename Lanes, typename Motion>
[[nodiscard]] FAIRWAY_LANES double linearise_motion(BodyWorkspace<Motion>& w) noexcept {
  constexpr std::size_t n = Motion::kInputs;
  PoseCostate costate;
  find_costate<Lanes>(w, costate);
  Lanes stationarity = 0.0;
  for (std::size_t k = 0; k < kLanes * w.num_blocks; k += kLanes) {
    const TwistTerms<Lanes> t = twist_terms<Lanes>(w, costate, k);
    put(w.model.turn_turn, k, t.turn_turn);
    std::array<Lanes, n> by_input;
    chain(w, k, t, w.model, by_input);
    const Lanes is_step = lanes<Lanes>(w.is_step, k);
    for (std::size_t j = 0; j < n; ++j) {
      const Lanes gradient = input_gradient<Lanes>(w, j, k);
      put(w.model.gradient[j], k, gradient);
      Lanes derivative = by_input[j] + gradient + lanes<Lanes>(w.bounds[j].dual, k);
      if (w.has_change_bounds) {
        const PoseArray& dual = w.bounds[n + j].dual;
        derivative += lanes<Lanes>(dual, k) - lanes<Lanes>(dual, k + 1);
      }
      for (std::size_t i = 0; i < w.num_limits; ++i)
        derivative += w.problem->input_limits[i].normal[static_cast<Eigen::Index>(j)] *
                      lanes<Lanes>(w.bounds[2 * n + i].dual, k);
      stationarity = greatest(stationarity, magnitude(is_step * derivative));
    }
  }
  return greatest_of(stationarity);
}

}  // namespace fairway::interior_point
