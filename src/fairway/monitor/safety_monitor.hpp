// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
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
  double linear_acceleration = 1.0;   ///< greatest gain of speed [m/s^2], 0.01 to 1000
  double angular_acceleration = 2.0;  ///< [rad/s^2], 0.01 to 1000
  double linear_braking = 0.0;        ///< greatest loss of speed [m/s^2], 0 to 1000; 0: as the gain
  double angular_braking = 0.0;       ///< [rad/s^2], 0 to 1000; 0: as the gain
  double delay = 0.0;                 ///< until the base begins to follow a command [s], 0 to 6
  std::optional<double> angular_delay{};  ///< of turns, where it differs [s], 0 to 6
  double linear_lag = 0.0;                ///< time constant with which it then follows [s], 0 to 1
  double angular_lag = 0.0;               ///< [s], 0 to 1
  double ramp = 0.0;     ///< in which it may ramp to a command, where that is longer than its
                         ///< limits need [s], 0 to 1
  double hold = 0.15;    ///< longest time between two commands [s], 0.001 to 20
  double margin = 0.01;  ///< least distance to a point [m], 0 to 1
  double max_age = 0.5;  ///< oldest points to drive on [s], 0.01 to 1000
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

/// A command that was sent to the base.
struct SentCommand {
  double time = 0.0;  ///< [s]
  Twist2 command;
};

/// One speed of the base: of one that changes it as hard as it can, and of one that ramps to each
/// command. Both have the delay and the lag.
struct MonitoredAxis {
  double Twist2::*part = &Twist2::linear;
  double gain = 1.0;   ///< greatest, of a speed that grows [m/s^2, rad/s^2]
  double loss = 1.0;   ///< greatest, of a speed that shrinks
  double delay = 0.0;  ///< [s]
  double lag = 0.0;    ///< [s]
  double ramp = 0.0;   ///< shortest, of the slow base [s]

  double command = 0.0;  ///< in force
  double rate = 0.0;     ///< with which the slow base ramps to it
  double ramped = 0.0;   ///< the slow base without its lag
  double slow = 0.0;
  double quick = 0.0;

  /// Both bases move with `speed`, which they were sent long ago.
  void begin(double speed) noexcept;

  /// Takes the newest command of `queue` that has come through by `time`.
  /// @return how long it stays in force [s].
  [[nodiscard]] double obey(std::span<const SentCommand> queue, double time) noexcept;

  /// Follows the command for `time` [s].
  void advance(double time) noexcept;

  /// The greatest of the speeds and the command, without sign.
  [[nodiscard]] double fastest() const noexcept;
};

[[nodiscard]] MonitoredAxis linear_axis(const MonitorSettings& settings) noexcept;
[[nodiscard]] MonitoredAxis angular_axis(const MonitorSettings& settings) noexcept;

/// The last check before the base: it shares no code with the navigator, its maps or its proofs.
///
/// It simulates the commands that the delay still holds back, the new command while it is in force,
/// and braking of both axes. Four bases are simulated: each axis changes its speed as hard as it
/// can, or ramps. A command passes if no point comes nearer than the margin to any of them, else
/// the largest of 32 fractions that passes. A point that is nearer already must not come nearer.
/// `check` and `see` do not allocate.
class SafetyMonitor {
 public:
  static constexpr std::size_t kMostPoints = 8192;
  /// @throws std::invalid_argument unless validate(settings) holds.
  explicit SafetyMonitor(MonitorSettings settings);

  /// Takes in the newest obstacle points, in the frame of the poses. More than kMostPoints, or one
  /// that is not finite, are refused, and the older ones stay.
  bool see(double time, std::span<const Eigen::Vector2d> points) noexcept;

  /// Call it for every command, because the monitor remembers what the base has still to execute.
  /// @param current  The command that was sent in the cycle before. At first and after a pause of
  ///                 10 s: the twist of the base.
  [[nodiscard]] MonitorVerdict check(double time,
                                     const Pose2& pose,
                                     const Twist2& current,
                                     const Twist2& command) noexcept;

  /// Forgets the commands on their way; the base moves with the `current` of the next check.
  void reset() noexcept { time_of_check_ = -std::numeric_limits<double>::infinity(); }

 private:
  struct NearPoint {
    Eigen::Vector2d position;  // in the robot's frame [m]
    double least;              // distance that it must keep [m]
  };

  [[nodiscard]] double distance(const Eigen::Vector2d& point) const noexcept;
  void follow(double time, const Twist2& sent) noexcept;
  [[nodiscard]] double reach(const Twist2& command) const noexcept;
  [[nodiscard]] bool stops_in_time(const Twist2& command) noexcept;
  [[nodiscard]] double clearance(const Pose2& base) const noexcept;

  MonitorSettings settings_;
  double radius_ = 0.0;  // of the body about its origin [m]
  double time_;          // of the points [s]
  double time_of_check_ = -std::numeric_limits<double>::infinity();  // [s]
  double now_ = 0.0;  // as time_of_check_, without its jumps [s]
  MonitoredAxis linear_;
  MonitoredAxis angular_;
  std::vector<SentCommand> sent_;   // commands that may still be on their way, the oldest first
  std::vector<SentCommand> queue_;  // the same, with the new one and the stop after it
  std::vector<Eigen::Vector2d> points_;
  std::vector<NearPoint> near_;
};

}  // namespace fairway
