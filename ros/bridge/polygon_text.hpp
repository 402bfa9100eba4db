// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "fairway/monitor/safety_monitor.hpp"

namespace fairway::bridge {

/// Reads a polygon from a parameter, as "[[0.4, -0.3], [1.0, -0.3], [1.0, 0.3]]": the form of
/// Nav2's footprints. An empty text, or "[]", is no polygon.
/// @param name  Of the parameter, for the error.
[[nodiscard]] Expected<Polygon> polygon_of(const std::string& name, std::string_view text);

}  // namespace fairway::bridge
