// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace fairway::app {

/// Objects keep the order in which their fields are written.
using Json = nlohmann::ordered_json;

/// `json` as text that a person can read too: rows of numbers stay on one line.
[[nodiscard]] std::string json_text(const Json& json);

}  // namespace fairway::app
