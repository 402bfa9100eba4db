// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <Eigen/Core>

#include "fairway/mpc/control_problem.hpp"

// Analytic first and second derivatives of the functions in evaluation.hpp. Poses are ordered (x,
// y, heading), commands (linear, angular).

namespace fairway {

/// First derivatives of one step of the unicycle.
struct StepJacobian {
  Eigen::Matrix3d by_pose = Eigen::Matrix3d::Identity();
  Eigen::Matrix<double, 3, 2> by_command = Eigen::Matrix<double, 3, 2>::Zero();
};

/// Computes the first derivatives of one step of the unicycle, see `step`.
[[nodiscard]] StepJacobian step_jacobian(const Pose2& pose,
                                         const Twist2& command,
                                         double dt,
                                         Integration integration) noexcept;

/// Computes the second derivatives of (multiplier . next pose).
///
/// Only heading, linear and angular speed have second derivatives; the matrix is ordered by these
/// three. The heading of the next pose is linear, so the third multiplier has no effect.
[[nodiscard]] Eigen::Matrix3d step_hessian(const Pose2& pose,
                                           const Twist2& command,
                                           double dt,
                                           Integration integration,
                                           const Eigen::Vector3d& multiplier) noexcept;

/// Derivative of the cost by pose k with fixed commands: 2 weight (pose - target). @pre 1 <= k <= N
[[nodiscard]] Eigen::Vector3d cost_gradient_by_pose(const ControlProblem& problem,
                                                    const Pose2& pose,
                                                    int k) noexcept;

/// Derivative of the cost by command k with fixed poses. @pre 0 <= k < N
[[nodiscard]] Eigen::Vector2d cost_gradient_by_command(const ControlProblem& problem,
                                                       std::span<const Twist2> commands,
                                                       int k) noexcept;

/// Second derivative of the cost by command k, which is diagonal. The derivative by commands k and
/// k + 1 is -2 change_weight, that by a pose is 2 weight, and all others are 0.
[[nodiscard]] Eigen::Vector2d cost_hessian_by_command(const ControlProblem& problem,
                                                      int k) noexcept;

/// Transforms derivatives by the poses into derivatives by the commands, through the rollout
/// (adjoint).
///
/// @param by_pose  Derivative of a function by poses 0..N; pose 0 is fixed and not read.
/// @param by_command  The derivative by commands 0..N-1 is added to this.
void add_pullback(const ControlProblem& problem,
                  std::span<const Twist2> commands,
                  std::span<const Pose2> poses,
                  std::span<const Eigen::Vector3d> by_pose,
                  std::span<Eigen::Vector2d> by_command) noexcept;

/// Total derivative of the cost by the commands, with poses from the rollout.
void cost_gradient(const ControlProblem& problem,
                   std::span<const Twist2> commands,
                   std::span<const Pose2> poses,
                   std::span<Eigen::Vector2d> gradient) noexcept;

}  // namespace fairway
