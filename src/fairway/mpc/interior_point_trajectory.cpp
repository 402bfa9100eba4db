// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/interior_point_trajectory.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/mpc/interior_point_hard_rows.hpp"
#include "fairway/mpc/interior_point_reductions.hpp"

namespace fairway::interior_point {
namespace {

// Turns up to this are small enough for the series below to be exact to rounding [rad].
constexpr double kSmallTurn = 0.5;

constexpr double square(double a) noexcept { return a * a; }

// Taylor series; the first term left out is below 1e-17 for |a| <= kSmallTurn.
inline double small_sine(double a) noexcept {
  const double q = a * a;
  return a * (1.0 +
              q * (-1.0 / 6 +
                   q * (1.0 / 120 +
                        q * (-1.0 / 5040 + q * (1.0 / 362880 + q * (-1.0 / 39916800 +
                                                                    q * (1.0 / 6227020800.0)))))));
}
inline double small_cosine(double a) noexcept {
  const double q = a * a;
  return 1.0 +
         q * (-1.0 / 2 +
              q * (1.0 / 24 +
                   q * (-1.0 / 720 + q * (1.0 / 40320 + q * (-1.0 / 3628800 +
                                                             q * (1.0 / 479001600 +
                                                                  q * (-1.0 / 87178291200.0)))))));
}

// Cosine and sine of the headings of motion. From one step to the next the heading turns little, so
// the direction is turned by a short series instead of being computed anew.
void find_directions(const Workspace& w, Point& point) noexcept {
  const std::size_t n = w.horizon;
  CommandArray turn;  // phi_k - phi_{k-1}, with phi_{-1} the start heading
  const double dt = w.problem->dt;
  const double half = w.half_turn;
  turn[0] = half * point.angular[0];
  for (std::size_t k = 1; k < n; ++k)
    turn[k] = (dt - half) * point.angular[k - 1] + half * point.angular[k];
  double greatest = 0.0;
  for (std::size_t k = 0; k < n; ++k)
    greatest = std::max(greatest, std::abs(turn[k]));
  if (!(greatest <= kSmallTurn)) {
    for (std::size_t k = 0; k < n; ++k) {
      const double phi = point.heading[k] + half * point.angular[k];
      point.cosine[k] = std::cos(phi);
      point.sine[k] = std::sin(phi);
    }
    return;
  }
  CommandArray cosine;
  CommandArray sine;
  for (std::size_t k = 0; k < n; ++k) {
    cosine[k] = small_cosine(turn[k]);
    sine[k] = small_sine(turn[k]);
  }
  double c = w.start_cosine;
  double s = w.start_sine;
  for (std::size_t k = 0; k < n; ++k) {
    const double turned = c * cosine[k] - s * sine[k];
    s = s * cosine[k] + c * sine[k];
    c = turned;
    point.cosine[k] = c;
    point.sine[k] = s;
  }
}

double pose_cost(const Workspace& w, const Point& p) noexcept {
  PoseArray cost;
  for (std::size_t k = 1; k <= w.horizon; ++k) {
    cost[k] = w.weight_x[k] * square(p.x[k] - w.target_x[k]) +
              w.weight_y[k] * square(p.y[k] - w.target_y[k]) +
              w.weight_heading[k] * square(p.heading[k] - w.target_heading[k]);
  }
  return sum_of(cost.data() + 1, w.horizon);
}

double command_cost(const CommandArray& command,
                    std::size_t n,
                    double weight,
                    double change_weight) noexcept {
  CommandArray cost;
  cost[0] = weight * square(command[0]);
  for (std::size_t k = 1; k < n; ++k)
    cost[k] = weight * square(command[k]) + change_weight * square(command[k] - command[k - 1]);
  return sum_of(cost.data(), n);
}

// Gradient and Hessian by command coordinate j; `dual` is the gradient of the Lagrangian.
void linearise_commands(Workspace& w, std::size_t j, CommandArray& dual) noexcept {
  const ControlProblem& problem = *w.problem;
  const HardRows& hard = w.hard;
  StageModel& m = w.model;
  const std::size_t n = w.horizon;
  const CommandArray& command = j == 0 ? w.now->linear : w.now->angular;
  const auto index = static_cast<Eigen::Index>(j);
  const double weight = 2.0 * problem.command_weight[index];
  const double change_weight = 2.0 * problem.change_weight[index];
  const double previous =
      j == 0 ? problem.previous_command.linear : problem.previous_command.angular;
  const double first_weight = problem.penalise_first_change ? change_weight : 0.0;

  m.change[j][0] = first_weight;
  m.gradient_before[j][0] = 0.0;
  m.gradient[j][0] = first_weight * (command[0] - previous);
  for (std::size_t k = 1; k < n; ++k) {
    m.change[j][k] = change_weight;
    m.gradient[j][k] = change_weight * (command[k] - command[k - 1]);
    m.gradient_before[j][k] = -m.gradient[j][k];
  }
  for (std::size_t k = 0; k < n; ++k) {
    m.hessian[j][k] = weight + hard.curvature[j * n + k];
    m.gradient[j][k] += weight * command[k];
    dual[k] = m.gradient[j][k] + dual_gradient(hard, j * n + k);
  }
  if (hard.count > 2 * n) {
    for (std::size_t k = 1; k < n; ++k) {
      m.change[j][k] += hard.curvature[(2 + j) * n + k];
      dual[k] += dual_gradient(hard, (2 + j) * n + k);
      dual[k - 1] -= dual_gradient(hard, (2 + j) * n + k);
    }
  }
  for (std::size_t k = 1; k < n; ++k)
    dual[k - 1] += m.gradient_before[j][k];
}

void linearise_poses(Workspace& w) noexcept {
  const Point& p = *w.now;
  StageModel& m = w.model;
  for (std::size_t k = 1; k <= w.horizon; ++k) {
    m.xx[k] += 2.0 * w.weight_x[k];
    m.yy[k] += 2.0 * w.weight_y[k];
    m.gradient_x[k] = 2.0 * w.weight_x[k] * (p.x[k] - w.target_x[k]);
    m.gradient_y[k] = 2.0 * w.weight_y[k] * (p.y[k] - w.target_y[k]);
    m.dual_gradient_x[k] += m.gradient_x[k];
    m.dual_gradient_y[k] += m.gradient_y[k];
    m.gradient_heading[k] = 2.0 * w.weight_heading[k] * (p.heading[k] - w.target_heading[k]);
  }
}

}  // namespace

void roll_out(const Workspace& w, Point& point) noexcept {
  const ControlProblem& problem = *w.problem;
  const double dt = problem.dt;
  point.heading[0] = problem.start.heading - w.full_turns;
  for (std::size_t k = 0; k < w.horizon; ++k)
    point.heading[k + 1] = point.heading[k] + dt * point.angular[k];
  find_directions(w, point);
  point.x[0] = 0.0;
  point.y[0] = 0.0;
  for (std::size_t k = 0; k < w.horizon; ++k) {
    const double length = dt * point.linear[k];
    point.x[k + 1] = point.x[k] + length * point.cosine[k];
    point.y[k + 1] = point.y[k] + length * point.sine[k];
  }
  const Twist2& previous = problem.previous_command;
  const double first = problem.penalise_first_change ? 1.0 : 0.0;
  const Eigen::Vector2d& weight = problem.command_weight;
  const Eigen::Vector2d& change = problem.change_weight;
  point.cost = problem.cost_offset + pose_cost(w, point) +
               command_cost(point.linear, w.horizon, weight[0], change[0]) +
               command_cost(point.angular, w.horizon, weight[1], change[1]) +
               first * (change[0] * square(point.linear[0] - previous.linear) +
                        change[1] * square(point.angular[0] - previous.angular));
}

void linearise_trajectory(Workspace& w) noexcept {
  const Point& p = *w.now;
  StageModel& m = w.model;
  const double dt = w.problem->dt;
  linearise_poses(w);
  std::array<CommandArray, 2> dual;
  linearise_commands(w, 0, dual[0]);
  linearise_commands(w, 1, dual[1]);

  for (std::size_t k = 0; k < w.horizon; ++k) {
    m.motion_x[k] = -dt * p.linear[k] * p.sine[k];
    m.motion_y[k] = dt * p.linear[k] * p.cosine[k];
  }
  // The costate, backwards, Eq. (S6): derivative of all that is to come by the pose.
  double lx = 0.0;
  double ly = 0.0;
  double lh = 0.0;
  for (std::size_t k = w.horizon; k-- > 0;) {
    lx += m.dual_gradient_x[k + 1];
    ly += m.dual_gradient_y[k + 1];
    lh += m.gradient_heading[k + 1];
    const double along = dt * (lx * p.cosine[k] + ly * p.sine[k]);
    const double across = dt * (ly * p.cosine[k] - lx * p.sine[k]);
    const double by_phi = p.linear[k] * across;
    m.phi_phi[k] = -p.linear[k] * along;
    m.linear_phi[k] = across;
    dual[0][k] = w.limits[0].fixed[k] ? 0.0 : std::abs(dual[0][k] + along);
    dual[1][k] = w.limits[1].fixed[k] ? 0.0 : std::abs(dual[1][k] + w.half_turn * by_phi + dt * lh);
    lh += by_phi;
  }
  m.stationarity =
      std::max(max_of(dual[0].data(), w.horizon, 0.0), max_of(dual[1].data(), w.horizon, 0.0));
}

void aim_hard_rows(Workspace& w, double mu) noexcept {
  StageModel& m = w.model;
  const std::size_t n = w.horizon;
  for (std::size_t j = 0; j < 2; ++j) {
    for (std::size_t k = 0; k < n; ++k)
      m.gradient[j][k] += barrier_gradient(w.hard, j * n + k, mu);
    if (w.hard.count == 2 * n) continue;
    for (std::size_t k = 1; k < n; ++k) {
      const double g = barrier_gradient(w.hard, (2 + j) * n + k, mu);
      m.gradient[j][k] += g;
      m.gradient_before[j][k] -= g;
    }
  }
}

double slope(const Workspace& w) noexcept {
  const StageModel& m = w.model;
  CommandArray part;
  for (std::size_t k = 0; k < w.horizon; ++k) {
    part[k] = m.gradient[0][k] * m.step[0][k] + m.gradient[1][k] * m.step[1][k] +
              m.gradient_x[k + 1] * m.step_x[k + 1] + m.gradient_y[k + 1] * m.step_y[k + 1] +
              m.gradient_heading[k + 1] * m.step_heading[k + 1];
  }
  for (std::size_t k = 1; k < w.horizon; ++k) {
    part[k] +=
        m.gradient_before[0][k] * m.step[0][k - 1] + m.gradient_before[1][k] * m.step[1][k - 1];
  }
  return sum_of(part.data(), w.horizon);
}

}  // namespace fairway::interior_point
