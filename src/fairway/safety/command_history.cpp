// SPDX-License-Identifier: Apache-2.0
#include "fairway/safety/command_history.hpp"

#include <algorithm>
#include <limits>

namespace fairway {

namespace {

constexpr double kSameTime = 1e-9;  // [s]

double ramp_value(double from, double to, double elapsed, double ramp) noexcept {
  const double share = std::clamp(elapsed / ramp, 0.0, 1.0);
  return from + share * (to - from);
}

}  // namespace

void CommandHistory::reset(const Twist2& actual) noexcept {
  count_ = 0;
  latest_ = actual;
}

void CommandHistory::send(double time, const Twist2& command, const Twist2& ramp) noexcept {
  const Twist2 before = reached(time);
  commands_[count_++ % kRemembered] = {
      .time = time, .ramp = ramp, .before = before, .after = command};
  latest_ = command;
}

void CommandHistory::replace_last(const Twist2& command, const Twist2& ramp) noexcept {
  latest_ = command;
  if (count_ == 0) return;
  Command& last = commands_[(count_ - 1) % kRemembered];
  last.after = command;
  last.ramp = ramp;
}

// Of the commands in the ring the newest that was sent by then, or the oldest; null for none.
const CommandHistory::Command* CommandHistory::command_at(double time) const noexcept {
  const std::size_t kept = std::min(count_, kRemembered);
  for (std::size_t n = 1; n <= kept; ++n) {
    const Command& command = back(n);
    if (command.time <= time + kSameTime || n == kept) return &command;
  }
  return nullptr;
}

Twist2 CommandHistory::ramped(double time) const noexcept {
  const Command* command = command_at(time);
  if (command == nullptr) return latest_;
  const double elapsed = time - command->time;
  return {.linear = ramp_value(command->before.linear, command->after.linear, elapsed,
                               command->ramp.linear),
          .angular = ramp_value(command->before.angular, command->after.angular, elapsed,
                                command->ramp.angular)};
}

Twist2 CommandHistory::reached(double time) const noexcept {
  if (count_ == 0) return latest_;
  const double elapsed = time - back(1).time + kSameTime;
  const Twist2 now = ramped(time);
  return {.linear = elapsed >= back(1).ramp.linear ? latest_.linear : now.linear,
          .angular = elapsed >= back(1).ramp.angular ? latest_.angular : now.angular};
}

Twist2 CommandHistory::sent(double time) const noexcept {
  const Command* command = command_at(time);
  if (command == nullptr) return latest_;
  return command->time <= time + kSameTime ? command->after : command->before;
}

double CommandHistory::next_change(double time) const noexcept {
  const std::size_t kept = std::min(count_, kRemembered);
  double next = std::numeric_limits<double>::infinity();
  for (std::size_t n = 1; n <= kept && back(n).time > time + kSameTime; ++n)
    next = back(n).time;
  return next;
}

void CommandHistory::shift_times(double shift) noexcept {
  for (Command& command : commands_)
    command.time += shift;
}

}  // namespace fairway
