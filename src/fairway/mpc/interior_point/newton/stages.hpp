// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/base/simd_math.hpp"
#include "fairway/mpc/interior_point/workspace/workspace.hpp"

// The Newton system as the stages of a Riccati recursion, docs/solver.md section 3.

namespace fairway::interior_point {

/// A quadratic function of (x, y, heading) for four steps: its Hessian (symmetric entries once) and
/// its gradient.
template <typename Lanes>
struct Quadratic {
  Lanes xx, xy, yy, xh, yh, hh;
  Lanes gx, gy, gh;

  /// `curved` is 1 with the curvature of the constraints, and 0 without.
  template <typename Barrier, typename Curved>
  FAIRWAY_LANES Quadratic(const PositionTerms& terms,
                          const Barrier& mu,
                          const Curved& curved) noexcept
      : xx(terms.xx),
        xy(terms.xy),
        yy(terms.yy),
        gx(-(terms.target_x + mu * Lanes(terms.by_mu_x))),
        gy(-(terms.target_y + mu * Lanes(terms.by_mu_y))) {
    xx += curved * Lanes(terms.bend);
    yy += curved * Lanes(terms.bend);
  }

  /// Changes variables from the position (x, y) to the turn about the origin and the motion that
  /// lead there, Eq. (S8).
  FAIRWAY_LANES void turn_about_origin(const Lanes& x, const Lanes& y) noexcept {
    xh = xy * x - xx * y;
    yh = yy * x - xy * y;
    hh += yh * x - xh * y;
    gh += gy * x - gx * y;
  }
};

/// All terms by one coordinate of four commands, without the dynamics.
template <typename Lanes>
struct CommandTerms {
  Lanes hessian, change, coupling, gradient;

  FAIRWAY_LANES CommandTerms(const Workspace& w, std::size_t j, std::size_t k, double mu) noexcept
      : hessian(2.0 * lanes<Lanes>(w.command_weight[j], k) +
                lanes<Lanes>(w.bounds[j].curvature, k)),
        change(2.0 * lanes<Lanes>(w.change_weight[j], k)),
        gradient(lanes<Lanes>(w.model.gradient[j], k) + mu * lanes<Lanes>(w.bounds[j].by_mu, k)) {
    if (w.num_bounds > 2) {
      const Bounds& bounds = w.bounds[2 + j];
      change += lanes<Lanes>(bounds.curvature, k);
      gradient += mu * (lanes<Lanes>(bounds.by_mu, k) - lanes<Lanes>(bounds.by_mu, k + 1));
    }
    coupling = lanes<Lanes>(w.is_coupled[j], k) * change;
  }
};

/// B of four steps, Eq. (S8): the displacement by u is (bx, by, 0), and that by r is (cx, cy,
/// turn).
template <typename Lanes>
struct Motion {
  Lanes bx, by, cx, cy, turn;
};

/// The Hessian by the commands and the pose before the step.
template <typename Lanes>
struct MixedTerms {
  Lanes linear_x, linear_y, linear_h;
  Lanes angular_x, angular_y, angular_h;
};

/// Writes row `member` of four stages from the columns of their matrices.
template <typename Lanes>
FAIRWAY_LANES void put_rows(Stage* stages,
                            Pack4d Stage::*member,
                            const Lanes& a,
                            const Lanes& b,
                            const Lanes& c,
                            const Lanes& d) noexcept {
  const auto rows = transposed(a, b, c, d);
  stages[0].*member = rows.first;
  stages[1].*member = rows.second;
  stages[2].*member = rows.third;
  stages[3].*member = rows.fourth;
}

/// Adds to the existing rows, except to the stage before the first step.
template <typename Lanes>
FAIRWAY_LANES void add_rows_before(Workspace& w,
                                   std::size_t k,
                                   Pack4d Stage::*member,
                                   const Lanes& a,
                                   const Lanes& b,
                                   const Lanes& c,
                                   const Lanes& d) noexcept {
  const auto rows = transposed(a, b, c, d);
  if (k > 0) w.stages[k - 1].*member = w.stages[k - 1].*member + rows.first;
  w.stages[k].*member = w.stages[k].*member + rows.second;
  w.stages[k + 1].*member = w.stages[k + 1].*member + rows.third;
  w.stages[k + 2].*member = w.stages[k + 2].*member + rows.fourth;
}

/// Adds the cost of obstacles near block b. It depends on the pose before each step, in the
/// preceding stages, and on that pose together with the pose after the step.
template <typename Lanes>
FAIRWAY_LANES void add_barriers(Workspace& w,
                                std::size_t b,
                                double mu,
                                double curved,
                                const Motion<Lanes>& motion,
                                MixedTerms<Lanes>& mixed) noexcept {
  const std::size_t k = kLanes * b;
  const Lanes x = lanes<Lanes>(w.now->x, k + 1);
  const Lanes y = lanes<Lanes>(w.now->y, k + 1);
  const Lanes before_x = lanes<Lanes>(w.now->x, k);
  const Lanes before_y = lanes<Lanes>(w.now->y, k);
  // The coupling of both poses, the later one by its row.
  const CouplingTerms& coupling = w.model.coupling[b];
  const Lanes xx = coupling.xx;
  const Lanes xy = coupling.xy;
  const Lanes yx = coupling.yx;
  const Lanes yy = coupling.yy;
  const Lanes xh = xy * before_x - xx * before_y;
  const Lanes yh = yy * before_x - yx * before_y;
  const Lanes hx = yx * x - xx * y;
  const Lanes hy = yy * x - xy * y;
  const Lanes hh = yh * x - xh * y;
  mixed.linear_x += motion.bx * xx + motion.by * yx;
  mixed.linear_y += motion.bx * xy + motion.by * yy;
  mixed.linear_h += motion.bx * xh + motion.by * yh;
  mixed.angular_x += motion.cx * xx + motion.cy * yx + motion.turn * hx;
  mixed.angular_y += motion.cx * xy + motion.cy * yy + motion.turn * hy;
  mixed.angular_h += motion.cx * xh + motion.cy * yh + motion.turn * hh;

  // The pose after the step equals the pose before it plus the step, so the coupling also depends
  // on the former.
  Quadratic<Lanes> q(w.model.before[b], mu, curved);
  q.turn_about_origin(before_x, before_y);
  q.xx += 2.0 * xx;
  q.xy += xy + yx;
  q.yy += 2.0 * yy;
  q.xh += xh + hx;
  q.yh += yh + hy;
  q.hh += 2.0 * hh;
  add_rows_before(w, k, &Stage::pose_x, q.xx, q.xy, q.xh, q.gx);
  add_rows_before(w, k, &Stage::pose_y, q.xy, q.yy, q.yh, q.gy);
  add_rows_before(w, k, &Stage::pose_heading, q.xh, q.yh, q.hh, q.gh);
}

/// Writes the Newton system at barrier parameter `mu` as stages, Eq. (S8). With `exact` it includes
/// the second derivatives of constraints and dynamics; without, it is Gauss-Newton.
template <typename Lanes>
FAIRWAY_LANES void build_stages(Workspace& w, double mu, bool exact) noexcept {
  const Point& p = *w.now;
  const double dt = w.problem->dt;
  const double half = w.half_turn;
  const double back = half / dt;
  const double curved = exact ? 1.0 : 0.0;
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    const std::size_t k = kLanes * b;
    Stage* stages = &w.stages[k];
    const Lanes x = lanes<Lanes>(p.x, k + 1);
    const Lanes y = lanes<Lanes>(p.y, k + 1);

    // Cost by the pose after the step, with the curvature of the motion that starts there.
    Quadratic<Lanes> pose(w.model.now[b], mu, curved);
    const Lanes weight_x = 2.0 * lanes<Lanes>(w.weight_x, k);
    const Lanes weight_y = 2.0 * lanes<Lanes>(w.weight_y, k);
    const Lanes weight_h = 2.0 * lanes<Lanes>(w.weight_heading, k);
    pose.xx += weight_x;
    pose.yy += weight_y;
    pose.hh = weight_h + curved * lanes<Lanes>(w.model.phi_phi, k + 1);
    pose.gx += weight_x * (x - lanes<Lanes>(w.target_x, k));
    pose.gy += weight_y * (y - lanes<Lanes>(w.target_y, k));
    pose.gh = weight_h * (lanes<Lanes>(p.heading, k + 1) - lanes<Lanes>(w.target_heading, k));
    pose.turn_about_origin(x, y);
    put_rows(stages, &Stage::pose_x, pose.xx, pose.xy, pose.xh, pose.gx);
    put_rows(stages, &Stage::pose_y, pose.xy, pose.yy, pose.yh, pose.gy);
    put_rows(stages, &Stage::pose_heading, pose.xh, pose.yh, pose.hh, pose.gh);

    // A step turns about the position that it leads to, or about the middle of the line there.
    const Lanes free_linear = lanes<Lanes>(w.is_free[kLinear], k);
    const Lanes free_angular = lanes<Lanes>(w.is_free[kAngular], k);
    const Lanes turn = dt * free_angular;
    const Motion<Lanes> motion = {.bx = dt * free_linear * lanes<Lanes>(p.cosine, k),
                                  .by = dt * free_linear * lanes<Lanes>(p.sine, k),
                                  .cx = turn * (y - back * (y - lanes<Lanes>(p.y, k))),
                                  .cy = -turn * (x - back * (x - lanes<Lanes>(p.x, k))),
                                  .turn = turn};
    put_rows(stages, &Stage::motion, motion.bx, motion.by, motion.cx, motion.cy);

    const Lanes phi_phi = free_angular * (curved * lanes<Lanes>(w.model.phi_phi, k));
    const Lanes linear_phi = free_linear * (curved * lanes<Lanes>(w.model.linear_phi, k));
    MixedTerms<Lanes> mixed{};
    mixed.linear_h = linear_phi;
    mixed.angular_h = half * phi_phi;
    if (w.constraint_ranges[b].has_barriers()) add_barriers(w, b, mu, curved, motion, mixed);
    const CommandTerms<Lanes> linear(w, kLinear, k, mu);
    const CommandTerms<Lanes> angular(w, kAngular, k, mu);
    put_rows(stages, &Stage::linear, mixed.linear_x, mixed.linear_y, mixed.linear_h,
             free_linear * linear.gradient);
    put_rows(stages, &Stage::angular, mixed.angular_x, mixed.angular_y, mixed.angular_h,
             free_angular * angular.gradient);
    // Fixed commands do not move: they have a unit Hessian and no other terms.
    put_rows(stages, &Stage::command, linear.hessian + linear.change + (1.0 - free_linear),
             half * free_angular * linear_phi,
             angular.hessian + angular.change + half * half * phi_phi + (1.0 - free_angular), turn);
    put_rows(stages, &Stage::coupling, linear.coupling, angular.coupling, linear.change,
             angular.change);
  }
}

}  // namespace fairway::interior_point
