// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/riccati.hpp"

#include <cmath>

namespace fairway::interior_point {
namespace {

// Quadratic cost to go over (x, y, heading | u, r), the latter being the command before. Symmetric
// entries once; g is the gradient.
struct CostToGo {
  double xx = 0, xy = 0, yy = 0, xh = 0, yh = 0, hh = 0;
  double xu = 0, yu = 0, hu = 0, xr = 0, yr = 0, hr = 0;
  double uu = 0, ur = 0, rr = 0;
  double gx = 0, gy = 0, gh = 0, gu = 0, gr = 0;
};

// Pivots below this count as not positive.
constexpr double kLeastPivot = 1e-9;

}  // namespace

bool riccati_backward(Workspace& w, double exactness, double damping) noexcept {
  const StageModel& m = w.model;
  const Point& t = *w.now;
  const double dt = w.problem->dt;
  const double half = w.half_turn;
  CostToGo v;
  for (std::size_t k = w.horizon; k-- > 0;) {
    // The cost of pose k + 1 itself.
    const double bend = exactness * m.bend[k + 1];
    v.xx += m.xx[k + 1] + bend;
    v.xy += m.xy[k + 1];
    v.yy += m.yy[k + 1] + bend;
    v.hh += 2.0 * w.weight_heading[k + 1];
    v.gx += m.gradient_x[k + 1];
    v.gy += m.gradient_y[k + 1];
    v.gh += m.gradient_heading[k + 1];

    // One step of the dynamics: p' = p + a dpsi + b du + half a dr, psi' = psi + dt dr.
    const double ax = m.motion_x[k];
    const double ay = m.motion_y[k];
    const double bx = dt * t.cosine[k];
    const double by = dt * t.sine[k];
    // Products of the Hessian with the directions (a, 1), (b, 0) and (half a, dt).
    const double aax = v.xx * ax + v.xy * ay;
    const double aay = v.xy * ax + v.yy * ay;
    const double aah = v.xh * ax + v.yh * ay;
    const double hx = aax + v.xh;
    const double hy = aay + v.yh;
    const double hh = aah + v.hh;
    const double ux = v.xx * bx + v.xy * by + v.xu;
    const double uy = v.xy * bx + v.yy * by + v.yu;
    const double uh = v.xh * bx + v.yh * by + v.hu;
    const double rx = half * aax + dt * v.xh + v.xr;
    const double ry = half * aay + dt * v.yh + v.yr;
    const double rh = half * aah + dt * v.hh + v.hr;
    // Coupling of p_{k+1} and p_k by the barrier rows.
    const double mxx = m.cross_xx[k + 1];
    const double mxy = m.cross_xy[k + 1];
    const double myx = m.cross_yx[k + 1];
    const double myy = m.cross_yy[k + 1];
    const double amx = ax * mxx + ay * myx;
    const double amy = ax * mxy + ay * myy;

    // Hessian by (x, y, heading) of pose k, by command k, and mixed.
    const double phi_phi = exactness * m.phi_phi[k];
    const double linear_phi = exactness * m.linear_phi[k];
    const double Hxx = v.xx + 2.0 * mxx;
    const double Hxy = v.xy + mxy + myx;
    const double Hyy = v.yy + 2.0 * myy;
    const double Hxh = hx + amx;
    const double Hyh = hy + amy;
    const double Hhh = ax * hx + ay * hy + hh + phi_phi;
    double Hux = ux + bx * mxx + by * myx;
    double Huy = uy + bx * mxy + by * myy;
    double Huh = ax * ux + ay * uy + uh + linear_phi;
    double Hrx = rx + half * amx;
    double Hry = ry + half * amy;
    double Hrh = ax * rx + ay * ry + rh + half * phi_phi;
    double Huu =
        bx * (ux + v.xu) + by * (uy + v.yu) + v.uu + m.hessian[0][k] + m.change[0][k] + damping;
    double Hur =
        bx * rx + by * ry + half * (ax * v.xu + ay * v.yu) + dt * v.hu + v.ur + half * linear_phi;
    double Hrr = half * (ax * (rx + v.xr) + ay * (ry + v.yr)) + dt * (rh + v.hr) + v.rr +
                 half * half * phi_phi + m.hessian[1][k] + m.change[1][k] + damping;
    const double ag = ax * v.gx + ay * v.gy;
    double gu = bx * v.gx + by * v.gy + v.gu + m.gradient[0][k];
    double gr = half * ag + dt * v.gh + v.gr + m.gradient[1][k];
    const double gh = ag + v.gh;
    double su = m.change[0][k];
    double sr = m.change[1][k];
    if (w.limits[0].fixed[k]) {
      Huu = 1.0;
      Hux = Huy = Huh = Hur = gu = 0.0;
    }
    if (w.limits[1].fixed[k]) {
      Hrr = 1.0;
      Hrx = Hry = Hrh = Hur = gr = 0.0;
    }
    const double fu = w.limits[0].fixed[k] ? 0.0 : su;
    const double fr = w.limits[1].fixed[k] ? 0.0 : sr;

    // Eliminate the command.
    const double det = Huu * Hrr - Hur * Hur;
    if (!(Huu > kLeastPivot && det > kLeastPivot * Huu)) return false;
    const double inv = 1.0 / det;
    const double iuu = Hrr * inv;
    const double iur = -Hur * inv;
    const double irr = Huu * inv;
    Feedback& f = w.feedback[k];
    const double kux = -(iuu * Hux + iur * Hrx);
    const double kuy = -(iuu * Huy + iur * Hry);
    const double kuh = -(iuu * Huh + iur * Hrh);
    const double krx = -(iur * Hux + irr * Hrx);
    const double kry = -(iur * Huy + irr * Hry);
    const double krh = -(iur * Huh + irr * Hrh);
    const double kuu = iuu * fu;
    const double kur = iur * fr;
    const double kru = iur * fu;
    const double krr = irr * fr;
    const double ku = -(iuu * gu + iur * gr);
    const double kr = -(iur * gu + irr * gr);
    f.forward = {ku, kr};
    f.gain[0] = {kux, kuy, kuh, kuu, kur};
    f.gain[1] = {krx, kry, krh, kru, krr};

    v.gu = m.gradient_before[0][k] - fu * ku;
    v.gr = m.gradient_before[1][k] - fr * kr;
    v.uu = su - fu * kuu;
    v.ur = -fu * kur;
    v.rr = sr - fr * krr;
    v.xu = -fu * kux;
    v.yu = -fu * kuy;
    v.hu = -fu * kuh;
    v.xr = -fr * krx;
    v.yr = -fr * kry;
    v.hr = -fr * krh;
    v.gx += Hux * ku + Hrx * kr;
    v.gy += Huy * ku + Hry * kr;
    v.gh = gh + Huh * ku + Hrh * kr;
    v.xx = Hxx + Hux * kux + Hrx * krx;
    v.xy = Hxy + Hux * kuy + Hrx * kry;
    v.yy = Hyy + Huy * kuy + Hry * kry;
    v.xh = Hxh + Hux * kuh + Hrx * krh;
    v.yh = Hyh + Huy * kuh + Hry * krh;
    v.hh = Hhh + Huh * kuh + Hrh * krh;
  }
  return true;
}

void riccati_forward(Workspace& w) noexcept {
  StageModel& m = w.model;
  const double dt = w.problem->dt;
  double x = 0.0;
  double y = 0.0;
  double h = 0.0;
  double u = 0.0;
  double r = 0.0;
  m.step_x[0] = m.step_y[0] = m.step_heading[0] = 0.0;
  for (std::size_t k = 0; k < w.horizon; ++k) {
    const Feedback& f = w.feedback[k];
    const auto command = [&](std::size_t j) {
      const std::array<double, 5>& g = f.gain[j];
      return f.forward[j] + g[0] * x + g[1] * y + g[2] * h + g[3] * u + g[4] * r;
    };
    const double du = command(0);
    const double dr = command(1);
    const double turn = h + w.half_turn * dr;
    x += m.motion_x[k] * turn + dt * w.now->cosine[k] * du;
    y += m.motion_y[k] * turn + dt * w.now->sine[k] * du;
    h += dt * dr;
    u = du;
    r = dr;
    m.step[0][k] = du;
    m.step[1][k] = dr;
    m.step_x[k + 1] = x;
    m.step_y[k + 1] = y;
    m.step_heading[k + 1] = h;
  }
}

}  // namespace fairway::interior_point
