// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/base/setting.hpp"
#include "fairway/geometry/body_discs.hpp"
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
  double linear_acceleration_max = 2.0;  ///< greatest change of linear speed [m/s^2], 0.01 to 1000
  double angular_acceleration_max =
      4.0;  ///< greatest change of angular speed [rad/s^2], 0.01 to 1000
};

/// The outline that must never touch anything.
[[nodiscard]] inline Footprint footprint_of(const RobotSettings& robot) noexcept {
  if (robot.discs.count > 0) return Footprint::discs(robot.discs.discs.data(), robot.discs.count);
  return robot.length > 0.0 && robot.width > 0.0 ? Footprint::rectangle(robot.length, robot.width)
                                                 : Footprint::disc(robot.radius);
}

/// The distance in which the robot stops from its greatest speed [m].
[[nodiscard]] inline double braking_distance(const RobotSettings& robot) noexcept {
  return 0.5 * robot.linear_max * robot.linear_max / robot.linear_acceleration_max;
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
}

}  // namespace fairway
