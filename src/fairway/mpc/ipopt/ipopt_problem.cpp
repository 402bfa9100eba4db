// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/ipopt/ipopt_problem.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/mpc/evaluation.hpp"
#include "fairway/mpc/step_index.hpp"

namespace fairway {
namespace {

using Ipopt::Index;
using Ipopt::Number;

constexpr Number kUnbounded = 2e19;         // IPOPT treats values beyond 1e19 as no bound
constexpr double kActiveMultiplier = 1e-5;  // smaller multipliers do not limit the solution

double component(const Twist2& twist, int axis) noexcept {
  return axis == 0 ? twist.linear : twist.angular;
}

}  // namespace

void IpoptProblem::set(const ControlProblem& problem,
                       const std::array<Twist2, kMaxHorizon>& start) {
  problem_ = &problem;
  commands_ = start;
  rollout(problem, commands_, poses_);
  limiting_ = {};
  soft_constraints_.clear();
  visit_soft_constraints(problem,
                         [&](const ConstraintName& name) { soft_constraints_.push_back(name); });
  change_bounds_.clear();
  for (int k = 1; k < problem.horizon; ++k) {
    for (int axis = 0; axis < 2; ++axis) {
      if (std::isfinite(component(problem.max_change, axis))) change_bounds_.push_back({k, axis});
    }
  }
}

Index IpoptProblem::num_slacks() const {
  return mode_ == IpoptConstraints::Soft ? static_cast<Index>(soft_constraints_.size()) : 0;
}

Index IpoptProblem::slack_index(std::size_t constraint) const {
  return 5 * problem_->horizon + static_cast<Index>(constraint);
}

Index IpoptProblem::soft_constraint_index(std::size_t constraint) const {
  return 3 * problem_->horizon + static_cast<Index>(change_bounds_.size() + constraint);
}

Index IpoptProblem::num_constraints() const {
  return soft_constraint_index(soft_constraints_.size());
}

void IpoptProblem::read(const Number* x) {
  for (int k = 0; k < problem_->horizon; ++k) {
    const Number* command = x + command_index(k);
    commands_[step_index(k)] = {.linear = command[0], .angular = command[1]};
    const Number* pose = x + pose_index(k + 1);
    poses_[step_index(k + 1)] = {.position = {pose[0], pose[1]}, .heading = pose[2]};
  }
}

bool IpoptProblem::get_nlp_info(
    Index& n, Index& m, Index& nnz_jac_g, Index& nnz_h_lag, IndexStyleEnum& index_style) {
  n = 5 * problem_->horizon + num_slacks();
  m = num_constraints();
  nnz_jac_g = num_jacobian_entries();
  nnz_h_lag = num_hessian_entries();
  index_style = C_STYLE;
  return true;
}

bool IpoptProblem::get_bounds_info(
    Index n, Number* x_l, Number* x_u, Index m, Number* g_l, Number* g_u) {
  std::fill(x_l, x_l + n, -kUnbounded);
  std::fill(x_u, x_u + n, kUnbounded);
  const ControlProblem& problem = *problem_;
  for (int k = 0; k < problem.horizon; ++k) {
    const bool stopped = problem.stop_at_end && k == problem.horizon - 1;
    for (int axis = 0; axis < 2; ++axis) {
      const Index i = command_index(k) + axis;
      x_l[i] = stopped ? 0.0 : component(problem.command_min, axis);
      x_u[i] = stopped ? 0.0 : component(problem.command_max, axis);
      if (k > 0) continue;
      const double before = component(problem.previous_command, axis);
      const double change = component(problem.max_change, axis);
      // Where rounding makes range and change disagree, the range takes precedence (see validate).
      x_l[i] = std::min(std::max(x_l[i], before - change), x_u[i]);
      x_u[i] = std::max(std::min(x_u[i], before + change), x_l[i]);
    }
  }
  std::fill(x_l + slack_index(0), x_l + n, 0.0);

  std::fill(g_l, g_l + m, 0.0);
  std::fill(g_u, g_u + m, 0.0);
  Index row = 3 * problem.horizon;
  for (const ChangeBound& change : change_bounds_) {
    g_u[row] = component(problem.max_change, change.axis);
    g_l[row] = -g_u[row];
    ++row;
  }
  std::fill(g_u + row, g_u + m, kUnbounded);
  return true;
}

bool IpoptProblem::get_starting_point(Index n,
                                      bool init_x,
                                      Number* x,
                                      bool init_z,
                                      Number* /*z_L*/,
                                      Number* /*z_U*/,
                                      Index /*m*/,
                                      bool init_lambda,
                                      Number* /*lambda*/) {
  if (!init_x || init_z || init_lambda) return false;
  for (int k = 0; k < problem_->horizon; ++k) {
    Number* command = x + command_index(k);
    command[0] = commands_[step_index(k)].linear;
    command[1] = commands_[step_index(k)].angular;
    const Pose2& next = poses_[step_index(k + 1)];
    Number* pose = x + pose_index(k + 1);
    pose[0] = next.position.x();
    pose[1] = next.position.y();
    pose[2] = next.heading;
  }
  for (Index i = slack_index(0); i < n; ++i) {
    const ConstraintName& name = soft_constraints_[step_index(i - slack_index(0))];
    x[i] = std::max(0.0, -soft_constraint(*problem_, poses_, name).margin);
  }
  return true;
}

bool IpoptProblem::eval_f(Index n, const Number* x, bool /*new_x*/, Number& obj_value) {
  read(x);
  obj_value = cost(*problem_, commands_, poses_);
  for (Index i = slack_index(0); i < n; ++i)
    obj_value += problem_->violation_weight * x[i];
  return true;
}

bool IpoptProblem::eval_g(Index /*n*/, const Number* x, bool /*new_x*/, Index /*m*/, Number* g) {
  read(x);
  const ControlProblem& problem = *problem_;
  for (int k = 0; k < problem.horizon; ++k) {
    // Eq. (15b): command k leads from pose k to pose k + 1.
    const Pose2 next =
        step(poses_[step_index(k)], commands_[step_index(k)], problem.dt, problem.integration);
    const Pose2& pose = poses_[step_index(k + 1)];
    g[3 * k] = pose.position.x() - next.position.x();
    g[3 * k + 1] = pose.position.y() - next.position.y();
    g[3 * k + 2] = pose.heading - next.heading;
  }
  Number* change = g + 3 * problem.horizon;
  for (const ChangeBound& bound : change_bounds_) {
    *change++ = component(commands_[step_index(bound.step)], bound.axis) -
                component(commands_[step_index(bound.step - 1)], bound.axis);
  }
  for (std::size_t i = 0; i < soft_constraints_.size(); ++i) {
    g[soft_constraint_index(i)] = soft_constraint(problem, poses_, soft_constraints_[i]).margin +
                                  (num_slacks() > 0 ? x[slack_index(i)] : 0.0);
  }
  return true;
}

void IpoptProblem::finalize_solution(Ipopt::SolverReturn /*status*/,
                                     Index /*n*/,
                                     const Number* x,
                                     const Number* z_L,
                                     const Number* z_U,
                                     Index /*m*/,
                                     const Number* /*g*/,
                                     const Number* lambda,
                                     Number /*obj_value*/,
                                     const Ipopt::IpoptData* /*ip_data*/,
                                     Ipopt::IpoptCalculatedQuantities* /*ip_cq*/) {
  read(x);
  double greatest = kActiveMultiplier;
  const auto offer = [&](const ConstraintName& name, double multiplier) {
    if (!(std::abs(multiplier) > greatest)) return;
    greatest = std::abs(multiplier);
    limiting_ = name;
  };
  for (int k = 0; k < problem_->horizon; ++k) {
    for (int axis = 0; axis < 2; ++axis) {
      const Index i = command_index(k) + axis;
      const double multiplier = std::max(z_L[i], z_U[i]);
      const double value = component(commands_[step_index(k)], axis);
      const bool by_change =
          k == 0 && component(problem_->command_min, axis) < value - kFeasibilityTolerance &&
          component(problem_->command_max, axis) > value + kFeasibilityTolerance;
      const ConstraintKind speed =
          axis == 0 ? ConstraintKind::LinearSpeed : ConstraintKind::AngularSpeed;
      const ConstraintKind change =
          axis == 0 ? ConstraintKind::LinearChange : ConstraintKind::AngularChange;
      offer({by_change ? change : speed, k, axis}, multiplier);
    }
  }
  for (std::size_t i = 0; i < change_bounds_.size(); ++i) {
    const ConstraintKind kind =
        change_bounds_[i].axis == 0 ? ConstraintKind::LinearChange : ConstraintKind::AngularChange;
    offer({kind, change_bounds_[i].step, change_bounds_[i].axis},
          lambda[3 * problem_->horizon + static_cast<Index>(i)]);
  }
  for (std::size_t i = 0; i < soft_constraints_.size(); ++i)
    offer(soft_constraints_[i], lambda[soft_constraint_index(i)]);
}

}  // namespace fairway
