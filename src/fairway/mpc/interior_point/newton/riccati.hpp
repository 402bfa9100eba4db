// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/interior_point/workspace/workspace.hpp"

namespace fairway::interior_point {

/// Factorises the Newton system in `w.stages` backwards over the steps, Eq. (S8) to (S11).
///
/// `damping` is added to the Hessian by every command. Also computes the slope of the Newton step.
/// Lanes are (x, y, heading) and the gradient here.
/// @return Whether the reduced Hessian is positive definite; if not, `w.feedback` is incomplete.
template <typename Lanes>
[[nodiscard]] FAIRWAY_LANES bool riccati_backward(Workspace& w, double damping) noexcept {
  constexpr double kLeastPivot = 1e-9;  // smaller pivots count as not positive
  double slope = 0.0;
  // Cost to go as a function of the pose after step k. Through the change after it, it also depends
  // on the command of step k.
  Lanes vx = w.stages[w.horizon - 1].pose_x;
  Lanes vy = w.stages[w.horizon - 1].pose_y;
  Lanes vh = w.stages[w.horizon - 1].pose_heading;
  Lanes vu = 0.0;
  Lanes vr = 0.0;
  double vuu = 0.0;
  double vur = 0.0;
  double vrr = 0.0;
  for (std::size_t k = w.horizon; k-- > 0;) {
    const Stage& s = w.stages[k];
    const Stage& previous = w.stages[k > 0 ? k - 1 : 0];
    const double bx = s.motion[0];
    const double by = s.motion[1];
    const double cx = s.motion[2];
    const double cy = s.motion[3];
    const double turn = s.command[3];
    // B^T V and B^T V B: the effect of a command on the cost to go, Eq. (S8). Terms that are known
    // early are added first, because each step depends on the one after it.
    const double from_u = (bx * vu[0] + by * vu[1]) + (vuu + (s.command[0] + damping));
    const double from_ur = (cx * vu[0] + cy * vu[1]) + (turn * vu[2] + (vur + s.command[1]));
    const double from_r =
        (cx * vr[0] + cy * vr[1]) + (turn * vr[2] + (vrr + (s.command[2] + damping)));
    const Lanes wu = (bx * vx + by * vy) + vu;
    const Lanes wr = (cx * vx + cy * vy) + (turn * vh + vr);
    const double Huu = (bx * wu[0] + from_u) + by * wu[1];
    const double Hur = (bx * wr[0] + from_ur) + by * wr[1];
    const double Hrr = (cx * wr[0] + from_r) + (cy * wr[1] + turn * wr[2]);

    // Eliminate the command: K = L / det, Eq. (S9).
    const double det = Huu * Hrr - Hur * Hur;
    if (!(Huu > kLeastPivot && det > kLeastPivot * Huu)) return false;
    const double inverse = 1.0 / det;
    const Lanes hu = wu + s.linear;
    const Lanes hr = wr + s.angular;
    const Lanes lu = Hur * hr - Hrr * hu;
    const Lanes lr = Hur * hu - Huu * hr;
    slope += (hu[3] * lu[3] + hr[3] * lr[3]) * inverse;

    // Cost to go before step k, including the cost of its pose, Eq. (S10).
    vx = (vx + previous.pose_x) + (hu[0] * lu + hr[0] * lr) * inverse;
    vy = (vy + previous.pose_y) + (hu[1] * lu + hr[1] * lr) * inverse;
    vh = (vh + previous.pose_heading) + (hu[2] * lu + hr[2] * lr) * inverse;
    const Lanes ku = lu * inverse;
    const Lanes kr = lr * inverse;
    const double fu = s.coupling[0];
    const double fr = s.coupling[1];
    const double uu = Hrr * inverse * fu;
    const double ur = -Hur * inverse * fr;
    const double ru = -Hur * inverse * fu;
    const double rr = Huu * inverse * fr;
    vu = -fu * ku;
    vr = -fr * kr;
    vuu = s.coupling[2] - fu * uu;
    vur = -fu * ur;
    vrr = s.coupling[3] - fr * rr;

    // The pose before step k is the pose before step k - 1 plus the motion of command k - 1.
    const Pack4d& b = previous.motion;
    const double b_turn = previous.command[3];
    Feedback& f = w.feedback[k];
    f.gain[kLinear] = ku;
    f.gain[kAngular] = kr;
    f.change[kLinear][kLinear] = uu + (ku[0] * b[0] + ku[1] * b[1]);
    f.change[kLinear][kAngular] = ur + ((ku[0] * b[2] + ku[1] * b[3]) + ku[2] * b_turn);
    f.change[kAngular][kLinear] = ru + (kr[0] * b[0] + kr[1] * b[1]);
    f.change[kAngular][kAngular] = rr + ((kr[0] * b[2] + kr[1] * b[3]) + kr[2] * b_turn);
  }
  w.step.slope = slope;
  return true;
}

/// Computes the Newton step by the forward recursion: fills `w.step`, Eq. (S12).
inline void riccati_forward(Workspace& w) noexcept {
  NewtonStep& step = w.step;
  // Poses before step k - 1 and before step k, and command k - 1.
  std::array<double, 3> before{};
  std::array<double, 3> pose{};
  std::array<double, 2> v{};
  for (std::size_t k = 0; k < w.horizon; ++k) {
    const Stage& s = w.stages[k];
    const Feedback& f = w.feedback[k];
    std::array<double, 2> next{};
    for (std::size_t j = 0; j < 2; ++j) {
      const Pack4d& gain = f.gain[j];
      next[j] = ((gain[3] + gain[0] * before[0]) + (gain[1] * before[1] + gain[2] * before[2])) +
                (f.change[j][0] * v[0] + f.change[j][1] * v[1]);
    }
    v = next;
    before = pose;
    pose[0] += s.motion[0] * v[0] + s.motion[2] * v[1];
    pose[1] += s.motion[1] * v[0] + s.motion[3] * v[1];
    pose[2] += s.command[3] * v[1];
    step.commands[kLinear][k + 1] = v[0];
    step.commands[kAngular][k + 1] = v[1];
    step.x[k + 1] = pose[0] - w.now->y[k + 1] * pose[2];
    step.y[k + 1] = pose[1] + w.now->x[k + 1] * pose[2];
  }
}

}  // namespace fairway::interior_point
