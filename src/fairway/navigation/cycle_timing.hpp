// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace fairway {

/// How a cycle lies in time.
enum class Punctuality : std::uint8_t {
  First,   ///< there was none before it
  OnTime,  ///< within the longest hold, or earlier than a period
  Late,    ///< later than the longest hold after the one before
  /// The time is not finite, not after that of the cycle before, or not in seconds. Times count as
  /// not in seconds if they are more than a hundred periods later for the second time in a row.
  Invalid,
};

/// The time of a cycle, seen from the one before.
struct CycleTiming {
  Punctuality punctuality = Punctuality::First;
  double elapsed = 0.0;  ///< since the cycle before, or a period where that is not known [s]
  double shift = 0.0;    ///< by which the clock was set, where it was [s]
};

/// Measures the time from one cycle to the next, whatever the clock of the caller does.
class CycleTimer {
 public:
  /// @param longest  Until when a cycle is on time [s].
  [[nodiscard]] CycleTiming next(double time, double period, double longest) noexcept {
    constexpr double kRounding = 1e-6;      // of a period; sums of periods are rounded
    constexpr double kMostPeriods = 100.0;  // of a pause; times in milliseconds have 1000
    CycleTiming timing{.elapsed = period};
    if (!std::isfinite(time)) {
      timing.punctuality = Punctuality::Invalid;
      last_ += period;  // a command is sent in this cycle too
      return timing;
    }
    if (began_) {
      const double elapsed = time - last_;
      if (!(elapsed > kRounding * period)) {
        timing.punctuality = Punctuality::Invalid;
        timing.shift = elapsed - period;
      } else {
        const bool late = elapsed > longest + kRounding * period;
        pauses_ = elapsed > kMostPeriods * period ? pauses_ + 1 : 0;
        timing.punctuality = pauses_ > 1 ? Punctuality::Invalid
                             : late      ? Punctuality::Late
                                         : Punctuality::OnTime;
        timing.elapsed = std::abs(elapsed - period) < kRounding * period ? period : elapsed;
      }
    }
    remember(timing, time, period, longest);
    began_ = true;
    last_ = time;
    return timing;
  }

  /// The longest interval of the last seconds that was not on time [s]; 0 for none.
  [[nodiscard]] double longest_late() const noexcept { return late_; }

  /// The shortest interval of the last seconds, or a period where none was shorter [s].
  [[nodiscard]] double shortest(double period) const noexcept {
    return irregular_ ? std::min(period, shortest_) : period;
  }

  /// Whether the cycles of the last seconds were noticeably earlier or later than a period.
  [[nodiscard]] bool irregular() const noexcept { return irregular_; }

 private:
  // Where one cycle was late or early the next one may be, too.
  void remember(const CycleTiming& timing, double time, double period, double longest) noexcept {
    constexpr double kMemory = 10.0;  // [s]
    constexpr double kMost = 3.0;     // [s]; more is a pause, after which the robot starts again
    constexpr double kNoticeable = 0.02;  // of a period
    if (timing.punctuality == Punctuality::Late && timing.elapsed <= std::max(kMost, longest)) {
      late_ = std::max(late_, timing.elapsed);
      late_at_ = time;
    }
    if (std::abs(timing.elapsed - period) > kNoticeable * period) {
      shortest_ = irregular_ ? std::min(shortest_, timing.elapsed) : timing.elapsed;
      irregular_ = true;
      irregular_at_ = time;
    }
    if (!(std::abs(time - late_at_) <= kMemory)) late_ = 0.0;
    if (!(std::abs(time - irregular_at_) <= kMemory)) irregular_ = false;
  }

  bool began_ = false;
  int pauses_ = 0;  // one after the other
  double last_ = 0.0;
  double late_ = 0.0;
  double late_at_ = 0.0;
  bool irregular_ = false;
  double irregular_at_ = 0.0;
  double shortest_ = 0.0;
};

}  // namespace fairway
