// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "fairway/base/error.hpp"
#include "fairway/navigation/settings.hpp"
#include "fairway/simulation/scenario.hpp"

namespace fairway::app {

/// The options --preset, --settings and --set, which all commands with settings have.
struct SettingsOptions {
  std::string preset;
  std::string file;
  std::vector<std::string> assignments;
};

void add_settings_options(const Options& options, SettingsOptions& chosen);

/// The settings that the options select: preset, then file, then assignments over `base`. Checks
/// that each setting exists and lies in its range. The command calls `validate` for their
/// consistency, after its own changes.
[[nodiscard]] Expected<Settings> load_settings(const SettingsOptions& options,
                                               const Settings& base = {});

/// Reads a scenario like `io::read_scenario`.
[[nodiscard]] Expected<Scenario> load_scenario(const std::string& path);

/// Reads a map, as `io::read_map` does, and keeps its warnings.
[[nodiscard]] Expected<OccupancyGrid> load_map(const std::string& path);

}  // namespace fairway::app
