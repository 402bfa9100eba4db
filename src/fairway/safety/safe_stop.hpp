// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "fairway/safety/stop_check.hpp"

namespace fairway {

/// Where a robot is and what it is asked to be safe from, in one cycle.
struct StopSituation {
  Pose2 pose;
  Twist2 current;  ///< the last command, which the robot executes now
  CollisionEnvironment around;
  double hold = 0.0;  ///< how long ahead moving obstacles are kept out of the way of [s]
};

/// The way to a stand that every command leaves open, and what is done where there is none.
///
/// A command is proven by braking at once, or by following the plan that it is from for a while and
/// braking then: out of the way of something that comes, where standing still is no rescue. What
/// was proven last is kept, and executed when nothing new can be proven.
///
/// Where messages are late others only know that a robot brakes at once or a few cycles later: then
/// a command is proven by braking at once only, unless there is something that moves on its own.
class SafeStop {
 public:
  /// @param period  Time from one command to the next [s].
  SafeStop(const RobotSettings& robot, double period) : robot_(robot), period_(period) {}

  /// Forgets what was proven; falls back on braking from `actual`.
  void reset(const Twist2& actual) noexcept;

  /// Takes `commands[0]` if it can be proven with what follows it. Then that is fallen back on.
  [[nodiscard]] bool take(const StopSituation& situation,
                          std::span<const Twist2> commands) noexcept;

  /// When the way that is fallen back on touches something that moves [s from now]; infinite for
  /// never within `hold`. What stands was checked when it was taken.
  [[nodiscard]] double contact_time(const StopSituation& situation) const noexcept;

  /// Takes the way that touches something that moves last, if that is clearly later than `than`
  /// [s]: `commands`, or the hardest turns and runs that the limits allow. Never one that touches
  /// what stands.
  /// @return whether one was taken; its first command is then the next.
  [[nodiscard]] bool evade(const StopSituation& situation,
                           std::span<const Twist2> commands,
                           double than) noexcept;

  /// The next command of what is fallen back on.
  [[nodiscard]] Twist2 next() noexcept;

  [[nodiscard]] const StopSequence& sequence() const noexcept { return stop_; }
  [[nodiscard]] int done() const noexcept { return done_; }

 private:
  [[nodiscard]] StopSequence rest() const noexcept;

  RobotSettings robot_;
  double period_;
  StopSequence stop_;  // after the command that was sent
  int done_ = 0;       // commands of it that were sent
};

}  // namespace fairway
