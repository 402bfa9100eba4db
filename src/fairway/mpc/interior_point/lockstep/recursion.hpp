// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/interior_point/lockstep/lockstep.hpp"
#include "fairway/mpc/interior_point/newton/stages.hpp"

// The Newton systems of four starts, solved by one Riccati recursion, docs/solver.md section 3.

namespace fairway::interior_point::lockstep {

/// Derivatives by the pose (x, y, heading), with the gradient last.
template <typename Lanes>
struct PoseRow {
  Lanes x = 0.0, y = 0.0, h = 0.0, g = 0.0;
};

/// Second derivatives by the commands alone.
template <typename Lanes>
struct CommandHessian {
  Lanes uu = 0.0, ur = 0.0, rr = 0.0;
};

/// Returns the motion of step k by its commands.
template <typename Lanes>
FAIRWAY_LANES Motion<Lanes> motion_of(const Workspace& w,
                                      const FourPoints& p,
                                      std::size_t k) noexcept {
  const double dt = w.problem->dt;
  const double back = w.half_turn / dt;
  const double turn = dt * w.is_free[kAngular][k];
  const double length = dt * w.is_free[kLinear][k];
  const Lanes x = p.x[k + 1];
  const Lanes y = p.y[k + 1];
  return {.bx = length * Lanes(p.cosine[k]),
          .by = length * Lanes(p.sine[k]),
          .cx = turn * (y - back * (y - p.y[k])),
          .cy = -turn * (x - back * (x - p.x[k])),
          .turn = Lanes(turn)};
}

/// Cost by the pose after step k, without the obstacles' terms of the step after it.
template <typename Lanes>
FAIRWAY_LANES Quadratic<Lanes> pose_terms(const Lockstep& s,
                                          std::size_t k,
                                          const Lanes& mu,
                                          const Lanes& curved) noexcept {
  const Workspace& w = *s.problem;
  const FourPoints& p = s.points[s.now];
  Quadratic<Lanes> pose(s.model_now[k], mu, curved);
  const Lanes x = p.x[k + 1];
  const Lanes y = p.y[k + 1];
  pose.xx += 2.0 * w.weight_x[k];
  pose.yy += 2.0 * w.weight_y[k];
  pose.hh = 2.0 * w.weight_heading[k] + curved * s.phi_phi[k + 1];
  pose.gx += 2.0 * w.weight_x[k] * (x - w.target_x[k]);
  pose.gy += 2.0 * w.weight_y[k] * (y - w.target_y[k]);
  pose.gh = 2.0 * w.weight_heading[k] * (p.heading[k + 1] - Lanes(w.target_heading[k]));
  pose.turn_about_origin(x, y);
  return pose;
}

/// Terms of the obstacles of step k by the pose before it; adds those by the commands to `mixed`.
template <typename Lanes>
FAIRWAY_LANES Quadratic<Lanes> obstacle_terms(const Lockstep& s,
                                              std::size_t k,
                                              const Lanes& mu,
                                              const Lanes& curved,
                                              const Motion<Lanes>& motion,
                                              MixedTerms<Lanes>& mixed) noexcept {
  const FourPoints& p = s.points[s.now];
  const Lanes x = p.x[k + 1];
  const Lanes y = p.y[k + 1];
  const Lanes before_x = p.x[k];
  const Lanes before_y = p.y[k];
  const Lanes xx = s.coupling[k].xx;
  const Lanes xy = s.coupling[k].xy;
  const Lanes yx = s.coupling[k].yx;
  const Lanes yy = s.coupling[k].yy;
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
  Quadratic<Lanes> q(s.model_before[k], mu, curved);
  q.turn_about_origin(before_x, before_y);
  q.xx += 2.0 * xx;
  q.xy += xy + yx;
  q.yy += 2.0 * yy;
  q.xh += xh + hx;
  q.yh += yh + hy;
  q.hh += 2.0 * hh;
  return q;
}

template <typename Lanes>
FAIRWAY_LANES void add(const Quadratic<Lanes>& from, Quadratic<Lanes>& to) noexcept {
  to.xx += from.xx;
  to.xy += from.xy;
  to.yy += from.yy;
  to.xh += from.xh;
  to.yh += from.yh;
  to.hh += from.hh;
  to.gx += from.gx;
  to.gy += from.gy;
  to.gh += from.gh;
}

/// Factorises the four systems backwards over the steps, Eq. (S8) to (S11). `curved` is 1 for the
/// exact Hessian of a start and 0 for Gauss-Newton; `damping` is added by every command.
/// @return 0 for each start whose reduced Hessian is positive definite, else 1.
template <typename Lanes>
[[nodiscard]] FAIRWAY_LANES Lanes
factorise(Lockstep& s, const Lanes& mu, const Lanes& curved, const Lanes& damping) noexcept {
  constexpr double kLeastPivot = 1e-9;
  const Workspace& w = *s.problem;
  const FourPoints& p = s.points[s.now];
  const double half = w.half_turn;
  Quadratic<Lanes> v = pose_terms(s, w.horizon - 1, mu, curved);
  PoseRow<Lanes> vu;
  PoseRow<Lanes> vr;
  CommandHessian<Lanes> vc;
  Lanes slope = 0.0;
  Lanes failed = 0.0;
  for (std::size_t k = w.horizon; k-- > 0;) {
    const double free_u = w.is_free[kLinear][k];
    const double free_r = w.is_free[kAngular][k];
    const Motion<Lanes> m = motion_of<Lanes>(w, p, k);
    const Lanes phi_phi = free_r * (curved * s.phi_phi[k]);
    const Lanes linear_phi = free_u * (curved * s.linear_phi[k]);
    MixedTerms<Lanes> mixed{};
    mixed.linear_h = linear_phi;
    mixed.angular_h = half * phi_phi;
    Quadratic<Lanes> next = v;
    if (k > 0) add(pose_terms(s, k - 1, mu, curved), next);
    if (s.near[k].obstacles > 0) add(obstacle_terms(s, k, mu, curved, m, mixed), next);

    // The terms by the commands alone.
    std::array<Lanes, 2> hessian;
    std::array<Lanes, 2> change;
    std::array<Lanes, 2> gradient;
    for (std::size_t j = 0; j < 2; ++j) {
      hessian[j] = 2.0 * w.command_weight[j][k] + Lanes(s.bounds[j][k].curvature);
      change[j] = Lanes(2.0 * w.change_weight[j][k]);
      gradient[j] = s.gradient[j][k] + mu * s.bounds[j][k].by_mu;
      if (w.num_bounds > 2) {
        change[j] += s.bounds[2 + j][k].curvature;
        gradient[j] += mu * s.bounds[2 + j][k].by_mu;
        if (k + 1 < w.horizon) gradient[j] -= mu * s.bounds[2 + j][k + 1].by_mu;
      }
    }

    // B^T V and B^T V B, Eq. (S8).
    const PoseRow<Lanes> wu = {.x = (m.bx * v.xx + m.by * v.xy) + vu.x,
                               .y = (m.bx * v.xy + m.by * v.yy) + vu.y,
                               .h = (m.bx * v.xh + m.by * v.yh) + vu.h,
                               .g = (m.bx * v.gx + m.by * v.gy) + vu.g};
    const PoseRow<Lanes> wr = {.x = (m.cx * v.xx + m.cy * v.xy) + (m.turn * v.xh + vr.x),
                               .y = (m.cx * v.xy + m.cy * v.yy) + (m.turn * v.yh + vr.y),
                               .h = (m.cx * v.xh + m.cy * v.yh) + (m.turn * v.hh + vr.h),
                               .g = (m.cx * v.gx + m.cy * v.gy) + (m.turn * v.gh + vr.g)};
    const Lanes Huu = (m.bx * wu.x + m.by * wu.y) + (m.bx * vu.x + m.by * vu.y) +
                      (vc.uu + (hessian[0] + change[0] + (1.0 - free_u) + damping));
    const Lanes Hur = (m.bx * wr.x + m.by * wr.y) + (m.cx * vu.x + m.cy * vu.y) +
                      (m.turn * vu.h + vc.ur + half * free_r * linear_phi);
    const Lanes Hrr =
        (m.cx * wr.x + m.cy * wr.y + m.turn * wr.h) + (m.cx * vr.x + m.cy * vr.y + m.turn * vr.h) +
        (vc.rr + (hessian[1] + change[1] + half * half * phi_phi + (1.0 - free_r) + damping));
    const Lanes det = Huu * Hrr - Hur * Hur;
    failed = where_greater(Huu, Lanes(kLeastPivot),
                           where_greater(det, kLeastPivot * Huu, failed, Lanes(1.0)), Lanes(1.0));
    const Lanes inverse = 1.0 / det;
    const PoseRow<Lanes> hu = {.x = wu.x + mixed.linear_x,
                               .y = wu.y + mixed.linear_y,
                               .h = wu.h + mixed.linear_h,
                               .g = wu.g + free_u * gradient[0]};
    const PoseRow<Lanes> hr = {.x = wr.x + mixed.angular_x,
                               .y = wr.y + mixed.angular_y,
                               .h = wr.h + mixed.angular_h,
                               .g = wr.g + free_r * gradient[1]};
    const Lanes iuu = Huu * inverse;
    const Lanes iur = Hur * inverse;
    const Lanes irr = Hrr * inverse;
    const PoseRow<Lanes> ku = {.x = iur * hr.x - irr * hu.x,
                               .y = iur * hr.y - irr * hu.y,
                               .h = iur * hr.h - irr * hu.h,
                               .g = iur * hr.g - irr * hu.g};
    const PoseRow<Lanes> kr = {.x = iur * hu.x - iuu * hr.x,
                               .y = iur * hu.y - iuu * hr.y,
                               .h = iur * hu.h - iuu * hr.h,
                               .g = iur * hu.g - iuu * hr.g};
    slope += hu.g * ku.g + hr.g * kr.g;

    // Cost to go before step k, Eq. (S10).
    v.xx = next.xx + (hu.x * ku.x + hr.x * kr.x);
    v.xy = next.xy + (hu.x * ku.y + hr.x * kr.y);
    v.xh = next.xh + (hu.x * ku.h + hr.x * kr.h);
    v.yy = next.yy + (hu.y * ku.y + hr.y * kr.y);
    v.yh = next.yh + (hu.y * ku.h + hr.y * kr.h);
    v.hh = next.hh + (hu.h * ku.h + hr.h * kr.h);
    v.gx = next.gx + (hu.x * ku.g + hr.x * kr.g);
    v.gy = next.gy + (hu.y * ku.g + hr.y * kr.g);
    v.gh = next.gh + (hu.h * ku.g + hr.h * kr.g);
    const Lanes fu = w.is_coupled[kLinear][k] * change[0];
    const Lanes fr = w.is_coupled[kAngular][k] * change[1];
    vu = {.x = -fu * ku.x, .y = -fu * ku.y, .h = -fu * ku.h, .g = -fu * ku.g};
    vr = {.x = -fr * kr.x, .y = -fr * kr.y, .h = -fr * kr.h, .g = -fr * kr.g};
    FourFeedback& f = s.feedback[k];
    const Lanes uu = irr * fu;
    const Lanes ur = -iur * fr;
    const Lanes rr = iuu * fr;
    vc = {.uu = change[0] - fu * uu, .ur = -fu * ur, .rr = change[1] - fr * rr};
    f.linear[0] = ku.x;
    f.linear[1] = ku.y;
    f.linear[2] = ku.h;
    f.linear[3] = ku.g;
    f.angular[0] = kr.x;
    f.angular[1] = kr.y;
    f.angular[2] = kr.h;
    f.angular[3] = kr.g;
    f.linear_linear = uu;
    f.linear_angular = ur;
    f.angular_linear = -iur * fu;
    f.angular_angular = rr;
  }
  s.step_slope = slope;
  return failed;
}

/// Computes the Newton steps by the forward recursion, Eq. (S12).
template <typename Lanes>
FAIRWAY_LANES void substitute(Lockstep& s) noexcept {
  const Workspace& w = *s.problem;
  const FourPoints& p = s.points[s.now];
  Lanes x = 0.0;
  Lanes y = 0.0;
  Lanes h = 0.0;
  Lanes u = 0.0;
  Lanes r = 0.0;
  for (std::size_t k = 0; k < w.horizon; ++k) {
    const FourFeedback& f = s.feedback[k];
    const Motion<Lanes> m = motion_of<Lanes>(w, p, k);
    const Lanes next_u = ((f.linear[3] + f.linear[0] * x) + (f.linear[1] * y + f.linear[2] * h)) +
                         (f.linear_linear * u + f.linear_angular * r);
    const Lanes next_r =
        ((f.angular[3] + f.angular[0] * x) + (f.angular[1] * y + f.angular[2] * h)) +
        (f.angular_linear * u + f.angular_angular * r);
    u = next_u;
    r = next_r;
    x += m.bx * u + m.cx * r;
    y += m.by * u + m.cy * r;
    h += m.turn * r;
    s.step_commands[kLinear][k + 1] = u;
    s.step_commands[kAngular][k + 1] = r;
    s.step_x[k + 1] = x - p.y[k + 1] * h;
    s.step_y[k + 1] = y + p.x[k + 1] * h;
  }
}

}  // namespace fairway::interior_point::lockstep
