// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/problem_from_settings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/base/contract.hpp"

namespace fairway {

namespace {

struct SpeedRange {
  double low;
  double high;
};

// Extends `range` to the speeds on the path from `last` back into it, in steps of `change`.
SpeedRange reachable(const SpeedRange& range, double last, double change) noexcept {
  return {.low = std::min(range.low, last + change), .high = std::max(range.high, last - change)};
}

// Returns the change limit, or infinity if it never binds. It never binds if it covers the whole
// range and the last command, which may lie outside the range.
double change_limit(double acceleration, double dt, const SpeedRange& range, double last) noexcept {
  const double change = acceleration * dt;
  const double widest = std::max(range.high, last) - std::min(range.low, last);
  return change >= widest ? std::numeric_limits<double>::infinity() : change;
}

}  // namespace

void set_from_settings(const MpcSettings& mpc,
                       const RobotSettings& robot,
                       const Twist2& last_command,
                       ControlProblem& problem) noexcept {
  FAIRWAY_EXPECTS(mpc.horizon >= 1 && mpc.horizon <= kMaxHorizon);
  const double dt = mpc.step_length;
  const SpeedRange linear{.low = robot.linear_min, .high = robot.linear_max};
  const double turn = std::max(robot.angular_max, std::abs(last_command.angular));
  const SpeedRange angular{.low = -robot.angular_max, .high = robot.angular_max};
  problem.horizon = mpc.horizon;
  problem.dt = dt;
  problem.integration = mpc.integration;
  problem.previous_command = last_command;
  problem.max_change = {
      .linear = change_limit(change_max(linear_actuation(robot)), dt, linear, last_command.linear),
      .angular = change_limit(change_max(angular_actuation(robot)), dt, {-turn, turn}, 0.0)};
  const SpeedRange linear_now = reachable(linear, last_command.linear, problem.max_change.linear);
  const SpeedRange angular_now =
      reachable(angular, last_command.angular, problem.max_change.angular);
  problem.command_min = {.linear = linear_now.low, .angular = angular_now.low};
  problem.command_max = {.linear = linear_now.high, .angular = angular_now.high};
  problem.command_weight = {mpc.weight_linear, mpc.weight_angular};
  problem.change_weight = {mpc.weight_linear_change, mpc.weight_angular_change};
  problem.penalise_first_change = mpc.penalise_first_change;
  problem.cost_offset = 0.0;
  problem.barrier_retention = 1.0 - mpc.decay_rate * dt;
  problem.violation_weight = mpc.violation_weight;
}

}  // namespace fairway
