// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/io/yaml/yaml_mapping.hpp"
#include "fairway/navigation/settings.hpp"

namespace fairway::io {

/// Reads the groups of settings in a mapping over `base`, and reports errors in its file. Does not
/// check the consistency of the groups.
[[nodiscard]] Settings read_settings_mapping(YamlMapping& mapping, const Settings& base);

/// Calls `validate`, and reports an error at the line of the key that it names.
void complain_unless_valid(const Settings& settings, YamlMapping& mapping);

}  // namespace fairway::io
