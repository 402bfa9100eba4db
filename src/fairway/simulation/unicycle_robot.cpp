// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/unicycle_robot.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/geometry/angle.hpp"

namespace fairway {

namespace {

double followed(double speed, double command, const AxisActuation& axis, double dt) noexcept {
  const double wanted =
      axis.lag > 0.0 ? speed + (command - speed) * -std::expm1(-dt / axis.lag) : command;
  return limited_change(speed, wanted, axis, dt);
}

double or_else(double value, double fallback) noexcept { return value > 0.0 ? value : fallback; }

}  // namespace

UnicycleLimits limits_of(const RobotSettings& robot) noexcept {
  return {.linear_acceleration = robot.linear_acceleration_max,
          .angular_acceleration = robot.angular_acceleration_max,
          .linear_braking = robot.linear_braking_max,
          .angular_braking = robot.angular_braking_max,
          .linear_delay = robot.linear_delay,
          .angular_delay = robot.angular_delay,
          .linear_lag = robot.linear_lag,
          .angular_lag = robot.angular_lag};
}

Twist2 BaseController::follow(const Twist2& twist,
                              const Twist2& command,
                              const UnicycleLimits& limits,
                              double dt) noexcept {
  const AxisActuation linear{.delay = limits.linear_delay,
                             .lag = limits.linear_lag,
                             .acceleration = limits.linear_acceleration,
                             .braking = or_else(limits.linear_braking, limits.linear_acceleration)};
  const AxisActuation angular{
      .delay = limits.angular_delay,
      .lag = limits.angular_lag,
      .acceleration = limits.angular_acceleration,
      .braking = or_else(limits.angular_braking, limits.angular_acceleration)};
  receive(command);
  const double middle = time_ + 0.5 * dt;
  time_ += dt;
  return {.linear = followed(
              twist.linear,
              linear.delay > 0.0 ? received_by(middle - linear.delay).linear : command.linear,
              linear, dt),
          .angular = followed(
              twist.angular,
              angular.delay > 0.0 ? received_by(middle - angular.delay).angular : command.angular,
              angular, dt)};
}

void BaseController::receive(const Twist2& command) noexcept {
  if (count_ > 0) {
    const Twist2& last = commands_[(count_ - 1) % kRemembered].command;
    if (last.linear == command.linear && last.angular == command.angular) return;
  }
  commands_[count_++ % kRemembered] = {.time = time_, .command = command};
}

// Before the first command the base stays at standstill.
Twist2 BaseController::received_by(double time) const noexcept {
  const std::size_t kept = std::min(count_, kRemembered);
  for (std::size_t n = 1; n <= kept; ++n) {
    const Command& command = commands_[(count_ - n) % kRemembered];
    if (command.time <= time) return command.command;
  }
  return {};
}

void UnicycleRobot::advance(const Twist2& command, double dt) noexcept {
  const Twist2 next = controller.follow(twist, command, limits, dt);
  const Twist2 mean{.linear = 0.5 * (twist.linear + next.linear),
                    .angular = 0.5 * (twist.angular + next.angular)};
  pose.position += dt * mean.linear * direction(pose.heading + 0.5 * dt * mean.angular);
  pose.heading = wrap_to_pi(pose.heading + dt * mean.angular);
  twist = next;
}

}  // namespace fairway
