// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Dense>

#include "fairway/mpc/derivatives.hpp"
#include "fairway/mpc/evaluation.hpp"

namespace fairway::test {

/// The x >= 0 that minimises |A x - b|: Lawson and Hanson's active-set method. Slow and simple.
inline Eigen::VectorXd non_negative_least_squares(const Eigen::MatrixXd& A,
                                                  const Eigen::VectorXd& b) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(A.cols());
  std::vector<bool> positive(static_cast<std::size_t>(A.cols()), false);
  const auto solve_positive = [&] {
    std::vector<Eigen::Index> columns;
    for (Eigen::Index i = 0; i < A.cols(); ++i) {
      if (positive[static_cast<std::size_t>(i)]) columns.push_back(i);
    }
    Eigen::VectorXd full = Eigen::VectorXd::Zero(A.cols());
    if (columns.empty()) return full;
    const Eigen::VectorXd part = A(Eigen::all, columns).completeOrthogonalDecomposition().solve(b);
    full(columns) = part;
    return full;
  };
  for (int round = 0; round < 10 * static_cast<int>(A.cols()) + 10; ++round) {
    const Eigen::VectorXd descent = A.transpose() * (b - A * x);
    Eigen::Index best = -1;
    for (Eigen::Index i = 0; i < A.cols(); ++i) {
      if (!positive[static_cast<std::size_t>(i)] && descent[i] > 1e-10 &&
          (best < 0 || descent[i] > descent[best]))
        best = i;
    }
    if (best < 0) break;
    positive[static_cast<std::size_t>(best)] = true;
    for (Eigen::VectorXd z = solve_positive();; z = solve_positive()) {
      double step = 1.0;
      for (Eigen::Index i = 0; i < A.cols(); ++i) {
        if (positive[static_cast<std::size_t>(i)] && z[i] <= 0.0)
          step = std::min(step, x[i] / (x[i] - z[i]));
      }
      x += step * (z - x);
      if (step >= 1.0) break;
      for (Eigen::Index i = 0; i < A.cols(); ++i) {
        if (x[i] <= 1e-14) {
          x[i] = 0.0;
          positive[static_cast<std::size_t>(i)] = false;
        }
      }
    }
  }
  return x;
}

/// The residuals of the first-order conditions, in the space of the commands.
struct Optimality {
  double residual =
      0.0;  ///< |gradient of cost + penalty - sum of multiplier * constraint gradient|
  double complementarity = 0.0;  ///< largest multiplier * distance to the bound [cost]
  double scale = 1.0;            ///< norm of the gradients that must cancel
};

/// The residuals at the given commands. Finds the best multipliers >= 0 for the constraints near
/// their bounds (within `near`), and counts violated soft constraints with the full penalty.
inline Optimality first_order_optimality(const ControlProblem& problem,
                                         const std::array<Twist2, kMaxHorizon>& commands,
                                         double near = 1e-3) {
  std::array<Pose2, kMaxHorizon + 1> poses;
  rollout(problem, commands, poses);
  const Eigen::Index size = 2 * problem.horizon;
  std::vector<Eigen::VectorXd> rows;  // gradients of the constraints "value >= 0" near their bounds
  std::vector<double> values;
  const auto flat = [&](const std::array<Eigen::Vector2d, kMaxHorizon>& by_command) {
    Eigen::VectorXd v(size);
    for (int k = 0; k < problem.horizon; ++k)
      v.segment<2>(2 * k) = by_command[static_cast<std::size_t>(k)];
    return v;
  };

  std::array<Eigen::Vector2d, kMaxHorizon> by_command;
  cost_gradient(problem, commands, poses, by_command);
  Eigen::VectorXd gradient = flat(by_command);
  double scale = gradient.norm();

  visit_soft_constraints(problem, [&](const ConstraintName& name) {
    const SoftConstraint row = soft_constraint(problem, poses, name);
    if (row.margin > near) return;
    std::array<Eigen::Vector3d, kMaxHorizon + 1> by_pose;
    by_pose.fill(Eigen::Vector3d::Zero());
    const auto k = static_cast<std::size_t>(name.step);
    by_pose[k].head<2>() = row.gradient;
    by_pose[k - 1].head<2>() = row.gradient_before;
    by_command.fill(Eigen::Vector2d::Zero());
    add_pullback(problem, commands, poses, by_pose, by_command);
    if (row.margin < -kFeasibilityTolerance) {
      gradient -= problem.violation_weight * flat(by_command);
      scale += problem.violation_weight * flat(by_command).norm();
    } else {
      rows.push_back(flat(by_command));
      values.push_back(std::abs(row.margin));
    }
  });

  // sign * (command i - previous command) + ... >= 0 with distance `value` to the bound.
  const auto add_bound = [&](Eigen::Index i, double sign, bool change, double value) {
    if (value > near) return;
    Eigen::VectorXd row = Eigen::VectorXd::Zero(size);
    row[i] = sign;
    if (change && i >= 2) row[i - 2] = -sign;
    rows.push_back(row);
    values.push_back(std::abs(value));
  };
  for (int k = 0; k < problem.horizon; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const bool stopped = problem.stop_at_end && k == problem.horizon - 1;
    const Twist2& before = k > 0 ? commands[at - 1] : problem.previous_command;
    for (int axis = 0; axis < 2; ++axis) {
      const auto of = [axis](const Twist2& t) { return axis == 0 ? t.linear : t.angular; };
      const double value = of(commands[at]);
      const Eigen::Index i = 2 * k + axis;
      const double low = stopped ? 0.0 : of(problem.command_min);
      const double high = stopped ? 0.0 : of(problem.command_max);
      add_bound(i, 1.0, false, value - low);
      add_bound(i, -1.0, false, high - value);
      add_bound(i, 1.0, true, of(problem.max_change) + value - of(before));
      add_bound(i, -1.0, true, of(problem.max_change) - value + of(before));
    }
  }

  Eigen::MatrixXd A(size, static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    A.col(static_cast<Eigen::Index>(i)) = rows[i];
  const Eigen::VectorXd multipliers = non_negative_least_squares(A, gradient);
  Optimality result{.residual = (gradient - A * multipliers).norm(), .scale = 1.0 + scale};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    result.complementarity =
        std::max(result.complementarity, multipliers[static_cast<Eigen::Index>(i)] * values[i]);
  }
  return result;
}

}  // namespace fairway::test
