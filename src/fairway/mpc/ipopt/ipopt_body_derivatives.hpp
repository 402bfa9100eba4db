// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/ipopt/ipopt_body_problem.hpp"

// The first and second derivatives of IpoptBodyProblem.

namespace fairway {

template <typename Motion>
template <typename Sink>
void IpoptBodyProblem<Motion>::visit_jacobian(Sink&& sink) const {
  for (int k = 0; k < horizon(); ++k) {
    const auto d = step_derivatives<Motion>(*problem_, poses_[step_index(k)],
                                            inputs_[step_index(k)], Eigen::Vector3d::Zero());
    for (int i = 0; i < 3; ++i) {
      sink(3 * k + i, pose(k + 1) + i, 1.0);
      for (int j = 0; k > 0 && j < 3; ++j)
        sink(3 * k + i, pose(k) + j, -d.by_pose(i, j));
      for (int j = 0; j < kInputs; ++j)
        sink(3 * k + i, input(k) + j, -d.by_input(i, j));
    }
    for (int j = 0; k > 0 && j < kInputs; ++j) {
      sink(change_row(k) + j, input(k) + j, 1.0);
      sink(change_row(k) + j, input(k - 1) + j, -1.0);
    }
    for (int i = 0; i < problem_->num_input_limits; ++i) {
      for (int j = 0; j < kInputs; ++j)
        sink(limit_row(k) + i, input(k) + j, problem_->input_limits[step_index(i)].normal[j]);
    }
  }
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const BodyConstraint c = constraint(i);
    const int k = names_[i].step;
    for (int j = 0; j < 3; ++j) {
      sink(soft_row(i), pose(k) + j, c.gradient[j]);
      if (names_[i].kind == ConstraintKind::Barrier && k > 1)
        sink(soft_row(i), pose(k - 1) + j, c.gradient_before[j]);
    }
    if (soft_) sink(soft_row(i), slack(i), 1.0);
  }
}

template <typename Motion>
template <typename Sink>
void IpoptBodyProblem<Motion>::visit_hessian(Number factor,
                                             const Number* lambda,
                                             Sink&& sink) const {
  for (int k = 0; k < horizon(); ++k) {
    const int changes =
        (k > 0 || problem_->penalise_first_change ? 1 : 0) + (k + 1 < horizon() ? 1 : 0);
    const Input own = 2.0 * problem_->input_weight + 2.0 * changes * problem_->change_weight;
    for (int j = 0; j < kInputs; ++j) {
      sink(input(k) + j, input(k) + j, factor * own[j]);
      if (k > 0) sink(input(k) + j, input(k - 1) + j, factor * -2.0 * problem_->change_weight[j]);
    }
    const Eigen::Vector3d weight = 2.0 * problem_->targets[step_index(k + 1)].weight;
    for (int j = 0; j < 3; ++j)
      sink(pose(k + 1) + j, pose(k + 1) + j, factor * weight[j]);
    const Eigen::Vector3d multiplier(lambda[3 * k], lambda[3 * k + 1], lambda[3 * k + 2]);
    const auto d = step_derivatives<Motion>(*problem_, poses_[step_index(k)],
                                            inputs_[step_index(k)], -multiplier);
    const auto variable = [&](int i) { return i == 0 ? pose(k) + 2 : input(k) + i - 1; };
    for (int r = k > 0 ? 0 : 1; r <= kInputs; ++r) {
      for (int c = k > 0 ? 0 : 1; c <= r; ++c)
        sink(variable(r), variable(c), d.hessian(r, c));
    }
  }
  visit_constraint_hessian(lambda, sink);
}

template <typename Motion>
template <typename Sink>
void IpoptBodyProblem<Motion>::visit_constraint_hessian(const Number* lambda, Sink&& sink) const {
  const auto visit = [&](int k, Number factor, const Eigen::Matrix3d& m) {
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c <= r; ++c)
        sink(pose(k) + r, pose(k) + c, factor * m(r, c));
    }
  };
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const BodyConstraint c = constraint(i);
    const Number y = lambda[soft_row(i)];
    visit(names_[i].step, y, c.curvature);
    if (names_[i].kind == ConstraintKind::Barrier && names_[i].step > 1)
      visit(names_[i].step - 1, y, c.curvature_before);
  }
}

}  // namespace fairway
