// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/geometry/robot_settings.hpp"
#include "fairway/safety/command_history.hpp"

namespace fairway {

/// Advances poses along the commands of the last cycles. It moves a slightly old pose to now, and
/// decides whether a new pose fits the one before.
class DeadReckoning {
 public:
  DeadReckoning() = default;

  /// For a base with the delays and lags of `robot`; a lag counts as a delay.
  explicit DeadReckoning(const RobotSettings& robot)
      : linear_shift_(robot.linear_delay + robot.linear_lag),
        angular_shift_(robot.angular_delay + robot.angular_lag) {}

  /// Forgets everything; the robot is assumed to move with `actual`.
  void reset(const Twist2& actual) noexcept;

  /// Records a command sent at `time` [s]; the base ramps to it within `dt` [s].
  void sent(double time, const Twist2& command, double dt) noexcept {
    sent(time, command, {.linear = dt, .angular = dt});
  }
  void sent(double time, const Twist2& command, const Twist2& ramp) noexcept;

  /// Another command was sent in place of the newest one.
  void replace_last(const Twist2& command, const Twist2& ramp) noexcept {
    history_.replace_last(command, ramp);
  }

  /// Continues with the commands and poses of an older one, whose robot may have had other delays.
  void continue_from(const DeadReckoning& older) noexcept {
    history_ = older.history_;
    last_ = older.last_;
    other_ = older.other_;
  }

  /// The clock was set by `shift` [s]: what was known is as old as before.
  void shift_times(double shift) noexcept;

  [[nodiscard]] const CommandHistory& history() const noexcept { return history_; }

  /// Returns where a robot that was at `pose` at `from` is at `to` [s]; `pose` itself when from >=
  /// to.
  [[nodiscard]] Pose2 advanced(const Pose2& pose, double from, double to) const noexcept;

  /// Takes in a pose that was true at `time` [s].
  ///
  /// The pose fits when it is near the place to which the last fitting pose leads. Near means
  /// within `tolerance` [m] and half of the distance driven since; the first pose fits. Poses that
  /// agree among themselves for half a second fit again once the robot has stopped: then the map
  /// was wrong before, or the robot was carried.
  [[nodiscard]] bool fits(const Pose2& pose, double time, double tolerance) noexcept;

 private:
  struct Known {
    bool exists = false;
    double since = 0.0;
    double time = 0.0;
    Pose2 pose;
  };

  [[nodiscard]] Twist2 twist_at(double time) const noexcept;
  [[nodiscard]] bool agree(const Known& last,
                           const Pose2& pose,
                           double time,
                           double tolerance) const noexcept;

  CommandHistory history_;
  double linear_shift_ = 0.0;   // by which the base is late [s]
  double angular_shift_ = 0.0;  // the same for its turns [s]
  Known last_;
  Known other_;  // what does not fit, but perhaps itself
};

}  // namespace fairway
