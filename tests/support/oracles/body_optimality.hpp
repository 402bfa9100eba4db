// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Core>

#include "fairway/mpc/body/body_evaluation.hpp"
#include "fairway/mpc/body/input_bounds.hpp"
#include "support/oracles/first_order_oracle.hpp"

namespace fairway::test {

/// Measures how far a feasible solution of a body problem is from the first-order optimality
/// conditions, from its inputs alone, as `first_order_optimality` does for a disc.
template <typename Motion>
class BodyOptimality {
 public:
  BodyOptimality(const BodyProblem<Motion>& problem,
                 const BodySolution<Motion>& solution,
                 double active)
      : problem_(problem),
        n_(static_cast<std::size_t>(problem.horizon)),
        active_(active),
        inputs_(solution.inputs.begin(), solution.inputs.begin() + problem.horizon),
        poses_(n_ + 1) {
    rollout<Motion>(problem, inputs_, poses_);
    std::vector<Eigen::Vector3d> by_pose(n_ + 1, Eigen::Vector3d::Zero());
    std::vector<typename Motion::Input> by_input(n_);
    for (std::size_t k = 0; k < n_; ++k) {
      const StepTarget& target = problem.targets[k + 1];
      by_pose[k + 1] << poses_[k + 1].position - target.position,
          poses_[k + 1].heading - target.heading;
      by_pose[k + 1] = 2.0 * by_pose[k + 1].cwiseProduct(target.weight);
      by_input[k] = cost_gradient_by_input<Motion>(problem, inputs_, static_cast<int>(k));
    }
    add_pullback<Motion>(problem, inputs_, poses_, by_pose, by_input);
    rest_ = flat(by_input);
    add_soft();
    add_bounds();
  }

  /// The gradient of the Lagrangian at the best multipliers >= 0, relative to the gradients that
  /// must cancel, or the greatest product of a multiplier and a distance if that is greater.
  double residual() {
    Eigen::MatrixXd A(rest_.size(), static_cast<Eigen::Index>(columns_.size()));
    for (std::size_t i = 0; i < columns_.size(); ++i)
      A.col(static_cast<Eigen::Index>(i)) = columns_[i];
    const Eigen::VectorXd multipliers = non_negative_least_squares(A, rest_);
    double worst = (rest_ - A * multipliers).norm() / (1.0 + rest_.norm());
    for (std::size_t i = 0; i < columns_.size(); ++i)
      worst = std::max(worst, multipliers[static_cast<Eigen::Index>(i)] * std::abs(distances_[i]));
    return worst;
  }

 private:
  static constexpr Eigen::Index kInputs = Motion::kInputs;

  static Eigen::VectorXd flat(const std::vector<typename Motion::Input>& inputs) {
    Eigen::VectorXd all(kInputs * static_cast<Eigen::Index>(inputs.size()));
    for (std::size_t k = 0; k < inputs.size(); ++k)
      all.segment<kInputs>(kInputs * static_cast<Eigen::Index>(k)) = inputs[k];
    return all;
  }

  void add_soft() {
    visit_soft_constraints(problem_, [&](const BodyConstraintName& name) {
      const BodyConstraint c = soft_constraint<Motion>(problem_, poses_, name);
      if (c.margin > active_) return;
      const auto k = static_cast<std::size_t>(name.step);
      std::vector<Eigen::Vector3d> by_pose(n_ + 1, Eigen::Vector3d::Zero());
      by_pose[k] += c.gradient;
      by_pose[k - 1] += c.gradient_before;
      std::vector<typename Motion::Input> by_input(n_, Motion::Input::Zero());
      add_pullback<Motion>(problem_, inputs_, poses_, by_pose, by_input);
      columns_.push_back(flat(by_input));
      distances_.push_back(c.margin);
    });
  }

  // Adds normal . input of step k, minus that of the step before for changes, if `space` is small.
  void add_bound(std::size_t k, const typename Motion::Input& normal, double space, bool change) {
    if (space > active_) return;
    Eigen::VectorXd column = Eigen::VectorXd::Zero(rest_.size());
    const Eigen::Index at = kInputs * static_cast<Eigen::Index>(k);
    column.segment<kInputs>(at) = normal;
    if (change && k > 0) column.segment<kInputs>(at - kInputs) = -normal;
    columns_.push_back(column);
    distances_.push_back(space);
  }

  void add_bounds() {
    InputBounds<Motion> bounds;
    find_input_bounds(problem_, bounds);
    for (std::size_t k = 0; k < n_; ++k) {
      const typename Motion::Input& before = k == 0 ? problem_.previous_input : inputs_[k - 1];
      for (int j = 0; j < Motion::kInputs; ++j) {
        const typename Motion::Input axis = Motion::Input::Unit(j);
        const double change = inputs_[k][j] - before[j];
        add_bound(k, axis, inputs_[k][j] - bounds.low[k][j], false);
        add_bound(k, -axis, bounds.high[k][j] - inputs_[k][j], false);
        add_bound(k, axis, problem_.max_change[j] + change, true);
        add_bound(k, -axis, problem_.max_change[j] - change, true);
      }
      for (int i = 0; i < problem_.num_input_limits; ++i) {
        const auto& normal = problem_.input_limits[static_cast<std::size_t>(i)].normal;
        const double value = normal.dot(inputs_[k]);
        const double bound = bounds.limits[k][static_cast<std::size_t>(i)];
        add_bound(k, -normal, bound - value, false);
        add_bound(k, normal, bound + value, false);
      }
    }
  }

  const BodyProblem<Motion>& problem_;
  std::size_t n_;
  double active_;
  std::vector<typename Motion::Input> inputs_;
  std::vector<Pose2> poses_;
  Eigen::VectorXd rest_;
  std::vector<Eigen::VectorXd> columns_;
  std::vector<double> distances_;  // to the bounds
};

}  // namespace fairway::test
