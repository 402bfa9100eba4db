// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>

// The text format that all messages share.
namespace fairway::io {

// A cell of foxglove.Grid.
inline constexpr char kFreeCell = 0;
inline constexpr char kOccupiedCell = 100;
inline constexpr char kUnknownCell = static_cast<char>(255);

/// Converts a run's time to a message's time [ns]; times before the start become the start.
[[nodiscard]] inline std::uint64_t nanoseconds(double time) {
  return static_cast<std::uint64_t>(std::llround(std::max(0.0, time) * 1e9));
}

/// Serialises JSON. Bytes of names that are not UTF-8 are replaced.
[[nodiscard]] inline std::string dumped(const nlohmann::json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace fairway::io
