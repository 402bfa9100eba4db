// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
<<<<<<< HEAD
#include <cstddef>
#include <vector>

#include <Eigen/Dense>
=======
#include <limits>
#include <vector>

#include <Eigen/Core>
>>>>>>> solver

#include "fairway/mpc/derivatives.hpp"
#include "fairway/mpc/evaluation.hpp"

namespace fairway::test {

<<<<<<< HEAD
/// The x >= 0 that minimises |A x - b|: active sets after Lawson and Hanson. Slow and plain.
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

/// What a solution leaves of the first-order conditions, in the space of the commands.
struct Optimality {
  double residual = 0.0;  ///< |gradient of cost + penalty - sum of multiplier * row gradient|
  double complementarity = 0.0;  ///< greatest multiplier * distance to the bound [cost]
  double scale = 1.0;            ///< size of the gradient that has to cancel
};

/// Looks at the commands only: finds the best multipliers >= 0 for the rows near their bounds
/// (within `near`), counts violated elastic rows at the full penalty, and returns what is left.
inline Optimality first_order_optimality(const ControlProblem& problem,
                                         const std::array<Twist2, kMaxHorizon>& commands,
                                         double near = 1e-3) {
  std::array<Pose2, kMaxHorizon + 1> poses;
  rollout(problem, commands, poses);
  const Eigen::Index size = 2 * problem.horizon;
  std::vector<Eigen::VectorXd> rows;  // gradients of the rows "value >= 0" near their bounds
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

  visit_elastic_rows(problem, [&](const RowName& name) {
    const ElasticRow row = elastic_row(problem, poses, name);
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

  // sign * (command i - command before) + ... >= 0 with `value` left.
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
=======
/// How far a solution is from the first-order optimality conditions, by its commands alone: the
/// least norm of
///     grad J - sum y_i grad c_i - sum l_j grad g_j
/// over 0 <= y_i <= price for the elastic rows that are at their bound (y_i = price where violated,
/// 0 where there is room) and l_j >= 0 for the hard rows at their bound. Slow: bounded least
/// squares by coordinate descent.
class OptimalityOracle {
 public:
  OptimalityOracle(const ControlProblem& problem, const MpcSolution& solution, double active)
      : problem_(problem),
        n_(static_cast<std::size_t>(problem.horizon)),
        active_(active) {
    commands_ = {solution.commands.begin(), solution.commands.begin() + problem.horizon};
    poses_.resize(n_ + 1);
    rollout(problem, commands_, poses_);
    std::vector<Eigen::Vector2d> gradient(n_, Eigen::Vector2d::Zero());
    cost_gradient(problem, commands_, poses_, gradient);
    rest_ = flat(gradient);
    add_elastic_rows();
    add_hard_rows();
  }

  double residual(int sweeps = 50000) {
    std::vector<double> multiplier(columns_.size(), 0.0);
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      double moved = 0.0;
      for (std::size_t i = 0; i < columns_.size(); ++i) {
        const double norm = columns_[i].squaredNorm();
        if (norm < 1e-18) continue;
        const double wish = multiplier[i] + columns_[i].dot(rest_) / norm;
        const double value = std::clamp(wish, 0.0, most_[i]);
        rest_ -= (value - multiplier[i]) * columns_[i];
        moved = std::max(moved, std::abs(value - multiplier[i]) * std::sqrt(norm));
        multiplier[i] = value;
      }
      if (moved < 1e-9) break;
    }
    return rest_.cwiseAbs().maxCoeff();
  }

 private:
  static Eigen::VectorXd flat(const std::vector<Eigen::Vector2d>& pairs) {
    Eigen::VectorXd all(2 * static_cast<Eigen::Index>(pairs.size()));
    for (std::size_t k = 0; k < pairs.size(); ++k)
      all.segment<2>(2 * static_cast<Eigen::Index>(k)) = pairs[k];
    return all;
  }

  void add_elastic_rows() {
    visit_elastic_rows(problem_, [&](const RowName& name) {
      const ElasticRow row = elastic_row(problem_, poses_, name);
      if (row.margin > active_) return;
      const auto k = static_cast<std::size_t>(name.step);
      std::vector<Eigen::Vector3d> by_pose(n_ + 1, Eigen::Vector3d::Zero());
      by_pose[k].head<2>() += row.gradient;
      by_pose[k - 1].head<2>() += row.gradient_before;
      std::vector<Eigen::Vector2d> by_command(n_, Eigen::Vector2d::Zero());
      add_pullback(problem_, commands_, poses_, by_pose, by_command);
      if (row.margin < -active_) {
        rest_ -= problem_.violation_weight * flat(by_command);
      } else {
        columns_.push_back(flat(by_command));
        most_.push_back(problem_.violation_weight);
      }
    });
  }

  void add_hard_row(Eigen::Index coordinate, double sign, double room, bool is_change) {
    if (room > active_) return;
    Eigen::VectorXd column = Eigen::VectorXd::Zero(rest_.size());
    column[coordinate] = sign;
    if (is_change && coordinate >= 2) column[coordinate - 2] = -sign;
    columns_.push_back(column);
    most_.push_back(std::numeric_limits<double>::infinity());
  }

  void add_hard_rows() {
    for (std::size_t k = 0; k < n_; ++k) {
      const bool stopped = problem_.stop_at_end && k + 1 == n_;
      const Twist2& before = k == 0 ? problem_.previous_command : commands_[k - 1];
      const auto add = [&](Eigen::Index c, double value, double previous, double low, double high,
                           double change) {
        add_hard_row(c, 1.0, stopped ? 0.0 : value - low, false);
        add_hard_row(c, -1.0, stopped ? 0.0 : high - value, false);
        add_hard_row(c, 1.0, value - previous + change, true);
        add_hard_row(c, -1.0, change - value + previous, true);
      };
      const auto c = 2 * static_cast<Eigen::Index>(k);
      add(c, commands_[k].linear, before.linear, problem_.command_min.linear,
          problem_.command_max.linear, problem_.max_change.linear);
      add(c + 1, commands_[k].angular, before.angular, problem_.command_min.angular,
          problem_.command_max.angular, problem_.max_change.angular);
    }
  }

  const ControlProblem& problem_;
  std::size_t n_;
  double active_;
  std::vector<Twist2> commands_;
  std::vector<Pose2> poses_;
  Eigen::VectorXd rest_;
  std::vector<Eigen::VectorXd> columns_;
  std::vector<double> most_;
};

/// Rows within `active` [their unit] of their bound count as being at it.
inline double optimality_residual(const ControlProblem& problem,
                                  const MpcSolution& solution,
                                  double active = 1e-4) {
  return OptimalityOracle(problem, solution, active).residual();
>>>>>>> solver
}

}  // namespace fairway::test
