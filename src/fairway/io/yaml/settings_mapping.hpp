// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/io/yaml/yaml_mapping.hpp"
#include "fairway/navigation/settings.hpp"

namespace fairway::io {

/// Reads the groups of settings that a mapping holds over `base`; complains in its file. Does not
/// check that the groups agree.
[[nodiscard]] Settings read_settings_mapping(YamlMapping& mapping, const Settings& base);

/// `validate`, with the complaint moved to the line of the key that it names.
void complain_unless_valid(const Settings& settings, YamlMapping& mapping);

}  // namespace fairway::io
