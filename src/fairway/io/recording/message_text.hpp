// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>

// How messages are written, whatever they tell.
namespace fairway::io {

// A cell of foxglove.Grid.
inline constexpr char kFreeCell = 0;
inline constexpr char kOccupiedCell = 100;
inline constexpr char kUnknownCell = static_cast<char>(255);

/// A time of a run as messages have it [ns]; what was before it is at its start.
[[nodiscard]] inline std::uint64_t nanoseconds(double time) {
  return static_cast<std::uint64_t>(std::llround(std::max(0.0, time) * 1e9));
}

/// JSON as text. Names come from people and may hold bytes that are not UTF-8: they are replaced.
[[nodiscard]] inline std::string dumped(const nlohmann::json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace fairway::io
