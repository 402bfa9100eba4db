// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/bodies/body_robot.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/geometry/angle.hpp"

namespace fairway {

void BodyRobot::advance(double dt) noexcept {
  const BaseModel& base = model.base;
  // A part of a command must not arrive before the others, so all of them ramp together.
  const bool steered = is_steered(base);
  double share = 1.0;
  const auto bound = [&](double from, double to, double rate) {
    const double change = std::abs(to - from);
    if (change > rate * dt) share = std::min(share, rate * dt / change);
  };
  bound(input.linear, sent.linear, base.linear_acceleration);
  bound(input.lateral, sent.lateral, base.lateral_acceleration);
  bound(input.turn, sent.turn, steered ? base.steering_rate_max : base.angular_acceleration);
  if (steered) {
    bound(twist_of(base, input).angular, twist_of(base, sent).angular, base.angular_acceleration);
  }
  const BaseInput next = share >= 1.0 ? sent : (1.0 - share) * input + share * sent;
  pose = driven(base, pose, input, next, dt);
  pose.heading = wrap_to_pi(pose.heading);
  input = next;
}

}  // namespace fairway
