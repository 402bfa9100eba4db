// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/derivatives.hpp"

#include <array>

#include "fairway/mpc/step_index.hpp"

namespace fairway {
namespace {

// Derivative of the direction of travel by the angular speed [s].
double lead(double dt, Integration integration) noexcept {
  return integration == Integration::Midpoint ? 0.5 * dt : 0.0;
}

Eigen::Vector2d left_of(const Eigen::Vector2d& v) noexcept { return {-v.y(), v.x()}; }

}  // namespace

// next position = p + dt u e(a), a = psi + lead r, e' = left of e; next heading = psi + dt r.
StepJacobian step_jacobian(const Pose2& pose,
                           const Twist2& command,
                           double dt,
                           Integration integration) noexcept {
  const double turn_lead = lead(dt, integration);
  const Eigen::Vector2d along = direction(pose.heading + turn_lead * command.angular);
  const Eigen::Vector2d by_angle = dt * command.linear * left_of(along);
  StepJacobian jacobian;
  jacobian.by_pose.col(2).head<2>() = by_angle;
  jacobian.by_command.col(0).head<2>() = dt * along;
  jacobian.by_command.col(1).head<2>() = turn_lead * by_angle;
  jacobian.by_command(2, 1) = dt;
  return jacobian;
}

Eigen::Matrix3d step_hessian(const Pose2& pose,
                             const Twist2& command,
                             double dt,
                             Integration integration,
                             const Eigen::Vector3d& multiplier) noexcept {
  const double turn_lead = lead(dt, integration);
  const Eigen::Vector2d along = direction(pose.heading + turn_lead * command.angular);
  const double by_angle_twice = -dt * command.linear * multiplier.head<2>().dot(along);
  const double by_angle_and_speed = dt * multiplier.head<2>().dot(left_of(along));
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
  hessian(0, 0) = by_angle_twice;
  hessian(0, 1) = hessian(1, 0) = by_angle_and_speed;
  hessian(0, 2) = hessian(2, 0) = turn_lead * by_angle_twice;
  hessian(1, 2) = hessian(2, 1) = turn_lead * by_angle_and_speed;
  hessian(2, 2) = turn_lead * turn_lead * by_angle_twice;
  return hessian;
}

Eigen::Vector3d cost_gradient_by_pose(const ControlProblem& problem,
                                      const Pose2& pose,
                                      int k) noexcept {
  const StepTarget& target = problem.targets[step_index(k)];
  Eigen::Vector3d difference;
  difference << pose.position - target.position, pose.heading - target.heading;
  return 2.0 * target.weight.cwiseProduct(difference);
}

Eigen::Vector2d cost_gradient_by_command(const ControlProblem& problem,
                                         std::span<const Twist2> commands,
                                         int k) noexcept {
  const Eigen::Vector2d command = as_vector(commands[step_index(k)]);
  Eigen::Vector2d gradient = 2.0 * problem.command_weight.cwiseProduct(command);
  if (k > 0 || problem.penalise_first_change) {
    const Twist2& before = k > 0 ? commands[step_index(k - 1)] : problem.previous_command;
    gradient += 2.0 * problem.change_weight.cwiseProduct(command - as_vector(before));
  }
  if (k + 1 < problem.horizon)
    gradient -=
        2.0 * problem.change_weight.cwiseProduct(as_vector(commands[step_index(k + 1)]) - command);
  return gradient;
}

Eigen::Vector2d cost_hessian_by_command(const ControlProblem& problem, int k) noexcept {
  const int changes =
      (k > 0 || problem.penalise_first_change ? 1 : 0) + (k + 1 < problem.horizon ? 1 : 0);
  return 2.0 * problem.command_weight + 2.0 * changes * problem.change_weight;
}

void add_pullback(const ControlProblem& problem,
                  std::span<const Twist2> commands,
                  std::span<const Pose2> poses,
                  std::span<const Eigen::Vector3d> by_pose,
                  std::span<Eigen::Vector2d> by_command) noexcept {
  Eigen::Vector3d adjoint = Eigen::Vector3d::Zero();
  for (int k = problem.horizon - 1; k >= 0; --k) {
    adjoint += by_pose[step_index(k + 1)];
    const StepJacobian jacobian = step_jacobian(poses[step_index(k)], commands[step_index(k)],
                                                problem.dt, problem.integration);
    by_command[step_index(k)] += jacobian.by_command.transpose() * adjoint;
    adjoint = (jacobian.by_pose.transpose() * adjoint).eval();
  }
}

void cost_gradient(const ControlProblem& problem,
                   std::span<const Twist2> commands,
                   std::span<const Pose2> poses,
                   std::span<Eigen::Vector2d> gradient) noexcept {
  std::array<Eigen::Vector3d, kMaxHorizon + 1> by_pose;
  for (int k = 1; k <= problem.horizon; ++k)
    by_pose[step_index(k)] = cost_gradient_by_pose(problem, poses[step_index(k)], k);
  for (int k = 0; k < problem.horizon; ++k)
    gradient[step_index(k)] = cost_gradient_by_command(problem, commands, k);
  add_pullback(problem, commands, poses, by_pose, gradient);
}

}  // namespace fairway
