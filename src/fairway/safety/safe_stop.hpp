// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "fairway/safety/stop_check.hpp"

namespace fairway {

/// The state of a robot in one cycle, and what it must not touch.
struct StopSituation {
  Pose2 pose;
  Twist2 current;  ///< of a slow base without delay and lag, now
  CollisionEnvironment around;
  double hold = 0.0;                        ///< look-ahead for moving obstacles [s]
  double longest_interval = 0.0;            ///< until the next command, if longer than usual [s]
  bool irregular = false;                   ///< whether cycles are noticeably early or late
  double shortest_interval = 0.0;           ///< between the last cycles, where irregular [s]
  const BaseResponse* response = nullptr;   ///< of the base now; null where it is at `current`
  const CommandHistory* history = nullptr;  ///< commands that the delay still holds back
  double time = 0.0;                        ///< now, in the times of the history [s]
};

/// Keeps a verified stop behind every command, and executes it when no new command can be proven.
///
/// A command is proven by braking at once, or by following its plan for a while and braking then.
/// The second lets a robot leave the path of an obstacle that approaches, where standstill does not
/// help. The manoeuvre that was proven last is kept, and executed when no new one can be proven. A
/// command is proven for every time until the next one from a period up to the longest interval.
///
/// Where messages are late, other robots only know that a robot brakes at once or a few cycles
/// later. A command is then proven by braking at once only, unless there is a moving obstacle
/// outside the fleet.
class SafeStop {
 public:
  /// @param period            Time from one command to the next [s].
  /// @param longest_interval  The longest such time that is covered [s]; 0: a period.
  SafeStop(const RobotSettings& robot, double period, double longest_interval = 0.0)
      : robot_(robot),
        actuation_(actuation_of(robot)),
        period_(period),
        longest_interval_(longest_interval),
        ramp_(period) {}

  /// Forgets what was proven; the fallback is then to brake from `actual`.
  void reset(const Twist2& actual) noexcept;

  /// A cycle begins `elapsed` [s] after the last one. The base will ramp to its command within
  /// `ramp` [s]. Without this call the cycles are a period apart.
  void begin_cycle(double elapsed, double ramp) noexcept;

  /// Takes `commands[0]` if it can be proven with the commands after it. That manoeuvre is then the
  /// fallback.
  [[nodiscard]] bool take(const StopSituation& situation,
                          std::span<const Twist2> commands) noexcept;

  /// Why the last commands given to `take` were not proven; Free if they were.
  [[nodiscard]] StopVerdict refusal() const noexcept { return refusal_; }

  /// Returns when the fallback touches a moving obstacle [s from now]; infinite if it does not
  /// within `hold`. Static obstacles were checked when it was taken. The margin of the proof does
  /// not count here.
  [[nodiscard]] double contact_time(const StopSituation& situation) const noexcept;

  /// Takes the manoeuvre that touches a moving obstacle last, if that is clearly later than `than`
  /// [s]. The candidates are `commands` and the hardest turns and runs that the limits allow,
  /// except those that touch a static obstacle. The margin from moving obstacles is kept where a
  /// manoeuvre can keep it.
  /// @return whether one was taken; its first command is then the next.
  [[nodiscard]] bool evade(const StopSituation& situation,
                           std::span<const Twist2> commands,
                           double than) noexcept;

  /// Returns the next command of the fallback.
  [[nodiscard]] Twist2 next() noexcept;

  [[nodiscard]] const StopSequence& sequence() const noexcept { return stop_; }
  [[nodiscard]] std::size_t done() const noexcept { return done_; }

 private:
  [[nodiscard]] StopManoeuvre manoeuvre(const StopSituation& situation,
                                        const Twist2& command,
                                        const StopSequence& stop) const noexcept;
  [[nodiscard]] StopVerdict prove(const StopSituation& situation,
                                  const Twist2& command,
                                  const StopSequence& stop) const noexcept;
  [[nodiscard]] double index() const noexcept;
  [[nodiscard]] Twist2 command_at(double index) const noexcept;

  RobotSettings robot_;
  BaseActuation actuation_;
  double period_;
  double longest_interval_;
  Twist2 first_;           // the command before those of stop_
  StopSequence stop_;      // one per period
  Twist2 last_;            // the command of the last cycle
  double elapsed_ = 0.0;   // from the last cycle to this one [s]
  double since_ = 0.0;     // the time since `first_` was sent [s]
  double ramp_;            // within which the base ramps to the command of this cycle [s]
  bool in_cycle_ = false;  // begun, and nothing taken yet
  std::size_t done_ = 0;   // commands of stop_ that were sent
  StopVerdict refusal_ = StopVerdict::Free;
};

}  // namespace fairway
