// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/base/simd_math.hpp"
#include "fairway/mpc/interior_point/body/body_workspace.hpp"

// The Newton system of a body as the stages of a Riccati recursion, docs/solver.md section 3.

namespace fairway::interior_point {

/// A symmetric matrix over (x, y, turn) and a gradient, for four steps.
template <typename Lanes>
struct PoseQuadratic {
  Lanes xx, xy, yy, xh, yh, hh;
  Lanes gx, gy, gh;

  /// `curved` is 1 with the curvature of the constraints, and 0 without.
  FAIRWAY_LANES PoseQuadratic(const PoseTerms& t, double mu, double curved) noexcept
      : xx(t.xx),
        xy(t.xy),
        yy(t.yy),
        xh(t.xh),
        yh(t.yh),
        hh(t.hh),
        gx(-(t.target_x + mu * Lanes(t.by_mu_x))),
        gy(-(t.target_y + mu * Lanes(t.by_mu_y))),
        gh(-(t.target_h + mu * Lanes(t.by_mu_h))) {
    const Lanes bend = curved * Lanes(t.bend);
    xx += bend;
    yy += bend;
    xh += curved * Lanes(t.bend_xh);
    yh += curved * Lanes(t.bend_yh);
    hh += curved * Lanes(t.bend_hh);
  }
};

/// Writes row `index` of member `rows` of four stages.
template <typename Lanes, std::size_t inputs, std::size_t size>
FAIRWAY_LANES void put_stage_rows(BodyStage<inputs>* stages,
                                  std::array<Pack4d, size> BodyStage<inputs>::*rows,
                                  std::size_t index,
                                  const Transposed<Lanes>& t) noexcept {
  (stages[0].*rows)[index] = t.first;
  (stages[1].*rows)[index] = t.second;
  (stages[2].*rows)[index] = t.third;
  (stages[3].*rows)[index] = t.fourth;
}

/// Adds rows to the pose part of the stages before steps k..k+3, except before the first step.
template <typename Lanes, typename Motion>
FAIRWAY_LANES void add_pose_rows_before(BodyWorkspace<Motion>& w,
                                        std::size_t k,
                                        std::size_t row,
                                        const Transposed<Lanes>& rows) noexcept {
  if (k > 0) w.stages[k - 1].pose[row] = w.stages[k - 1].pose[row] + rows.first;
  w.stages[k].pose[row] = w.stages[k].pose[row] + rows.second;
  w.stages[k + 1].pose[row] = w.stages[k + 1].pose[row] + rows.third;
  w.stages[k + 2].pose[row] = w.stages[k + 2].pose[row] + rows.fourth;
}

/// Cost by four poses after their steps, with the curvature of the motion that starts there.
template <typename Lanes, typename Motion>
FAIRWAY_LANES PoseQuadratic<Lanes> pose_quadratic(const BodyWorkspace<Motion>& w,
                                                  std::size_t b,
                                                  double mu,
                                                  double curved) noexcept {
  const std::size_t k = kLanes * b;
  const Lanes x = lanes<Lanes>(w.now->x, k + 1);
  const Lanes y = lanes<Lanes>(w.now->y, k + 1);
  PoseQuadratic<Lanes> q(w.model.now[b], mu, curved);
  const Lanes weight_x = 2.0 * lanes<Lanes>(w.weight_x, k);
  const Lanes weight_y = 2.0 * lanes<Lanes>(w.weight_y, k);
  const Lanes weight_h = 2.0 * lanes<Lanes>(w.weight_heading, k);
  const Lanes gx = weight_x * (x - lanes<Lanes>(w.target_x, k));
  const Lanes gy = weight_y * (y - lanes<Lanes>(w.target_y, k));
  const Lanes gh =
      weight_h * (lanes<Lanes>(w.now->heading, k + 1) - lanes<Lanes>(w.target_heading, k));
  const Lanes xh = -weight_x * y;
  const Lanes yh = weight_y * x;
  q.xx += weight_x;
  q.yy += weight_y;
  q.xh += xh;
  q.yh += yh;
  q.hh += (weight_h + curved * lanes<Lanes>(w.model.turn_turn, k + 1)) + (yh * x - xh * y);
  q.gx += gx;
  q.gy += gy;
  q.gh += gh + (gy * x - gx * y);
  return q;
}

/// Adds the cost of obstacles near block b: that of the pose before each step, and its coupling
/// with the pose after the step, which is the pose before plus the motion.
template <typename Lanes, typename Motion>
FAIRWAY_LANES void add_body_obstacles(
    BodyWorkspace<Motion>& w,
    std::size_t b,
    double mu,
    double curved,
    std::array<std::array<Lanes, 3>, static_cast<std::size_t>(Motion::kInputs)>& mixed) noexcept {
  const std::size_t k = kLanes * b;
  std::array<std::array<Lanes, 3>, 3> c;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      c[i][j] = w.model.coupling[b].entries[i][j];
  }
  for (std::size_t j = 0; j < mixed.size(); ++j) {
    const Lanes x = lanes<Lanes>(w.model.motion_x[j], k);
    const Lanes y = lanes<Lanes>(w.model.motion_y[j], k);
    const Lanes h = lanes<Lanes>(w.model.motion_h[j], k);
    for (std::size_t i = 0; i < 3; ++i)
      mixed[j][i] += x * c[0][i] + y * c[1][i] + h * c[2][i];
  }
  PoseQuadratic<Lanes> q(w.model.before[b], mu, curved);
  q.xx += 2.0 * c[0][0];
  q.xy += c[0][1] + c[1][0];
  q.yy += 2.0 * c[1][1];
  q.xh += c[0][2] + c[2][0];
  q.yh += c[1][2] + c[2][1];
  q.hh += 2.0 * c[2][2];
  add_pose_rows_before(w, k, 0, transposed(q.xx, q.xy, q.xh, q.gx));
  add_pose_rows_before(w, k, 1, transposed(q.xy, q.yy, q.yh, q.gy));
  add_pose_rows_before(w, k, 2, transposed(q.xh, q.yh, q.hh, q.gh));
}

/// Writes the Hessian by the inputs of four steps, and computes the gradients by them.
template <typename Lanes, typename Motion>
FAIRWAY_LANES void put_input_terms(
    BodyWorkspace<Motion>& w,
    std::size_t k,
    double mu,
    double curved,
    std::array<Lanes, static_cast<std::size_t>(Motion::kInputs)>& gradient) noexcept {
  constexpr std::size_t n = Motion::kInputs;
  std::array<Lanes, lower(n, 0)> hessian;
  for (std::size_t i = 0; i < hessian.size(); ++i)
    hessian[i] = curved * lanes<Lanes>(w.model.input_input[i], k);
  for (std::size_t j = 0; j < n; ++j) {
    Lanes change = 2.0 * lanes<Lanes>(w.change_weight[j], k);
    gradient[j] = lanes<Lanes>(w.model.gradient[j], k) + mu * lanes<Lanes>(w.bounds[j].by_mu, k);
    if (w.has_change_bounds) {
      const Bounds& bounds = w.bounds[n + j];
      change += lanes<Lanes>(bounds.curvature, k);
      gradient[j] += mu * (lanes<Lanes>(bounds.by_mu, k) - lanes<Lanes>(bounds.by_mu, k + 1));
    }
    put(w.change[j], k, change);
    hessian[lower(j, j)] +=
        2.0 * lanes<Lanes>(w.input_weight[j], k) + lanes<Lanes>(w.bounds[j].curvature, k) + change;
  }
  for (std::size_t i = 0; i < w.num_limits; ++i) {
    const auto& normal = w.problem->input_limits[i].normal;
    const Bounds& bounds = w.bounds[2 * n + i];
    const Lanes curvature = lanes<Lanes>(bounds.curvature, k);
    const Lanes by_mu = mu * lanes<Lanes>(bounds.by_mu, k);
    for (std::size_t r = 0; r < n; ++r) {
      const double a = normal[static_cast<Eigen::Index>(r)];
      gradient[r] += a * by_mu;
      for (std::size_t c = 0; c <= r; ++c)
        hessian[lower(r, c)] += (a * normal[static_cast<Eigen::Index>(c)]) * curvature;
    }
  }
  for (std::size_t i = 0; i < hessian.size(); ++i)
    put(w.input_hessian[i], k, hessian[i]);
}

/// Writes the Newton system at barrier parameter `mu` as stages. With `exact` it includes the
/// second derivatives of constraints and motion; without, it is Gauss-Newton.
template <typename Lanes, typename Motion>
FAIRWAY_LANES void build_body_stages(BodyWorkspace<Motion>& w, double mu, bool exact) noexcept {
  constexpr std::size_t n = Motion::kInputs;
  const double curved = exact ? 1.0 : 0.0;
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    const std::size_t k = kLanes * b;
    BodyStage<n>* stages = &w.stages[k];
    const PoseQuadratic<Lanes> q = pose_quadratic<Lanes>(w, b, mu, curved);
    put_stage_rows(stages, &BodyStage<n>::pose, 0, transposed(q.xx, q.xy, q.xh, q.gx));
    put_stage_rows(stages, &BodyStage<n>::pose, 1, transposed(q.xy, q.yy, q.yh, q.gy));
    put_stage_rows(stages, &BodyStage<n>::pose, 2, transposed(q.xh, q.yh, q.hh, q.gh));
    std::array<Lanes, n> gradient;
    put_input_terms(w, k, mu, curved, gradient);
    std::array<std::array<Lanes, 3>, n> mixed{};
    for (std::size_t j = 0; j < n; ++j)
      mixed[j][2] = curved * lanes<Lanes>(w.model.turn_input[j], k);
    if (w.constraint_ranges[b].has_barriers()) add_body_obstacles(w, b, mu, curved, mixed);
    for (std::size_t j = 0; j < n; ++j) {
      put_stage_rows(stages, &BodyStage<n>::mixed, j,
                     transposed(mixed[j][0], mixed[j][1], mixed[j][2], gradient[j]));
      put_stage_rows(
          stages, &BodyStage<n>::motion, j,
          transposed(lanes<Lanes>(w.model.motion_x[j], k), lanes<Lanes>(w.model.motion_y[j], k),
                     lanes<Lanes>(w.model.motion_h[j], k), Lanes(0.0)));
    }
  }
}

}  // namespace fairway::interior_point
