// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <ctime>

// Clocks for programs; the library reads none.
namespace fairway {

/// A clock that only moves forward [s].
[[nodiscard]] inline double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// CPU time that this thread has used [s]: unlike time on the wall it does not count other
/// programs.
[[nodiscard]] inline double thread_cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Measures from its construction on.
class Stopwatch {
 public:
  [[nodiscard]] double seconds() const { return steady_seconds() - start_; }

 private:
  double start_ = steady_seconds();
};

}  // namespace fairway
