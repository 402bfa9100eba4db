// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/base/simd_math.hpp"
#include "fairway/mpc/interior_point/body/body_stages.hpp"

namespace fairway::interior_point {

/// Factor and inverse of a small symmetric matrix.
template <std::size_t n>
using SmallMatrix = std::array<std::array<double, n>, n>;

/// Inverts a symmetric matrix, of which the lower triangle is read. @return Whether it is positive
/// definite.
[[gnu::always_inline]] inline bool invert(const SmallMatrix<2>& m,
                                          SmallMatrix<2>& inverse) noexcept {
  constexpr double kLeastPivot = 1e-9;  // smaller pivots count as not positive
  const double det = m[0][0] * m[1][1] - m[1][0] * m[1][0];
  if (!(m[0][0] > kLeastPivot && det > kLeastPivot * m[0][0])) return false;
  const double scale = 1.0 / det;
  inverse[0] = {m[1][1] * scale, -m[1][0] * scale};
  inverse[1] = {-m[1][0] * scale, m[0][0] * scale};
  return true;
}
// By factors L D L^T: limits of sums add large matrices of rank one, whose cofactors
// would cancel.
[[gnu::always_inline]] inline bool invert(const SmallMatrix<3>& m,
                                          SmallMatrix<3>& inverse) noexcept {
  constexpr double kLeastPivot = 1e-9;
  if (!(m[0][0] > kLeastPivot)) return false;
  const double e0 = 1.0 / m[0][0];
  const double l10 = m[1][0] * e0;
  const double l20 = m[2][0] * e0;
  const double d1 = m[1][1] - l10 * m[1][0];
  if (!(d1 > kLeastPivot)) return false;
  const double e1 = 1.0 / d1;
  const double below = m[2][1] - l20 * m[1][0];
  const double l21 = below * e1;
  const double d2 = m[2][2] - l20 * m[2][0] - l21 * below;
  if (!(d2 > kLeastPivot)) return false;
  const double e2 = 1.0 / d2;
  const double a20 = l10 * l21 - l20;
  inverse[0] = {e0 + l10 * l10 * e1 + a20 * a20 * e2, -l10 * e1 - a20 * l21 * e2, a20 * e2};
  inverse[1] = {inverse[0][1], e1 + l21 * l21 * e2, -l21 * e2};
  inverse[2] = {inverse[0][2], inverse[1][2], e2};
  return true;
}

/// Factorises the Newton system in `w.stages` backwards over the steps, Eq. (S8) to (S11), for any
/// number of inputs. `damping` is added to the Hessian by every input. Lanes are (x, y, turn) and
/// the gradient here.
/// @return Whether the reduced Hessian is positive definite.
template <typename Lanes, typename Motion>
[[nodiscard]] FAIRWAY_LANES bool body_riccati_backward(BodyWorkspace<Motion>& w,
                                                       double damping) noexcept {
  constexpr std::size_t n = Motion::kInputs;
  double slope = 0.0;
  // Cost to go as a function of the pose after step k and, through the change after it, of the
  // input of step k.
  std::array<Lanes, 3> v;
  for (std::size_t i = 0; i < 3; ++i)
    v[i] = w.stages[w.horizon - 1].pose[i];
  std::array<Lanes, n> vn{};
  SmallMatrix<n> vnn{};
  for (std::size_t k = w.horizon; k-- > 0;) {
    const BodyStage<n>& s = w.stages[k];
    const BodyStage<n>& previous = w.stages[k > 0 ? k - 1 : 0];
    std::array<Lanes, n> h;
    SmallMatrix<n> hessian;
    for (std::size_t i = 0; i < n; ++i) {
      const Pack4d& m = s.motion[i];
      h[i] = (m[0] * v[0] + m[1] * v[1]) + (m[2] * v[2] + vn[i]);  // B^T V
      for (std::size_t j = 0; j <= i; ++j) {
        const Pack4d& c = s.motion[j];
        hessian[i][j] = (w.input_hessian[lower(i, j)][k] + vnn[i][j]) +
                        ((c[0] * h[i][0] + c[1] * h[i][1]) + c[2] * h[i][2]) +
                        ((m[0] * vn[j][0] + m[1] * vn[j][1]) + m[2] * vn[j][2]);
      }
      hessian[i][i] += damping;
    }
    SmallMatrix<n> inverse;
    if (!invert(hessian, inverse)) return false;
    for (std::size_t i = 0; i < n; ++i)
      h[i] += s.mixed[i];

    // Eliminate the input: gain = -H^-1 h, Eq. (S9), and the cost to go before step k, Eq. (S10).
    std::array<Lanes, n> gain;
    for (std::size_t i = 0; i < n; ++i) {
      Lanes sum = inverse[i][0] * h[0];
      for (std::size_t j = 1; j < n; ++j)
        sum += inverse[i][j] * h[j];
      gain[i] = -sum;
      slope += h[i][3] * gain[i][3];
    }
    for (std::size_t r = 0; r < 3; ++r) {
      v[r] += previous.pose[r];
      for (std::size_t i = 0; i < n; ++i)
        v[r] += h[i][r] * gain[i];
    }
    BodyFeedback<n>& f = w.feedback[k];
    for (std::size_t i = 0; i < n; ++i) {
      const double coupling = w.change[i][k];
      f.gain[i] = gain[i];
      vn[i] = -coupling * gain[i];
      for (std::size_t j = 0; j < n; ++j) {
        const double by_change = inverse[i][j] * w.change[j][k];
        vnn[i][j] = -coupling * by_change;
        // The pose before step k is the pose before step k - 1 plus the motion of input k - 1.
        const Pack4d& m = previous.motion[j];
        f.change[i][j] = by_change + ((gain[i][0] * m[0] + gain[i][1] * m[1]) + gain[i][2] * m[2]);
      }
      vnn[i][i] += coupling;
    }
  }
  w.step.slope = slope;
  return true;
}

/// Computes the Newton step by the forward recursion: fills `w.step`.
template <typename Motion>
void body_riccati_forward(BodyWorkspace<Motion>& w) noexcept {
  constexpr std::size_t n = Motion::kInputs;
  BodyStep<Motion>& step = w.step;
  std::array<double, 3> before{};  // pose before step k - 1
  std::array<double, 3> pose{};    // pose before step k
  std::array<double, n> v{};
  for (std::size_t k = 0; k < w.horizon; ++k) {
    const BodyStage<n>& s = w.stages[k];
    const BodyFeedback<n>& f = w.feedback[k];
    std::array<double, n> next{};
    for (std::size_t i = 0; i < n; ++i) {
      const Pack4d& gain = f.gain[i];
      next[i] = (gain[3] + gain[0] * before[0]) + (gain[1] * before[1] + gain[2] * before[2]);
      for (std::size_t j = 0; j < n; ++j)
        next[i] += f.change[i][j] * v[j];
    }
    v = next;
    before = pose;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t r = 0; r < 3; ++r)
        pose[r] += s.motion[i][r] * v[i];
      step.inputs[i][k + 1] = v[i];
    }
    step.x[k + 1] = pose[0];
    step.y[k + 1] = pose[1];
    step.turn[k + 1] = pose[2];
  }
}

}  // namespace fairway::interior_point
