// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <csignal>

namespace fairway::dds {

/// How often someone has wanted the program to end, by SIGINT or SIGTERM.
inline std::atomic<int> exits_wanted{0};
static_assert(std::atomic<int>::is_always_lock_free);  // as signal handlers need

inline void take_over_exit() {
  const auto count = [](int /*signal*/) { ++exits_wanted; };
  std::signal(SIGINT, count);
  std::signal(SIGTERM, count);
}

}  // namespace fairway::dds
