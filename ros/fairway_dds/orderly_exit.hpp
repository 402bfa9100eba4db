// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <csignal>

namespace fairway::dds {

/// How often SIGINT or SIGTERM has requested the end of the program.
inline std::atomic<int> exits_wanted{0};
static_assert(std::atomic<int>::is_always_lock_free);  // signal handlers need this

inline void take_over_exit() {
  const auto count = [](int /*signal*/) { ++exits_wanted; };
  std::signal(SIGINT, count);
  std::signal(SIGTERM, count);
}

}  // namespace fairway::dds
