// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace fairway::io {

/// A JSON Schema for one of our own messages: "fairway.Scenario", ".Navigators", ".Cells",
/// ".World", ".Goal", ".Scan", ".Plan" or ".Cycle". It names what can be plotted; what it leaves
/// out is still there.
/// @pre the name is one of these.
[[nodiscard]] std::string fairway_schema(const std::string& name);

}  // namespace fairway::io
