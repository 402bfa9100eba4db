// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace fairway::nav2 {

/// Converts builtin_interfaces/Time to seconds.
template <typename Stamp>
[[nodiscard]] double seconds_of(const Stamp& stamp) noexcept {
  return static_cast<double>(stamp.sec) + 1e-9 * static_cast<double>(stamp.nanosec);
}

}  // namespace fairway::nav2
