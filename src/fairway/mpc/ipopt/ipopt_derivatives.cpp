// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <vector>

#include "fairway/mpc/derivatives.hpp"
#include "fairway/mpc/evaluation.hpp"
#include "fairway/mpc/ipopt/ipopt_problem.hpp"
#include "fairway/mpc/step_index.hpp"

// The first and second derivatives of IpoptProblem.

namespace fairway {

using Ipopt::Index;
using Ipopt::Number;

template <typename Sink>
void IpoptProblem::visit_jacobian(Sink&& sink) const {
  const ControlProblem& problem = *problem_;
  for (int k = 0; k < problem.horizon; ++k) {
    const StepJacobian jacobian = step_jacobian(poses_[step_index(k)], commands_[step_index(k)],
                                                problem.dt, problem.integration);
    for (int i = 0; i < 3; ++i) {
      const Index row = 3 * k + i;
      sink(row, pose_index(k + 1) + i, 1.0);
      if (k > 0) {
        sink(row, pose_index(k) + i, -1.0);
        if (i < 2) sink(row, pose_index(k) + 2, -jacobian.by_pose(i, 2));
      }
      if (i < 2) sink(row, command_index(k), -jacobian.by_command(i, 0));
      sink(row, command_index(k) + 1, -jacobian.by_command(i, 1));
    }
  }
  Index change = 3 * problem.horizon;
  for (const ChangeBound& bound : change_bounds_) {
    sink(change, command_index(bound.step) + bound.axis, 1.0);
    sink(change, command_index(bound.step - 1) + bound.axis, -1.0);
    ++change;
  }
  for (std::size_t i = 0; i < soft_constraints_.size(); ++i) {
    const ConstraintName& name = soft_constraints_[i];
    const SoftConstraint constraint = soft_constraint(problem, poses_, name);
    for (int axis = 0; axis < 2; ++axis) {
      sink(soft_constraint_index(i), pose_index(name.step) + axis, constraint.gradient[axis]);
      if (name.kind == ConstraintKind::Barrier && name.step > 1)
        sink(soft_constraint_index(i), pose_index(name.step - 1) + axis,
             constraint.gradient_before[axis]);
    }
    if (num_slacks() > 0) sink(soft_constraint_index(i), slack_index(i), 1.0);
  }
}

// Visits the part of -lambda . next pose, lower triangle; pose 0 is not a variable.
template <typename Sink>
void IpoptProblem::visit_step_hessian(int k, const Number* lambda, Sink&& sink) const {
  const Eigen::Vector3d multiplier(lambda[3 * k], lambda[3 * k + 1], lambda[3 * k + 2]);
  const Eigen::Matrix3d hessian = -step_hessian(poses_[step_index(k)], commands_[step_index(k)],
                                                problem_->dt, problem_->integration, multiplier);
  const Index linear = command_index(k);
  const Index angular = linear + 1;
  sink(angular, linear, hessian(1, 2));
  sink(angular, angular, hessian(2, 2));
  if (k == 0) return;
  const Index heading = pose_index(k) + 2;  // before command k in the vector
  sink(heading, heading, hessian(0, 0));
  sink(linear, heading, hessian(0, 1));
  sink(angular, heading, hessian(0, 2));
}

// Visits the lower triangle of obj_factor * cost + lambda . constraints; IPOPT sums equal entries.
template <typename Sink>
void IpoptProblem::visit_hessian(Number obj_factor, const Number* lambda, Sink&& sink) const {
  const ControlProblem& problem = *problem_;
  for (int k = 0; k < problem.horizon; ++k) {
    const Eigen::Vector2d command = cost_hessian_by_command(problem, k);
    const Eigen::Vector3d pose = 2.0 * problem.targets[step_index(k + 1)].weight;
    for (int i = 0; i < 2; ++i) {
      sink(command_index(k) + i, command_index(k) + i, obj_factor * command[i]);
      if (k > 0) {
        sink(command_index(k) + i, command_index(k - 1) + i,
             obj_factor * -2.0 * problem.change_weight[i]);
      }
    }
    for (int i = 0; i < 3; ++i)
      sink(pose_index(k + 1) + i, pose_index(k + 1) + i, obj_factor * pose[i]);
    visit_step_hessian(k, lambda, sink);
  }
  for (std::size_t i = 0; i < soft_constraints_.size(); ++i) {
    const ConstraintName& name = soft_constraints_[i];
    if (name.kind != ConstraintKind::Barrier) continue;  // corridor constraints are linear
    const SoftConstraint constraint = soft_constraint(problem, poses_, name);
    const Number multiplier = lambda[soft_constraint_index(i)];
    for (int axis = 0; axis < 2; ++axis) {
      const Index here = pose_index(name.step) + axis;
      sink(here, here, multiplier * constraint.curvature);
      if (name.step == 1) continue;
      const Index before = pose_index(name.step - 1) + axis;
      sink(before, before, multiplier * constraint.curvature_before);
    }
  }
}

Index IpoptProblem::num_jacobian_entries() const {
  Index count = 0;
  visit_jacobian([&](Index, Index, Number) { ++count; });
  return count;
}

Index IpoptProblem::num_hessian_entries() const {
  const std::vector<Number> zeros(step_index(num_constraints()), 0.0);
  Index count = 0;
  visit_hessian(0.0, zeros.data(), [&](Index, Index, Number) { ++count; });
  return count;
}

bool IpoptProblem::eval_grad_f(Index n, const Number* x, bool /*new_x*/, Number* grad_f) {
  read(x);
  for (int k = 0; k < problem_->horizon; ++k) {
    Eigen::Map<Eigen::Vector2d>(grad_f + command_index(k)) =
        cost_gradient_by_command(*problem_, commands_, k);
    Eigen::Map<Eigen::Vector3d>(grad_f + pose_index(k + 1)) =
        cost_gradient_by_pose(*problem_, poses_[step_index(k + 1)], k + 1);
  }
  std::fill(grad_f + slack_index(0), grad_f + n, problem_->violation_weight);
  return true;
}

bool IpoptProblem::eval_jac_g(Index /*n*/,
                              const Number* x,
                              bool /*new_x*/,
                              Index /*m*/,
                              Index /*nele_jac*/,
                              Index* iRow,
                              Index* jCol,
                              Number* values) {
  if (values == nullptr) {
    visit_jacobian([&](Index row, Index column, Number) {
      *iRow++ = row;
      *jCol++ = column;
    });
    return true;
  }
  read(x);
  visit_jacobian([&](Index, Index, Number value) { *values++ = value; });
  return true;
}

bool IpoptProblem::eval_h(Index /*n*/,
                          const Number* x,
                          bool /*new_x*/,
                          Number obj_factor,
                          Index m,
                          const Number* lambda,
                          bool /*new_lambda*/,
                          Index /*nele_hess*/,
                          Index* iRow,
                          Index* jCol,
                          Number* values) {
  if (values == nullptr) {
    const std::vector<Number> zeros(step_index(m), 0.0);
    visit_hessian(0.0, zeros.data(), [&](Index row, Index column, Number) {
      *iRow++ = row;
      *jCol++ = column;
    });
    return true;
  }
  read(x);
  visit_hessian(obj_factor, lambda, [&](Index, Index, Number value) { *values++ = value; });
  return true;
}

}  // namespace fairway
