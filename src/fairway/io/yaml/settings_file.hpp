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

/// The settings that a preset's name stands for: "default" or "paper"; none for another name.
[[nodiscard]] std::optional<Settings> preset_settings(std::string_view name);

/// Reads settings from YAML: a mapping per group, and `preset: paper|default` for what the groups
/// leave out (without it, `base`). Checks types, ranges and that the groups agree; a group or key
/// that does not exist is an error. `name` is the file in messages.
///
/// Old names of settings are accepted until version 1.0; `warnings`, if given, gets a text
/// "old (now new)" for each.
[[nodiscard]] Expected<Settings> parse_settings(const std::string& text,
                                                const std::string& name,
                                                const Settings& base = {},
                                                std::vector<std::string>* warnings = nullptr);

/// The same, from a file.
[[nodiscard]] Expected<Settings> read_settings(const std::string& path,
                                               const Settings& base = {},
                                               std::vector<std::string>* warnings = nullptr);

/// Carries out `group.name=value`, as given to `--set`. Checks type and range of this one, not
/// whether the groups agree: that is `validate`, when all are set.
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

/// Which settings are printed: all, or those that every user has to check.
enum class SettingsChoice : std::uint8_t { All, Essential };

/// Settings as YAML that `parse_settings` turns back into the same values, with unit, meaning,
/// range and default of each in a comment.
[[nodiscard]] std::string settings_yaml(const Settings& settings,
                                        SettingsChoice choice = SettingsChoice::All);

/// The page docs/settings.md: a table per group, with the values of both presets.
[[nodiscard]] std::string settings_markdown();

}  // namespace fairway::io
