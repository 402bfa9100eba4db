// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fairway/io/yaml/yaml_mapping.hpp"

namespace fairway::io {

/// Parses the only document in `text`, a mapping in UTF-8. Refuses aliases, because they can form
/// loops. After an error, which it reports in `file`, it returns an empty mapping.
[[nodiscard]] YamlMapping parse_yaml_mapping(YamlFile& file, const std::string& text);

}  // namespace fairway::io
