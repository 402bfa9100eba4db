// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/yaml/settings_file.hpp"

#include <array>

#include <fmt/core.h>

#include "fairway/io/whole_file.hpp"
#include "fairway/io/yaml/setting_text.hpp"
#include "fairway/io/yaml/settings_mapping.hpp"
#include "fairway/io/yaml/yaml_document.hpp"
#include "fairway/navigation/settings.hpp"

namespace fairway::io {

namespace {

constexpr std::size_t kLongestSettings = 1U << 20;  // [bytes]
constexpr std::array<const char*, 2> kPresets{"default", "paper"};

constexpr const char* kAllHead =
    "# Every setting of Fairway. After each value: [unit] meaning (what is allowed; default).\n"
    "# A file needs only the settings that it changes. With `preset: paper` as its first line, it\n"
    "# takes all other settings from the paper.\n";
constexpr const char* kEssentialHead =
    "# Settings to check for every robot. After each value: [unit] meaning (what is allowed; "
    "default).\n"
    "# `fairway settings` prints every setting.\n";

// Formats a list for YAML, in one line or with one disc per line.
void read_discs(YamlMapping& mapping, const char* key, BodyDiscs& discs) {
  BodyDiscs read;
  for (const std::vector<double>& row : mapping.rows(key, 3)) {
    if (read.add({row[0], row[1]}, row[2])) continue;
    mapping.complain(key, fmt::format("expected {}, found [{}, {}, {}]", kBodyDiscsExpected, row[0],
                                      row[1], row[2]));
  }
  discs = read;
}

std::string group_of(std::string_view name) { return std::string(name.substr(0, name.find('.'))); }
std::string key_of(std::string_view name) { return std::string(name.substr(name.find('.') + 1)); }

// Sets the setting `name` (group.name) to the value in `text`. @return the error, or an empty text;
// `known` becomes whether the setting exists.
std::string assign(Settings& settings, std::string_view name, std::string_view text, bool& known) {
  std::string error;
  known = false;
  visit_settings(settings, [&](const char* group, auto&& visit_fields) {
    if (group_of(name) != group) return;
    visit_fields([&](auto& value, const SettingInfo& info) {
      using Value = std::remove_cvref_t<decltype(value)>;
      if (key_of(name) != info.name) return;
      known = true;
      if (const auto parsed = parse_value<Value>(text, info)) {
        value = *parsed;
      } else {
        error = fmt::format("expected {}, found {}", expected_text<Value>(info), excerpt(text));
      }
    });
  });
  return error;
}

// Reads old names of settings before the groups are read. A file may hold both names; the new one
// takes precedence.
void read_renamed(YamlMapping& root, Settings& settings) {
  for (const RenamedSetting& renamed : kRenamedSettings) {
    const std::string group = group_of(renamed.old_name);
    const std::string key = key_of(renamed.old_name);
    if (!root.has(group.c_str())) continue;
    std::optional<YamlMapping> mapping = root.mapping(group.c_str());
    if (!mapping || !mapping->has(key.c_str())) continue;
    const std::optional<std::string> text = mapping->scalar(key.c_str());
    if (!text) continue;
    bool known = false;
    const std::string error = assign(settings, renamed.name, renamed_value(*text), known);
    if (!error.empty()) mapping->complain(key.c_str(), error);
    root.warn(*renaming_text(renamed.old_name));
  }
}

// Makes the old names of a group known, so that they are not reported as unknown keys.
void allow_renamed(YamlMapping& mapping, std::string_view group) {
  for (const RenamedSetting& renamed : kRenamedSettings) {
    const std::string key = key_of(renamed.old_name);
    if (group_of(renamed.old_name) == group && mapping.has(key.c_str()))
      mapping.expect(key.c_str());
  }
}

template <typename Info>
void read_group(YamlMapping& root, Info&& visit_fields, const char* group) {
  std::optional<YamlMapping> mapping = root.mapping(group);
  if (!mapping) return;
  visit_fields([&](auto& value, const SettingInfo& info) {
    using Value = std::remove_cvref_t<decltype(value)>;
    if (!mapping->has(info.name)) {
      mapping->expect(info.name);
      return;
    }
    if constexpr (std::same_as<Value, BodyDiscs>) {
      read_discs(*mapping, info.name, value);
    } else {
      const std::optional<std::string> text = mapping->scalar(info.name);
      if (!text) return;
      if (const auto parsed = parse_value<Value>(*text, info)) {
        value = *parsed;
      } else {
        mapping->complain(info.name, fmt::format("expected {}, found {}",
                                                 expected_text<Value>(info), excerpt(*text)));
      }
    }
  });
  allow_renamed(*mapping, group);
  mapping->finish();
}

}  // namespace

std::optional<Settings> preset_settings(std::string_view name) {
  if (name == kPresets[0]) return Settings{};
  if (name == kPresets[1]) return paper_settings();
  return std::nullopt;
}

Settings read_settings_mapping(YamlMapping& mapping, const Settings& base) {
  Settings settings = base;
  if (mapping.has("preset")) {
    settings = *preset_settings(kPresets.at(mapping.choice("preset", kPresets)));
  } else {
    mapping.expect("preset");
  }
  read_renamed(mapping, settings);
  visit_settings(settings, [&](const char* group, auto&& visit_fields) {
    read_group(mapping, visit_fields, group);
  });
  mapping.finish();
  return settings;
}

void complain_unless_valid(const Settings& settings, YamlMapping& mapping) {
  const Expected<void> valid = validate(settings);
  if (valid) return;
  const std::string& message = valid.error().message;  // "group.name: expected ..."
  const std::size_t dot = message.find('.');
  const std::size_t colon = message.find(": ");
  const std::string group = message.substr(0, dot);
  if (dot < colon && colon != std::string::npos && mapping.has(group.c_str())) {
    const std::string key = message.substr(dot + 1, colon - dot - 1);
    if (std::optional<YamlMapping> values = mapping.mapping(group.c_str())) {
      values->complain(key.c_str(), message.substr(colon + 2));
      return;
    }
  }
  mapping.complain_here(message);
}

Expected<Settings> parse_settings(const std::string& text,
                                  const std::string& name,
                                  const Settings& base,
                                  std::vector<std::string>* warnings) {
  YamlFile file{.name = name, .error = {}, .warnings = {}};
  YamlMapping root = parse_yaml_mapping(file, text);
  const Settings settings = read_settings_mapping(root, base);
  complain_unless_valid(settings, root);
  if (file.error) return tl::unexpected(*file.error);
  if (warnings != nullptr)
    warnings->insert(warnings->end(), file.warnings.begin(), file.warnings.end());
  return settings;
}

Expected<Settings> read_settings(const std::string& path,
                                 const Settings& base,
                                 std::vector<std::string>* warnings) {
  const Expected<std::string> text = read_whole_file(path, kLongestSettings);
  if (!text) return tl::unexpected(text.error());
  return parse_settings(*text, path, base, warnings);
}

std::vector<SettingDifference> setting_differences(const Settings& settings,
                                                   const Settings& other) {
  std::vector<SettingDifference> all;
  visit_settings(settings, [&](const char* group, auto&& visit_fields) {
    visit_fields([&](const auto& value, const SettingInfo& info) {
      all.push_back({.name = fmt::format("{}.{}", group, info.name),
                     .value = value_text(value),
                     .other = {}});
    });
  });
  std::size_t i = 0;
  visit_settings(other, [&](const char* /*group*/, auto&& visit_fields) {
    visit_fields([&](const auto& value, const SettingInfo& /*info*/) {
      all[i++].other = value_text(value);
    });
  });
  std::erase_if(all, [](const SettingDifference& d) { return d.value == d.other; });
  return all;
}

Expected<void> assign_setting(Settings& settings,
                              std::string_view assignment,
                              std::vector<std::string>* warnings) {
  const std::size_t equals = assignment.find('=');
  const std::string_view key = assignment.substr(0, equals);
  if (equals == std::string_view::npos || key.find('.') == std::string_view::npos) {
    return fail(fmt::format("expected group.name=value, found {}", excerpt(assignment)));
  }
  const std::string_view text = assignment.substr(equals + 1);
  bool known = false;
  std::string error = assign(settings, key, text, known);
  if (!known) {
    for (const RenamedSetting& renamed : kRenamedSettings) {
      if (renamed.old_name != key || !error.empty()) continue;
      error = assign(settings, renamed.name, renamed_value(text), known);
    }
    if (known && warnings != nullptr) warnings->push_back(*renaming_text(key));
  }
  if (known) return error.empty() ? Expected<void>() : fail(fmt::format("{}: {}", key, error));
  std::string groups;
  std::string names;
  visit_settings(settings, [&](const char* group, auto&& visit_fields) {
    groups += fmt::format("{}{}", groups.empty() ? "" : ", ", group);
    if (group_of(key) != group) return;
    visit_fields([&](const auto& /*value*/, const SettingInfo& info) {
      names += fmt::format("{}{}", names.empty() ? "" : ", ", info.name);
    });
  });
  return fail(fmt::format("{}: expected one of {}, found an unknown {}", excerpt(key),
                          names.empty() ? groups : names, names.empty() ? "group" : "key"));
}

std::string settings_yaml(const Settings& settings, SettingsChoice choice) {
  std::vector<std::string> defaults;
  const Settings default_settings;
  visit_settings(default_settings, [&](const char* /*group*/, auto&& visit_fields) {
    visit_fields([&](const auto& value, const SettingInfo& /*info*/) {
      defaults.push_back(value_text(value));
    });
  });
  std::string text = choice == SettingsChoice::All ? kAllHead : kEssentialHead;
  std::size_t index = 0;
  visit_settings(settings, [&](const char* group, auto&& visit_fields) {
    std::string lines;
    visit_fields([&](const auto& value, const SettingInfo& info) {
      using Value = std::remove_cvref_t<decltype(value)>;
      const std::string& usual = defaults[index++];
      if (choice == SettingsChoice::Essential && !info.essential) return;
      const std::string setting = fmt::format("  {}: {}", info.name, value_text(value));
      const std::string unit = *info.unit == '\0' ? "" : fmt::format("[{}] ", info.unit);
      lines += fmt::format("{:<36} # {}{} ({}; default {})\n", setting, unit, info.meaning,
                           expected_text<Value>(info), usual);
    });
    if (!lines.empty()) text += fmt::format("\n{}:\n{}", group, lines);
  });
  return text;
}

std::string settings_markdown() {
  std::vector<std::string> paper;
  const Settings paper_values = paper_settings();
  visit_settings(paper_values, [&](const char* /*group*/, auto&& visit_fields) {
    visit_fields([&](const auto& value, const SettingInfo& /*info*/) {
      paper.push_back(value_text(value));
    });
  });
  std::string text =
      "# Settings\n\n"
      "Written by `fairway settings --markdown`; a test compares the two. A setting is spelled "
      "alike\n"
      "in C++, in YAML (`--settings FILE.yaml`, a mapping per group) and on the command line\n"
      "(`--set group.name=value`). `fairway settings` prints a file to start from. The key\n"
      "`preset: paper` in a file, or `--preset paper`, starts from the values of the paper.\n";
  std::size_t index = 0;
  const Settings default_settings;
  visit_settings(default_settings, [&](const char* group, auto&& visit_fields) {
    text += fmt::format(
        "\n## {}\n\n| name | unit | default | paper | allowed | meaning "
        "|\n|---|---|---|---|---|---|\n",
        group);
    visit_fields([&](const auto& value, const SettingInfo& info) {
      using Value = std::remove_cvref_t<decltype(value)>;
      text +=
          fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", info.name, info.unit,
                      value_text(value), paper[index++], expected_text<Value>(info), info.meaning);
    });
  });
  return text;
}

}  // namespace fairway::io
