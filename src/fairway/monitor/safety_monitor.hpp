// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fairway/base/error.hpp"
#include "fairway/geometry/pose2.hpp"

namespace fairway {

using Polygon = std::vector<Eigen::Vector2d>;  ///< simple, in the robot's frame [m]

/// What the monitor knows about the robot, and what it guards.
struct MonitorSettings {
  std::vector<Polygon> footprint{};   ///< the body is their union
  Polygon stop_zone{};                ///< a point in here stops the robot; empty: none
  Polygon slow_zone{};                ///< a point in here slows it down; empty: none
  double slow_speed = 0.3;            ///< greatest linear speed then [m/s], 0.01 to 10
  double linear_acceleration = 1.0;   ///< with which the base changes its speed [m/s^2], 0.2 to 20
  double angular_acceleration = 2.0;  ///< [rad/s^2], 0.2 to 100
  double delay = 0.0;                 ///< until the base follows a command [s], 0 to 1
  double hold = 0.15;                 ///< longest time between two commands [s], 0.01 to 1
  double margin = 0.01;               ///< least distance to a point [m], 0 to 1
  double max_age = 0.5;               ///< oldest points to drive on [s], 0.01 to 10
};

/// Whether all numbers are in their ranges, and all polygons can be one.
[[nodiscard]] Expected<void> validate(const MonitorSettings& settings);

/// Why the monitor changed a command.
enum class MonitorReason : std::uint8_t { None, InvalidInput, Stale, StopZone, SlowZone, Obstacle };

struct MonitorVerdict {
  Twist2 command;         ///< `fraction` of the one that was asked for
  double fraction = 0.0;  ///< 0 to 1
  MonitorReason reason = MonitorReason::None;
};

/// The last check before the base: it shares no code with the navigator, its maps or its proofs.
///
/// It simulates the delay, the command while it is in force, and braking of both axes. A command
/// passes if no point comes nearer than the margin, else the largest of 32 fractions that passes.
/// A point that is nearer already must not come nearer. `check` and `see` do not allocate.
class SafetyMonitor {
 public:
  static constexpr std::size_t kMostPoints = 8192;
  /// @throws std::invalid_argument unless validate(settings) holds.
  explicit SafetyMonitor(MonitorSettings settings);

  /// Takes in the newest obstacle points, in the frame of the poses. More than kMostPoints, or one
  /// that is not finite, are refused, and the older ones stay.
  bool see(double time, std::span<const Eigen::Vector2d> points) noexcept;

  /// @param current  The twist of the base at `time`, as far as it is known: the last command.
  [[nodiscard]] MonitorVerdict check(double time,
                                     const Pose2& pose,
                                     const Twist2& current,
                                     const Twist2& command) noexcept;

 private:
  struct NearPoint {
    Eigen::Vector2d position;  // in the robot's frame [m]
    double least;              // distance that it must keep [m]
  };

  [[nodiscard]] double distance(const Eigen::Vector2d& point) const noexcept;
  [[nodiscard]] bool stops_in_time(Twist2 twist, const Twist2& command) const noexcept;

  MonitorSettings settings_;
  double radius_ = 0.0;  // of the body about its origin [m]
  double time_;
  std::vector<Eigen::Vector2d> points_;
  std::vector<NearPoint> near_;
};

}  // namespace fairway
