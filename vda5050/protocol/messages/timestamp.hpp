// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fairway::vda5050 {

/// Writes a time as ISO 8601 in UTC with milliseconds, `2026-11-30T08:00:00.000Z`.
/// @param seconds  Since 1970-01-01 in UTC. A time outside the years 1970 to 9999 is clamped.
[[nodiscard]] std::string to_timestamp(double seconds);

/// Reads a time of ISO 8601 with any number of decimals, and `Z` or an offset.
/// @return seconds since 1970-01-01 in UTC; none for any other text.
[[nodiscard]] std::optional<double> from_timestamp(std::string_view text);

}  // namespace fairway::vda5050
