// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace fairway::app {

/// A clock that only moves forward [s].
[[nodiscard]] inline double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Measures from its construction on.
class Stopwatch {
 public:
  [[nodiscard]] double seconds() const { return steady_seconds() - start_; }

 private:
  double start_ = steady_seconds();
};

}  // namespace fairway::app
