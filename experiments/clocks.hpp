// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <ctime>

// Clocks for programs; the library reads no clock.
namespace fairway {

/// A monotonic clock [s].
[[nodiscard]] inline double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// CPU time of this thread [s]; unlike wall-clock time it excludes other programs.
[[nodiscard]] inline double thread_cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Measures the time since its construction.
class Stopwatch {
 public:
  [[nodiscard]] double seconds() const { return steady_seconds() - start_; }

 private:
  double start_ = steady_seconds();
};

}  // namespace fairway
