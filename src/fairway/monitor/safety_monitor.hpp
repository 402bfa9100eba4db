// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fairway/geometry/pose2.hpp"
#include "fairway/monitor/monitor_settings.hpp"

namespace fairway {

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
