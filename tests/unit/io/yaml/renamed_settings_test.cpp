// SPDX-License-Identifier: Apache-2.0
// Settings under their names up to version 0.1.
#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "fairway/io/yaml/setting_text.hpp"
#include "fairway/io/yaml/settings_file.hpp"
#include "fairway/navigation/settings.hpp"

namespace fairway::io {
namespace {

using Values = std::map<std::string, std::string>;

Values values_of(const Settings& settings) {
  Values values;
  visit_settings(settings, [&](const char* group, auto&& visit_fields) {
    visit_fields([&](const auto& value, const SettingInfo& info) {
      values[std::string(group) + "." + info.name] = value_text(value);
    });
  });
  return values;
}

// A value of the setting `name` that differs from its default, as text; empty for an unknown
// setting.
std::string other_value(const std::string& name) {
  std::string text;
  const Settings defaults;
  visit_settings(defaults, [&](const char* group, auto&& visit_fields) {
    visit_fields([&](const auto& value, const SettingInfo& info) {
      using Value = std::remove_cvref_t<decltype(value)>;
      if (std::string(group) + "." + info.name != name) return;
      if constexpr (std::is_same_v<Value, bool>) {
        text = value_text(!value);
      } else if constexpr (std::is_same_v<Value, double>) {
        text = value_text(std::clamp(0.75 * value + 0.01, info.min, info.max));
      } else if constexpr (std::is_enum_v<Value>) {
        text =
            setting_names(value)[setting_names(value).size() - 1 - static_cast<std::size_t>(value)];
      } else if constexpr (std::is_same_v<Value, int>) {
        text = value_text(value + 1);
      }
    });
  });
  return text;
}

// The settings that replace one old name.
std::vector<std::string> names_of(std::string_view old_name) {
  std::vector<std::string> names;
  for (const RenamedSetting& renamed : kRenamedSettings) {
    if (renamed.old_name == old_name) names.emplace_back(renamed.name);
  }
  return names;
}

void expect_only(const Settings& settings, std::string_view old_name, const std::string& value) {
  Values expected = values_of({});
  for (const std::string& name : names_of(old_name))
    expected[name] = value;
  EXPECT_EQ(values_of(settings), expected) << old_name;
}

std::string in_file(std::string_view name, const std::string& value) {
  const std::size_t dot = name.find('.');
  return std::string(name.substr(0, dot)) + ":\n  " + std::string(name.substr(dot + 1)) + ": " +
         value + "\n";
}

TEST(RenamedSettings, HaveNewNamesThatExist) {
  const Values now = values_of({});
  for (const RenamedSetting& renamed : kRenamedSettings) {
    EXPECT_TRUE(now.contains(std::string(renamed.name))) << renamed.name;
    EXPECT_FALSE(now.contains(std::string(renamed.old_name))) << renamed.old_name;
  }
}

TEST(RenamedSettings, MeanTheSameInAFile) {
  for (const RenamedSetting& renamed : kRenamedSettings) {
    const std::string value = other_value(std::string(renamed.name));
    std::vector<std::string> warnings;
    const auto read = parse_settings(in_file(renamed.old_name, value), "s.yaml", {}, &warnings);
    ASSERT_TRUE(read) << read.error().message;
    expect_only(*read, renamed.old_name, value);
    ASSERT_FALSE(warnings.empty()) << renamed.old_name;
    for (const std::string& warning : warnings)
      EXPECT_EQ(warning, renaming_text(renamed.old_name));
  }
}

TEST(RenamedSettings, MeanTheSameInAnAssignment) {
  for (const RenamedSetting& renamed : kRenamedSettings) {
    const std::string value = other_value(std::string(renamed.name));
    Settings settings;
    std::vector<std::string> warnings;
    const auto done =
        assign_setting(settings, std::string(renamed.old_name) + "=" + value, &warnings);
    ASSERT_TRUE(done) << done.error().message;
    expect_only(settings, renamed.old_name, value);
    EXPECT_EQ(warnings, std::vector{*renaming_text(renamed.old_name)});
  }
}

TEST(RenamedSettings, YieldToTheNewNameInTheSameFile) {
  const auto read = parse_settings(
      "mpc: {dt: 0.2, linear_max: 0.5, step_length: 0.15}\nrobot: {linear_max: 0.7}\n", "s.yaml");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->robot.linear_max, 0.7);
  EXPECT_EQ(read->mpc.step_length, 0.15);
  EXPECT_EQ(read->navigation.control_period, 0.2);
}

TEST(RenamedSettings, TheOldStepSetsTheControlPeriodToo) {
  Settings settings;
  ASSERT_TRUE(assign_setting(settings, "mpc.dt=0.125"));
  EXPECT_EQ(settings.mpc.step_length, 0.125);
  EXPECT_EQ(settings.navigation.control_period, 0.125);
  EXPECT_EQ(renaming_text("mpc.dt"), "mpc.dt (now mpc.step_length and navigation.control_period)");
  EXPECT_FALSE(renaming_text("mpc.step_length"));
}

TEST(RenamedSettings, TheOldTargetModeAcceptsItsOldValue) {
  const auto read = parse_settings("navigation: {target_mode: timed_string}\n", "s.yaml");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(values_of(*read).at("tracking.target_mode"), "reference_path");
  Settings settings = paper_settings();
  ASSERT_TRUE(assign_setting(settings, "navigation.target_mode=timed_string"));
  EXPECT_EQ(values_of(settings).at("tracking.target_mode"), "reference_path");
}

TEST(RenamedSettings, AreCheckedLikeTheNewOnes) {
  const auto read = parse_settings("mpc:\n  linear_max: 11\n", "s.yaml");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().message,
            "s.yaml:2: mpc.linear_max: expected a number from 0.01 to 10, found '11'");
}

}  // namespace
}  // namespace fairway::io
