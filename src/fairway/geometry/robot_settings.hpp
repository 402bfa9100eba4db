// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "fairway/base/setting.hpp"
#include "fairway/geometry/footprint.hpp"

namespace fairway {

/// The robot: its body, and what its base can do.
///
/// The body is a disc, a rectangle along the heading, or several discs. Paths, corridors and plans
/// keep the disc of `radius` free, whatever the heading; the check of each command tests the true
/// body. The base is a unicycle: it drives along its heading and turns.
struct RobotSettings {
  double radius = 0.25;      ///< radius of the disc that covers the robot [m], 0.01 to 10
  double length = 0.0;       ///< length of a rectangular body [m], 0 to 20; 0: the body is the disc
  double width = 0.0;        ///< width of a rectangular body [m], 0 to 20; 0: the body is the disc
  BodyDiscs discs{};         ///< discs that form the body, in its frame; none: rectangle or disc
  double linear_min = 0.0;   ///< least linear speed [m/s], -10 to 10; negative allows reversing
  double linear_max = 1.0;   ///< greatest linear speed [m/s], 0.01 to 10
  double angular_max = 1.5;  ///< greatest angular speed to both sides [rad/s], 0.01 to 20
  double linear_acceleration_max = 2.0;  ///< greatest gain of linear speed [m/s^2], 0.01 to 1000
  double angular_acceleration_max =
      4.0;  ///< greatest gain of angular speed [rad/s^2], 0.01 to 1000
  double linear_braking_max =
      0.0;  ///< greatest loss of linear speed [m/s^2], 0 to 1000; 0: as the gain
  double angular_braking_max =
      0.0;                     ///< greatest loss of angular speed [rad/s^2], 0 to 1000; 0: as gain
  double linear_delay = 0.0;   ///< until a linear command begins to act [s], 0 to 0.6
  double angular_delay = 0.0;  ///< until an angular command begins to act [s], 0 to 0.6
  double linear_lag = 0.0;     ///< time constant with which linear speed follows [s], 0 to 1
  double angular_lag = 0.0;    ///< time constant with which angular speed follows [s], 0 to 1
};

/// How one speed of the base follows its command. After `delay` it follows as v' = (command - v) /
/// lag, never faster than `acceleration` and `braking` allow.
struct AxisActuation {
  double delay = 0.0;         ///< [s]
  double lag = 0.0;           ///< [s]; 0: as fast as the limits allow
  double acceleration = 1.0;  ///< of a speed that grows in magnitude [m/s^2] or [rad/s^2]
  double braking = 1.0;       ///< of a speed that shrinks in magnitude

  [[nodiscard]] bool is_exact() const noexcept { return delay == 0.0 && lag == 0.0; }
};

[[nodiscard]] inline AxisActuation linear_actuation(const RobotSettings& robot) noexcept {
  const double a = robot.linear_acceleration_max;
  return {.delay = robot.linear_delay,
          .lag = robot.linear_lag,
          .acceleration = a,
          .braking = robot.linear_braking_max > 0.0 ? robot.linear_braking_max : a};
}

[[nodiscard]] inline AxisActuation angular_actuation(const RobotSettings& robot) noexcept {
  const double a = robot.angular_acceleration_max;
  return {.delay = robot.angular_delay,
          .lag = robot.angular_lag,
          .acceleration = a,
          .braking = robot.angular_braking_max > 0.0 ? robot.angular_braking_max : a};
}

/// Returns the change that is possible in both directions: the smaller one of acceleration and
/// braking. Plans keep to it.
[[nodiscard]] inline double change_max(const AxisActuation& axis) noexcept {
  return std::min(axis.acceleration, axis.braking);
}

/// Returns the speed `time` [s] after `speed`, as near to `wanted` as acceleration and braking
/// allow.
[[nodiscard]] inline double limited_change(double speed,
                                           double wanted,
                                           const AxisActuation& axis,
                                           double time) noexcept {
  if (axis.acceleration != axis.braking && speed != 0.0) {
    // Down to zero, or to what is wanted on this side of it, counts as braking.
    const double target = wanted * speed > 0.0 ? wanted : 0.0;
    if (std::abs(target) < std::abs(speed)) {
      const double most = axis.braking * time;
      if (std::abs(speed - target) >= most) return speed - std::copysign(most, speed);
      if (target == wanted) return wanted;
      return limited_change(0.0, wanted, axis, time - std::abs(speed) / axis.braking);
    }
  }
  const double most = axis.acceleration * time;
  return speed + std::clamp(wanted - speed, -most, most);
}

/// From the time that a command is sent until the base has answered to it, without the ramp [s].
[[nodiscard]] inline double dead_time(const RobotSettings& robot) noexcept {
  return std::max(robot.linear_delay + robot.linear_lag, robot.angular_delay + robot.angular_lag);
}

/// The outline that must never touch anything.
[[nodiscard]] inline Footprint footprint_of(const RobotSettings& robot) noexcept {
  if (robot.discs.count > 0) return Footprint::discs(robot.discs.discs.data(), robot.discs.count);
  return robot.length > 0.0 && robot.width > 0.0 ? Footprint::rectangle(robot.length, robot.width)
                                                 : Footprint::disc(robot.radius);
}

/// The distance in which the robot stops from its greatest speed [m].
[[nodiscard]] inline double braking_distance(const RobotSettings& robot) noexcept {
  const AxisActuation axis = linear_actuation(robot);
  return 0.5 * robot.linear_max * robot.linear_max / axis.braking +
         robot.linear_max * (axis.delay + axis.lag);
}

template <typename Settings, typename Visitor>
void visit_robot(Settings& s, Visitor&& field) {
  field(s.radius, SettingInfo{"radius", "m", "radius of the disc that covers the robot", 0.01, 10,
                              kEssential});
  field(s.length,
        SettingInfo{"length", "m", "length of a rectangular body; 0: the body is the disc", 0, 20,
                    kEssential});
  field(s.width, SettingInfo{"width", "m", "width of a rectangular body; 0: the body is the disc",
                             0, 20, kEssential});
  field(s.discs, SettingInfo{"discs", "m",
                             "discs that form the body, in the robot's frame; none: the body is "
                             "the rectangle or the disc"});
  field(s.linear_min,
        SettingInfo{"linear_min", "m/s", "least linear speed; negative allows reversing", -10, 10,
                    kEssential});
  field(s.linear_max,
        SettingInfo{"linear_max", "m/s", "greatest linear speed", 0.01, 10, kEssential});
  field(s.angular_max,
        SettingInfo{"angular_max", "rad/s", "greatest angular speed", 0.01, 20, kEssential});
  field(s.linear_acceleration_max,
        SettingInfo{"linear_acceleration_max", "m/s^2",
                    "greatest change of linear speed per second", 0.01, 1000, kEssential});
  field(s.angular_acceleration_max,
        SettingInfo{"angular_acceleration_max", "rad/s^2",
                    "greatest change of angular speed per second", 0.01, 1000, kEssential});
  field(s.linear_braking_max,
        SettingInfo{"linear_braking_max", "m/s^2",
                    "greatest loss of linear speed per second; 0: linear_acceleration_max", 0, 1000,
                    kEssential});
  field(s.angular_braking_max,
        SettingInfo{"angular_braking_max", "rad/s^2",
                    "greatest loss of angular speed per second; 0: angular_acceleration_max", 0,
                    1000});
  field(s.linear_delay,
        SettingInfo{"linear_delay", "s", "time until a linear command begins to act", 0, 0.6,
                    kEssential});
  field(s.angular_delay,
        SettingInfo{"angular_delay", "s", "time until an angular command begins to act", 0, 0.6,
                    kEssential});
  field(s.linear_lag,
        SettingInfo{"linear_lag", "s",
                    "time constant with which the base's linear speed follows its command", 0, 1,
                    kEssential});
  field(s.angular_lag,
        SettingInfo{"angular_lag", "s",
                    "time constant with which the base's angular speed follows its command", 0, 1,
                    kEssential});
}

}  // namespace fairway
