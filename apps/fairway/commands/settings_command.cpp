// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "cli/output.hpp"
#include "cli/settings_options.hpp"
#include "commands/commands.hpp"
#include "fairway/io/yaml/settings_file.hpp"

namespace fairway::app {

namespace {

struct SettingsCommand {
  SettingsOptions settings;
  bool markdown = false;
  bool essential = false;

  [[nodiscard]] Expected<int> run() const {
    const Expected<Settings> loaded = load_settings(settings);
    if (!loaded) return tl::unexpected(loaded.error());
    if (const auto valid = validate(*loaded); !valid) return tl::unexpected(valid.error());
    const auto choice = essential ? io::SettingsChoice::Essential : io::SettingsChoice::All;
    const auto printed =
        print(markdown ? io::settings_markdown() : io::settings_yaml(*loaded, choice));
    if (!printed) return tl::unexpected(printed.error());
    return kDone;
  }
};

}  // namespace

void add_settings_command(CommandLine& tool) {
  const auto command = std::make_shared<SettingsCommand>();
  const Options options =
      tool.add_command("settings", "Print every setting as YAML that --settings reads back",
                       [command] { return command->run(); });
  add_settings_options(options, command->settings);
  options.add_flag("--essential", command->essential,
                   "Print only the settings that every user must check for the robot");
  options.add_flag("--markdown", command->markdown, "Print the page docs/settings.md instead");
}

}  // namespace fairway::app
