// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/evaluation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fairway/mpc/step_index.hpp"

namespace fairway {
namespace {

void note(Violation& violation, const ConstraintName& name, double amount) noexcept {
  if (!(amount > 0.0)) return;
  violation.sum += amount;
  if (amount > violation.max) {
    violation.max = amount;
    violation.worst = name;
  }
}

double finite_or_zero(double value) noexcept { return std::isfinite(value) ? value : 0.0; }

}  // namespace

CommandBounds reachable_bounds(const ControlProblem& problem, int k) noexcept {
  CommandBounds bounds{.min = problem.command_min, .max = problem.command_max};
  if (!problem.stop_at_end) return bounds;
  const double steps_left = problem.horizon - 1 - k;
  // 0 * infinity at the last step would be NaN; its bound is 0 in any case.
  const double linear = steps_left > 0.0 ? steps_left * problem.max_change.linear : 0.0;
  const double angular = steps_left > 0.0 ? steps_left * problem.max_change.angular : 0.0;
  bounds.min.linear = std::max(bounds.min.linear, -linear);
  bounds.max.linear = std::min(bounds.max.linear, linear);
  bounds.min.angular = std::max(bounds.min.angular, -angular);
  bounds.max.angular = std::min(bounds.max.angular, angular);
  return bounds;
}

void clip_to_bounds(const ControlProblem& problem, std::span<Twist2> commands) noexcept {
  const auto clip = [](double value, double before, double change, double low, double high) {
    // The range is applied last, so that it holds where rounding makes the two disagree.
    return std::clamp(std::clamp(finite_or_zero(value), before - change, before + change), low,
                      high);
  };
  Twist2 before = problem.previous_command;
  for (int k = 0; k < problem.horizon; ++k) {
    const CommandBounds range = reachable_bounds(problem, k);
    Twist2& command = commands[step_index(k)];
    command.linear = clip(command.linear, before.linear, problem.max_change.linear,
                          range.min.linear, range.max.linear);
    command.angular = clip(command.angular, before.angular, problem.max_change.angular,
                           range.min.angular, range.max.angular);
    before = command;
  }
}

void expand_guess(const ControlProblem& problem,
                  const InitialGuess& guess,
                  std::span<Twist2> commands) noexcept {
  const int given = std::clamp(guess.count, 0, kMaxHorizon);
  for (int k = 0; k < problem.horizon; ++k)
    commands[step_index(k)] =
        given > 0 ? guess.commands[step_index(std::min(k, given - 1))] : Twist2{};
  clip_to_bounds(problem, commands);
}

void rollout(const ControlProblem& problem,
             std::span<const Twist2> commands,
             std::span<Pose2> poses) noexcept {
  poses[0] = problem.start;
  for (int k = 0; k < problem.horizon; ++k)
    poses[step_index(k + 1)] =
        step(poses[step_index(k)], commands[step_index(k)], problem.dt, problem.integration);
}

double cost(const ControlProblem& problem,
            std::span<const Twist2> commands,
            std::span<const Pose2> poses) noexcept {
  double sum = problem.cost_offset;
  Eigen::Vector2d before = as_vector(problem.previous_command);
  for (int k = 0; k < problem.horizon; ++k) {
    const Eigen::Vector2d command = as_vector(commands[step_index(k)]);
    sum += problem.command_weight.dot(command.cwiseAbs2());
    if (k > 0 || problem.penalise_first_change)
      sum += problem.change_weight.dot((command - before).cwiseAbs2());
    before = command;

    const StepTarget& target = problem.targets[step_index(k + 1)];
    const Pose2& pose = poses[step_index(k + 1)];
    const double turn = pose.heading - target.heading;
    sum += target.weight.head<2>().dot((pose.position - target.position).cwiseAbs2()) +
           target.weight.z() * turn * turn;
  }
  return sum;
}

double barrier(const PredictedObstacle& obstacle, int k, const Eigen::Vector2d& position) noexcept {
  const double keep_out = obstacle.keep_out[step_index(k)];
  return (position - obstacle.position[step_index(k)]).squaredNorm() - keep_out * keep_out;
}

SoftConstraint soft_constraint(const ControlProblem& problem,
                               std::span<const Pose2> poses,
                               const ConstraintName& name) noexcept {
  const Eigen::Vector2d& here = poses[step_index(name.step)].position;
  if (name.kind == ConstraintKind::Corridor) {
    // Eqs. (8)-(10): in the rectangle's frame, side 0: x - min.x, 1: max.x - x, 2, 3: same for y.
    const OrientedRectangle& rectangle =
        problem.regions[step_index(name.step)].rectangles[step_index(name.index / 4)];
    const int axis = (name.index % 4) / 2;
    const bool upper = name.index % 2 == 1;
    const Eigen::Vector2d normal = rotated(
        axis == 0 ? Eigen::Vector2d::UnitX() : Eigen::Vector2d::UnitY(), rectangle.orientation);
    const double along = normal.dot(here - rectangle.seed);
    if (upper) return {.margin = rectangle.max[axis] - along, .gradient = -normal};
    return {.margin = along - rectangle.min[axis], .gradient = normal};
  }
  // Eq. (14) with 1 - gamma dt = barrier_retention.
  const PredictedObstacle& obstacle = problem.obstacles[step_index(name.index)];
  const Eigen::Vector2d& before = poses[step_index(name.step - 1)].position;
  const double retention = problem.barrier_retention;
  return {
      .margin =
          barrier(obstacle, name.step, here) - retention * barrier(obstacle, name.step - 1, before),
      .gradient = 2.0 * (here - obstacle.position[step_index(name.step)]),
      .gradient_before = -2.0 * retention * (before - obstacle.position[step_index(name.step - 1)]),
      .curvature = 2.0,
      .curvature_before = -2.0 * retention};
}

Violation soft_violation(const ControlProblem& problem, std::span<const Pose2> poses) noexcept {
  Violation violation;
  visit_soft_constraints(problem, [&](const ConstraintName& name) {
    note(violation, name, -soft_constraint(problem, poses, name).margin);
  });
  return violation;
}

Violation bound_violation(const ControlProblem& problem,
                          std::span<const Twist2> commands) noexcept {
  Violation violation;
  constexpr std::array kRange{ConstraintKind::LinearSpeed, ConstraintKind::AngularSpeed};
  constexpr std::array kChange{ConstraintKind::LinearChange, ConstraintKind::AngularChange};
  const Eigen::Vector2d low = as_vector(problem.command_min);
  const Eigen::Vector2d high = as_vector(problem.command_max);
  const Eigen::Vector2d change = as_vector(problem.max_change);
  Eigen::Vector2d before = as_vector(problem.previous_command);
  for (int k = 0; k < problem.horizon; ++k) {
    const Eigen::Vector2d command = as_vector(commands[step_index(k)]);
    const bool stopped = problem.stop_at_end && k == problem.horizon - 1;
    for (int i = 0; i < 2; ++i) {
      const ConstraintName range{.kind = kRange[step_index(i)], .step = k, .index = i};
      note(violation, range, std::max(low[i] - command[i], command[i] - high[i]));
      if (stopped) note(violation, range, std::abs(command[i]));
      note(violation, {.kind = kChange[step_index(i)], .step = k, .index = i},
           std::abs(command[i] - before[i]) - change[i]);
    }
    before = command;
  }
  return violation;
}

void assess(const ControlProblem& problem, MpcSolution& solution) noexcept {
  solution.horizon = problem.horizon;
  rollout(problem, solution.commands, solution.poses);
  solution.cost = cost(problem, solution.commands, solution.poses);
  const Violation violation = soft_violation(problem, solution.poses);
  solution.max_violation = violation.max;
  solution.sum_violation = violation.sum;
}

}  // namespace fairway
