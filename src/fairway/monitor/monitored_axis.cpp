// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "fairway/monitor/safety_monitor.hpp"

namespace fairway {

namespace {

constexpr double kDue = 1e-9;  // [s]

// Towards `wanted`, first down to zero where it lies on the other side.
double changed(double speed, double wanted, double gain, double loss, double time) noexcept {
  const double kept = speed * wanted > 0.0 ? wanted : 0.0;
  if (std::abs(kept) < std::abs(speed)) {
    const double needed = std::abs(speed - kept) / loss;
    if (needed >= time) return speed - std::copysign(loss * time, speed);
    speed = kept;
    time -= needed;
  }
  return speed + std::clamp(wanted - speed, -gain * time, gain * time);
}

double time_to_change(double from, double to, double gain, double loss) noexcept {
  const double kept = from * to > 0.0 ? to : 0.0;
  return std::abs(kept) < std::abs(from) ? std::abs(from - kept) / loss + std::abs(kept - to) / gain
                                         : std::abs(to - from) / gain;
}

}  // namespace

MonitoredAxis linear_axis(const MonitorSettings& s) noexcept {
  return {.part = &Twist2::linear,
          .gain = s.linear_acceleration,
          .loss = s.linear_braking > 0.0 ? s.linear_braking : s.linear_acceleration,
          .delay = s.delay,
          .lag = s.linear_lag,
          .ramp = s.ramp};
}

MonitoredAxis angular_axis(const MonitorSettings& s) noexcept {
  return {.part = &Twist2::angular,
          .gain = s.angular_acceleration,
          .loss = s.angular_braking > 0.0 ? s.angular_braking : s.angular_acceleration,
          .delay = s.angular_delay.value_or(s.delay),
          .lag = s.angular_lag,
          .ramp = s.ramp};
}

void MonitoredAxis::begin(double speed) noexcept {
  command = ramped = slow = quick = speed;
  rate = 0.0;
}

// Takes the command that has come through by `time`. @return how long it stays in force [s].
double MonitoredAxis::obey(std::span<const SentCommand> queue, double time) noexcept {
  const auto due = [&](const SentCommand& sent) { return sent.time + delay - time; };
  const auto next =
      std::ranges::find_if(queue, [&](const SentCommand& s) { return due(s) > kDue; });
  const double wanted = next == queue.begin() ? command : std::prev(next)->command.*part;
  if (wanted != command) {
    rate = std::abs(wanted - ramped) /
           std::max({ramp, time_to_change(ramped, wanted, gain, loss), kDue});
    command = wanted;
  }
  return next == queue.end() ? std::numeric_limits<double>::infinity() : due(*next);
}

// The quick member has the whole command at once, the slow one a ramp to it; both with the lag.
void MonitoredAxis::advance(double time) noexcept {
  const double share = lag > 0.0 ? -std::expm1(-time / lag) : 1.0;
  const double before = ramped;
  ramped += std::clamp(command - ramped, -rate * time, rate * time);
  slow = lag > 0.0 ? slow + share * (0.5 * (before + ramped) - slow) : ramped;
  quick = changed(quick, quick + share * (command - quick), gain, loss, time);
}

double MonitoredAxis::fastest() const noexcept {
  return std::max({std::abs(command), std::abs(slow), std::abs(quick)});
}

}  // namespace fairway
