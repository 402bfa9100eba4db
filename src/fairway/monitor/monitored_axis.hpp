// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "fairway/geometry/pose2.hpp"

namespace fairway {

struct MonitorSettings;

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

}  // namespace fairway
