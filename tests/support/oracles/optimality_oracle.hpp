// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "fairway/mpc/derivatives.hpp"
#include "fairway/mpc/evaluation.hpp"

namespace fairway::test {

/// Measures how far a solution is from the first-order optimality conditions, from its commands
/// alone. It is the least norm of
///     grad J - sum y_i grad c_i - sum l_j grad g_j
/// over 0 <= y_i <= penalty weight for the soft constraints at their bound (y_i = penalty weight
/// where violated, 0 where inactive) and l_j >= 0 for the bounds at their bound. Slow: bounded
/// least squares by coordinate descent.
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
    add_soft_constraints();
    add_bounds();
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

  void add_soft_constraints() {
    visit_soft_constraints(problem_, [&](const ConstraintName& name) {
      const SoftConstraint row = soft_constraint(problem_, poses_, name);
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

  void add_bound(Eigen::Index coordinate, double sign, double room, bool is_change) {
    if (room > active_) return;
    Eigen::VectorXd column = Eigen::VectorXd::Zero(rest_.size());
    column[coordinate] = sign;
    if (is_change && coordinate >= 2) column[coordinate - 2] = -sign;
    columns_.push_back(column);
    most_.push_back(std::numeric_limits<double>::infinity());
  }

  void add_bounds() {
    for (std::size_t k = 0; k < n_; ++k) {
      const bool stopped = problem_.stop_at_end && k + 1 == n_;
      const Twist2& before = k == 0 ? problem_.previous_command : commands_[k - 1];
      const auto add = [&](Eigen::Index c, double value, double previous, double low, double high,
                           double change) {
        add_bound(c, 1.0, stopped ? 0.0 : value - low, false);
        add_bound(c, -1.0, stopped ? 0.0 : high - value, false);
        add_bound(c, 1.0, value - previous + change, true);
        add_bound(c, -1.0, change - value + previous, true);
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

/// Constraints within `active` [their unit] of their bound count as active.
inline double optimality_residual(const ControlProblem& problem,
                                  const MpcSolution& solution,
                                  double active = 1e-4) {
  return OptimalityOracle(problem, solution, active).residual();
}

}  // namespace fairway::test
