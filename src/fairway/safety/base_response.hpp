// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "fairway/geometry/pose2.hpp"
#include "fairway/geometry/robot_settings.hpp"
#include "fairway/safety/command_history.hpp"

namespace fairway {

/// Acceleration, braking, delay and lag of both axes.
struct BaseActuation {
  AxisActuation linear;
  AxisActuation angular;

  /// Neither delay nor lag.
  [[nodiscard]] bool is_exact() const noexcept { return linear.is_exact() && angular.is_exact(); }
  [[nodiscard]] double longest_delay() const noexcept {
    return std::max(linear.delay, angular.delay);
  }
};

[[nodiscard]] inline BaseActuation actuation_of(const RobotSettings& robot) noexcept {
  return {.linear = linear_actuation(robot), .angular = angular_actuation(robot)};
}

/// The time in which the base can change its speed from `from` to `to` [s].
[[nodiscard]] inline double change_time(double from,
                                        double to,
                                        const AxisActuation& axis) noexcept {
  const double kept = from * to > 0.0 ? to : 0.0;  // down to here counts as braking
  if (std::abs(kept) < std::abs(from))
    return std::abs(from - kept) / axis.braking + std::abs(kept - to) / axis.acceleration;
  return std::abs(to - from) / axis.acceleration;
}

/// The twists of the two members of the family of bases that bound all others (docs/safety.md).
///
/// `slow` ramps linearly to each command over the time for which its change was made; `quick`
/// changes as hard as acceleration and braking allow, and holds. Both have the delay and the lag.
struct BaseResponse {
  Twist2 slow;
  Twist2 quick;
};

/// What a member of the family does in a short time.
struct SpeedChange {
  double mean = 0.0;
  double end = 0.0;
};

/// The quick member, from `speed` under `command` for `time` [s].
[[nodiscard]] inline SpeedChange quick_change(double speed,
                                              double command,
                                              const AxisActuation& axis,
                                              double time) noexcept {
  const double wanted =
      axis.lag > 0.0 ? speed + (command - speed) * -std::expm1(-time / axis.lag) : command;
  const double end = limited_change(speed, wanted, axis, time);
  constexpr double kSame = 1e-9;
  const bool reached = std::abs(end - wanted) < kSame;
  if (!reached) return {.mean = 0.5 * (speed + end), .end = end};
  if (axis.lag > 0.0) return {.mean = command - (end - speed) * axis.lag / time, .end = end};
  const double rate = std::abs(end) < std::abs(speed) ? axis.braking : axis.acceleration;
  const double ramp = std::min(time, std::abs(end - speed) / rate);
  return {.mean = end + 0.5 * (speed - end) * ramp / time, .end = end};
}

/// The slow member, whose delayed and ramped command has the mean `command` in this `time` [s].
[[nodiscard]] inline SpeedChange slow_change(double speed,
                                             double command,
                                             const AxisActuation& axis,
                                             double time) noexcept {
  if (axis.lag <= 0.0) return {.mean = command, .end = command};
  const double end = speed + (command - speed) * -std::expm1(-time / axis.lag);
  return {.mean = command - (end - speed) * axis.lag / time, .end = end};
}

/// Follows one axis from `from` to `to` [s], in the times of its commands. `input` is the twist
/// that is asked for at a time, `next_change` when it changes next, `change` the answer of the
/// axis.
template <typename Input, typename NextChange, typename Change>
[[nodiscard]] SpeedChange follow_axis(double Twist2::*member,
                                      double speed,
                                      double from,
                                      double to,
                                      const Input& input,
                                      const NextChange& next_change,
                                      const Change& change) noexcept {
  constexpr double kShort = 1e-9;  // [s]
  double distance = 0.0;
  double time = from;
  while (time < to - kShort) {
    const double next = std::min(to, std::max(next_change(time), time + kShort));
    const SpeedChange part = change(speed, input(0.5 * (time + next)).*member, next - time);
    distance += part.mean * (next - time);
    speed = part.end;
    time = next;
  }
  return {.mean = distance / (to - from), .end = speed};
}

/// Follows both members from `from` to `to` [s] along the commands that were sent.
void advance(BaseResponse& response,
             const CommandHistory& history,
             const BaseActuation& actuation,
             double from,
             double to) noexcept;

}  // namespace fairway
