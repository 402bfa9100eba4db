// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/initial_guess.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/geometry/angle.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

double limited(double from, double wanted, double change, double low, double high) noexcept {
  return std::clamp(std::clamp(wanted, from - change, from + change), std::min(low, from + change),
                    std::max(high, from - change));
}

Twist2 limited(const Twist2& from, const Twist2& wanted, const ControlProblem& problem) noexcept {
  return {.linear = limited(from.linear, wanted.linear, problem.max_change.linear,
                            problem.command_min.linear, problem.command_max.linear),
          .angular = limited(from.angular, wanted.angular, problem.max_change.angular,
                             problem.command_min.angular, problem.command_max.angular)};
}

// Returns the command of a plan at step `k`, interpolated between steps, and its last command
// beyond its end.
Twist2 command_at(const MpcSolution& plan, double k) noexcept {
  const auto last = static_cast<std::size_t>(plan.horizon - 1);
  const auto at = static_cast<std::size_t>(k);
  if (at >= last) return plan.commands[last];
  const double share = k - static_cast<double>(at);
  const Twist2& from = plan.commands[at];
  if (share == 0.0) return from;
  const Twist2& to = plan.commands[at + 1];
  return {.linear = from.linear + share * (to.linear - from.linear),
          .angular = from.angular + share * (to.angular - from.angular)};
}

}  // namespace

GuessedMotion shifted_guess(const ControlProblem& problem,
                            const MpcSolution& last,
                            double shift) noexcept {
  GuessedMotion start;
  start.guess.count = problem.horizon;
  start.poses[0] = problem.start;
  Twist2 before = problem.previous_command;
  const double steps = shift == problem.dt ? 1.0 : shift / problem.dt;
  for (int k = 0; k < problem.horizon; ++k) {
    const auto at = static_cast<std::size_t>(k);
    before = limited(before, command_at(last, k + steps), problem);
    start.guess.commands[at] = before;
    start.poses[at + 1] = step(start.poses[at], before, problem.dt, problem.integration);
  }
  return start;
}

GuessedMotion pursuit_guess(const ControlProblem& problem) noexcept {
  constexpr int kLead = 4;  // steps that the aim is ahead, so that the pursuit does not oscillate
  constexpr double kTurningSteps = 3.0;  // steps in which a heading error is corrected
  constexpr double kArrived = 0.05;      // [m]; closer than this the direction to the aim is noise
  // Straight behind an obstacle with equal clearance on both sides, a start without a turn would
  // lead to neither side.
  constexpr double kLean = 0.01;  // [rad/s]
  GuessedMotion start;
  start.guess.count = problem.horizon;
  start.poses[0] = problem.start;
  Twist2 before = problem.previous_command;
  for (int k = 0; k < problem.horizon; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const Pose2& pose = start.poses[at];
    const StepTarget& aim =
        problem.targets[static_cast<std::size_t>(std::min(k + 1 + kLead, problem.horizon))];
    const Vector2d to_aim = aim.position - pose.position;
    const bool arrived = to_aim.norm() < kArrived;
    const double bearing = arrived ? aim.heading : std::atan2(to_aim.y(), to_aim.x());
    const double error = shortest_turn(pose.heading, bearing);
    const double reach = (problem.targets[at + 1].position - pose.position).norm() / problem.dt;
    const Twist2 wanted{.linear = arrived ? 0.0 : reach * std::max(0.0, std::cos(error)),
                        .angular = error / (kTurningSteps * problem.dt) + kLean};
    before = limited(before, wanted, problem);
    start.guess.commands[at] = before;
    start.poses[at + 1] = step(pose, before, problem.dt, problem.integration);
  }
  return start;
}

}  // namespace fairway
