// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/base/error.hpp"
#include "fairway/navigation/settings.hpp"

namespace fairway::io {

/// The settings of a preset: "default" or "paper"; none for another name.
[[nodiscard]] std::optional<Settings> preset_settings(std::string_view name);

/// Reads settings from YAML: a mapping per group, and `preset: paper|default` for settings that the
/// file omits (default: `base`). Checks types, ranges and the consistency of the groups; an unknown
/// group or key is an error. `name` is the file in messages.
///
/// Old names of settings are accepted until version 1.0. For each, a text "old (now new)" is added
/// to `warnings`, if given.
[[nodiscard]] Expected<Settings> parse_settings(const std::string& text,
                                                const std::string& name,
                                                const Settings& base = {},
                                                std::vector<std::string>* warnings = nullptr);

/// Does the same with a file.
[[nodiscard]] Expected<Settings> read_settings(const std::string& path,
                                               const Settings& base = {},
                                               std::vector<std::string>* warnings = nullptr);

/// Applies `group.name=value`, as given to `--set`. Checks type and range of this setting only;
/// call `validate` when all are set.
[[nodiscard]] Expected<void> assign_setting(Settings& settings,
                                            std::string_view assignment,
                                            std::vector<std::string>* warnings = nullptr);

/// A setting whose value is not that of other settings, with both values as files have them.
struct SettingDifference {
  std::string name;  ///< group.name
  std::string value;
  std::string other;
};

/// The settings in which `settings` differs from `other`, in the order of their groups.
[[nodiscard]] std::vector<SettingDifference> setting_differences(const Settings& settings,
                                                                 const Settings& other = {});

/// Which settings are printed: all, or only those to check for every robot.
enum class SettingsChoice : std::uint8_t { All, Essential };

/// Prints settings as YAML that `parse_settings` reads back. A comment gives the unit, meaning,
/// range and default of each.
[[nodiscard]] std::string settings_yaml(const Settings& settings,
                                        SettingsChoice choice = SettingsChoice::All);

/// The page docs/settings.md: a table per group with the values of both presets.
[[nodiscard]] std::string settings_markdown();

}  // namespace fairway::io
