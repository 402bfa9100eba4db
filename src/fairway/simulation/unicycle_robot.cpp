// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/unicycle_robot.hpp"

#include <algorithm>

#include "fairway/geometry/angle.hpp"

namespace fairway {

namespace {

double ramped(double from, double to, double most) noexcept {
  return from + std::clamp(to - from, -most, most);
}

}  // namespace

void UnicycleRobot::advance(const Twist2& command, double dt) noexcept {
  const Twist2 next{
      .linear = ramped(twist.linear, command.linear, limits.linear_acceleration * dt),
      .angular = ramped(twist.angular, command.angular, limits.angular_acceleration * dt)};
  const Twist2 mean{.linear = 0.5 * (twist.linear + next.linear),
                    .angular = 0.5 * (twist.angular + next.angular)};
  pose.position += dt * mean.linear * direction(pose.heading + 0.5 * dt * mean.angular);
  pose.heading = wrap_to_pi(pose.heading + dt * mean.angular);
  twist = next;
}

}  // namespace fairway
