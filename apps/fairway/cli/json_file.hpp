// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/output.hpp"

namespace fairway::app {

/// Reads a result that a command wrote: a file with one JSON object.
[[nodiscard]] Expected<Json> read_json_object(const std::string& path);

}  // namespace fairway::app
