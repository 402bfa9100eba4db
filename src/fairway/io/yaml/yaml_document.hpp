// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fairway/io/yaml/yaml_mapping.hpp"

namespace fairway::io {

/// Parses the one document in `text`, a mapping in UTF-8. Refuses aliases: they make loops of
/// nodes. Complains in `file` and returns an empty mapping when that fails.
[[nodiscard]] YamlMapping parse_yaml_mapping(YamlFile& file, const std::string& text);

}  // namespace fairway::io
