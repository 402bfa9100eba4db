// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/geometry/pose2.hpp"

namespace fairway {

/// Keeps the commands of the last seconds. A delayed base still has to execute the newest of them,
/// and an old pose is advanced along them.
class CommandHistory {
 public:
  /// Forgets everything; the base is assumed to have moved with `actual` until now.
  void reset(const Twist2& actual) noexcept;

  /// Records a command sent at `time` [s]. A base that ramps to it reaches it within `ramp.linear`
  /// and `ramp.angular` [s].
  void send(double time, const Twist2& command, const Twist2& ramp) noexcept;

  /// Replaces the newest command, where another one was sent in its place.
  void replace_last(const Twist2& command, const Twist2& ramp) noexcept;

  /// Returns the twist of a base without delay that ramps linearly to each command, at `time` [s].
  [[nodiscard]] Twist2 ramped(double time) const noexcept;

  /// As above, for a `time` not before the newest command: exactly that command once its ramp is
  /// over.
  [[nodiscard]] Twist2 reached(double time) const noexcept;

  /// Returns the newest command that was sent at or before `time` [s].
  [[nodiscard]] Twist2 sent(double time) const noexcept;

  /// Returns when the first command after `time` was sent [s]; infinite where there is none.
  [[nodiscard]] double next_change(double time) const noexcept;

  /// Moves every stored time by `shift` [s], after the clock was set.
  void shift_times(double shift) noexcept;

  [[nodiscard]] const Twist2& latest() const noexcept { return latest_; }

 private:
  // Enough for a delay of 0.6 s, a lag of 1 s and poses 0.2 s old, with a command every 10 ms.
  static constexpr std::size_t kRemembered = 192;

  struct Command {
    double time = 0.0;
    Twist2 ramp{.linear = 0.1, .angular = 0.1};
    Twist2 before;
    Twist2 after;
  };

  [[nodiscard]] const Command* command_at(double time) const noexcept;
  [[nodiscard]] const Command& back(std::size_t n) const noexcept {
    return commands_[(count_ - n) % kRemembered];
  }

  std::array<Command, kRemembered> commands_;  // a ring
  std::size_t count_ = 0;                      // ever sent
  Twist2 latest_;
};

}  // namespace fairway
