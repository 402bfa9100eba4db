// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ctime>

namespace fairway::app {

/// CPU time that this thread has used [us]: unlike time on the wall it does not count other
/// programs.
[[nodiscard]] inline double thread_cpu_us() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

}  // namespace fairway::app
