// SPDX-License-Identifier: Apache-2.0
#include "cli/settings_options.hpp"

#include <fmt/core.h>

#include "cli/output.hpp"
#include "fairway/io/maps/map_file.hpp"
#include "fairway/io/number_text.hpp"
#include "fairway/io/scenario/scenario_file.hpp"
#include "fairway/io/yaml/settings_file.hpp"

namespace fairway::app {

void add_settings_options(const Options& options, SettingsOptions& chosen) {
  options.add("--preset", chosen.preset, "Start from 'default' or 'paper' (Table I)");
  options.add("--settings", chosen.file, "Read settings from a YAML file").type_name("FILE.yaml");
  options
      .add("--set", chosen.assignments,
           "Set one setting, e.g. robot.radius=0.3; may be given several times")
      .type_name("GROUP.NAME=VALUE")
      .one_at_a_time();
}

Expected<Settings> load_settings(const SettingsOptions& options, const Settings& base) {
  Settings settings = base;
  io::FileNotes notes;
  if (!options.preset.empty()) {
    const std::optional<Settings> preset = io::preset_settings(options.preset);
    if (!preset) {
      return fail(fmt::format("--preset: expected default or paper, found {}",
                              io::excerpt(options.preset)));
    }
    settings = *preset;
  }
  if (!options.file.empty()) {
    notes.files.push_back(options.file);
    const Expected<Settings> read = io::read_settings(options.file, settings, &notes.old_names);
    if (!read) return read;
    settings = *read;
  }
  for (const std::string& assignment : options.assignments) {
    if (const Expected<void> done = io::assign_setting(settings, assignment, &notes.old_names);
        !done) {
      return fail(fmt::format("--set: {}", done.error().message));
    }
  }
  note(notes);
  return settings;
}

Expected<Scenario> load_scenario(const std::string& path) {
  io::FileNotes notes;
  Expected<Scenario> scenario = io::read_scenario(path, &notes);
  note(notes);
  return scenario;
}

Expected<OccupancyGrid> load_map(const std::string& path) {
  io::FileNotes notes;
  Expected<OccupancyGrid> map = io::read_map(path, &notes);
  note(notes);
  return map;
}

}  // namespace fairway::app
