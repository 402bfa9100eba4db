// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "fairway/base/error.hpp"
#include "fairway/geometry/body_shape.hpp"
#include "fairway/geometry/pose2.hpp"

namespace fairway {

/// Velocity in the plane, in the frame of the body. Its parts are the speed along the heading, to
/// the left of it, and the angular speed, counter-clockwise positive.
struct PlanarTwist {
  double linear = 0.0;   ///< along the heading [m/s]
  double lateral = 0.0;  ///< to the left [m/s]; 0 for every base but an omnidirectional one
  double angular = 0.0;  ///< [rad/s]
};

[[nodiscard]] inline bool is_finite(const PlanarTwist& twist) noexcept {
  return std::isfinite(twist.linear) && std::isfinite(twist.lateral) &&
         std::isfinite(twist.angular);
}

[[nodiscard]] inline PlanarTwist operator*(double factor, const PlanarTwist& twist) noexcept {
  return {factor * twist.linear, factor * twist.lateral, factor * twist.angular};
}

/// The pose after `duration` [s] of constant `twist` from `pose`, exact: an arc, a line, or a turn.
/// The heading is not wrapped.
[[nodiscard]] inline Pose2 moved(const Pose2& pose,
                                 const PlanarTwist& twist,
                                 double duration) noexcept {
  const double turn = twist.angular * duration;
  // sin(turn) / turn and (1 - cos(turn)) / turn; below 1e-4 the series is exact to 1e-17.
  const bool small = std::abs(turn) < 1e-4;
  const double a = small ? 1.0 - turn * turn / 6.0 : std::sin(turn) / turn;
  const double b = small ? 0.5 * turn : (1.0 - std::cos(turn)) / turn;
  const Eigen::Vector2d way(duration * (a * twist.linear - b * twist.lateral),
                            duration * (b * twist.linear + a * twist.lateral));
  return {.position = transform(pose, way), .heading = pose.heading + turn};
}

/// Returns the constant twist that leads from `from` to `to` in one second: the inverse of `moved`.
/// It turns by at most pi.
[[nodiscard]] PlanarTwist twist_between(const Pose2& from, const Pose2& to) noexcept;

/// Kind of a base: how it moves.
enum class BaseKind : std::uint8_t {
  Unicycle,  ///< drives along its heading and turns on the spot: two driven wheels
  Car,       ///< steers its front wheels and drives its rear axle; speed is that of the rear axle
  Tricycle,  ///< steers one front wheel, which may be driven; speed is that of the fixed axle
  Omni,      ///< moves to every side and turns: mecanum wheels or swerve modules
};

[[nodiscard]] constexpr const char* to_text(BaseKind kind) noexcept {
  switch (kind) {
    case BaseKind::Unicycle:
      return "unicycle";
    case BaseKind::Car:
      return "car";
    case BaseKind::Tricycle:
      return "tricycle";
    case BaseKind::Omni:
      return "omni";
  }
  return "unknown";
}

/// Which formula gives the speeds of the wheels.
enum class WheelKind : std::uint8_t {
  None,          ///< no limit by wheels
  Differential,  ///< |linear| + track / 2 |angular|
  Steered,       ///< hypot(linear, wheelbase angular): the driven, steered wheel of a tricycle
  Mecanum,       ///< |linear| + |lateral| + half_sum |angular|
  Swerve,        ///< hypot(linear - angular y, lateral + angular x) at every module (x, y)
};

/// The speeds that the wheels can reach.
struct WheelLimit {
  static constexpr int kMaxModules = 8;

  WheelKind kind = WheelKind::None;
  double speed_max = 0.0;  ///< of each wheel on the floor [m/s]
  double track = 0.0;      ///< Differential: distance between the wheels [m]
  double half_sum = 0.0;   ///< Mecanum: half of wheelbase plus track [m]
  int num_modules = 0;     ///< Swerve
  std::array<Eigen::Vector2d, kMaxModules> modules{};  ///< Swerve: places in the robot's frame [m]
};

/// Limits of a base. Values that do not apply to its kind are ignored.
struct BaseModel {
  BaseKind kind = BaseKind::Unicycle;
  double wheelbase = 1.0;            ///< Car, Tricycle: from fixed axle to steered wheel [m]
  double steering_max = 0.6;         ///< Car, Tricycle: greatest steering angle [rad], below pi / 2
  double steering_rate_max = 1.0;    ///< Car, Tricycle: its greatest rate [rad/s]
  double linear_min = -0.5;          ///< least linear speed [m/s]; negative allows reversing
  double linear_max = 1.0;           ///< greatest linear speed [m/s]
  double lateral_max = 0.5;          ///< Omni: greatest lateral speed to both sides [m/s]
  double angular_max = 1.0;          ///< greatest angular speed to both sides [rad/s]
  double linear_acceleration = 1.0;  ///< greatest change of linear speed [m/s^2]
  double lateral_acceleration = 1.0;  ///< Omni: of lateral speed [m/s^2]
  double angular_acceleration = 2.0;  ///< of angular speed [rad/s^2]
  WheelLimit wheels;
  double response_time = 0.0;  ///< until the base follows an input that changes [s], 0 to 1
};

/// Whether every value that applies is finite and in its range.
[[nodiscard]] Expected<void> validate(const BaseModel& base);

/// Whether it turns only while it drives, by a steered wheel.
[[nodiscard]] constexpr bool is_steered(const BaseModel& base) noexcept {
  return base.kind == BaseKind::Car || base.kind == BaseKind::Tricycle;
}

/// Greatest curvature of a steered base: tan(steering_max) / wheelbase [1/m].
[[nodiscard]] double greatest_curvature(const BaseModel& base) noexcept;

/// The speed of the fastest wheel over its limit; 0 without limit.
[[nodiscard]] double wheel_load(const BaseModel& base, const PlanarTwist& twist) noexcept;

/// Returns the share of the base's limits that a twist uses: 1 at the first speed limit, wheels
/// included. It is infinite for a twist that the base cannot drive at any speed. It is proportional
/// to the twist, so a motion of direction `twist` per unit takes at least `speed_load` seconds per
/// unit.
[[nodiscard]] double speed_load(const BaseModel& base, const PlanarTwist& twist) noexcept;

/// A robot with its true outline and its own kind of base.
struct RobotModel {
  BodyShape body = BodyShape::rectangle(1.0, 0.5, 0.5);
  BaseModel base;
};

}  // namespace fairway
