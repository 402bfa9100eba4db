// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace fairway::io {

/// A JSON Schema for one of Fairway's own messages: "fairway.Scenario", ".Navigators", ".Cells",
/// ".World", ".Goal", ".Scan", ".Plan" or ".Cycle". It lists the fields that can be plotted;
/// messages have more.
/// @pre the name is one of these.
[[nodiscard]] std::string fairway_schema(const std::string& name);

}  // namespace fairway::io
