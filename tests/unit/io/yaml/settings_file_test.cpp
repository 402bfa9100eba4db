// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/yaml/settings_file.hpp"

#include <gtest/gtest.h>

#include "fairway/io/yaml/setting_text.hpp"
#include "support/runs/temporary_folder.hpp"

namespace fairway::io {
namespace {

std::string complaint(const std::string& text) {
  const auto settings = parse_settings(text, "s.yaml");
  return settings ? "none" : settings.error().message;
}

std::string complaint_about(const std::string& assignment) {
  Settings settings;
  const auto done = assign_setting(settings, assignment);
  return done ? "none" : done.error().message;
}

// All values as text, for comparison.
std::vector<std::string> values(const Settings& settings) {
  std::vector<std::string> result;
  visit_settings(settings, [&](const char* group, auto&& visit_fields) {
    visit_fields([&](const auto& value, const SettingInfo& info) {
      result.push_back(std::string(group) + "." + info.name + "=" + value_text(value));
    });
  });
  return result;
}

TEST(SettingsFile, ReadsBackWhatItPrints) {
  for (const char* name : {"default", "paper"}) {
    const Settings settings = preset_settings(name).value();
    const auto read = parse_settings(settings_yaml(settings), "s.yaml");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(values(*read), values(settings));
  }
}

TEST(SettingsFile, ReadsBackEveryValueThatIsNotTheDefault) {
  Settings settings;
  visit_settings(settings, [&](const char* /*group*/, auto&& visit_fields) {
    visit_fields([&](auto& value, const SettingInfo& info) {
      using Value = std::remove_cvref_t<decltype(value)>;
      if constexpr (std::is_same_v<Value, bool>) {
        value = !value;
      } else if constexpr (std::is_same_v<Value, double>) {
        value = std::min(info.max, value + 1.0 / 7.0);
      } else if constexpr (std::is_same_v<Value, int>) {
        value = value - 1 >= static_cast<int>(info.min) ? value - 1 : value + 1;
      } else if constexpr (std::is_enum_v<Value>) {
        value = static_cast<Value>(setting_names(value).size() - 1);
      }
    });
  });
  settings.mpc.decay_rate = 1.0;
  settings.robot.linear_min = -1.0 / 3.0;
  const auto read = parse_settings(settings_yaml(settings), "s.yaml");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(values(*read), values(settings));
}

TEST(SettingsFile, KeepsSettingsThatItDoesNotName) {
  Settings base;
  base.robot.radius = 0.4;
  const auto read = parse_settings("mpc:\n  horizon: 12\n", "s", base);
  EXPECT_EQ(read.value().mpc.horizon, 12);
  EXPECT_EQ(read.value().robot.radius, 0.4);
}

TEST(SettingsFile, StartsFromAPreset) {
  const auto read = parse_settings("mpc: {horizon: 12}\npreset: paper", "s").value();
  EXPECT_EQ(read.mpc.horizon, 12);
  EXPECT_EQ(read.robot.linear_min, paper_settings().robot.linear_min);
  EXPECT_EQ(read.corridor.method, CorridorMethod::Mdsrc);
  EXPECT_FALSE(preset_settings("papers"));
}

TEST(SettingsFile, AnErrorNamesFileLineKeyRangeAndValue) {
  EXPECT_EQ(complaint("mpc:\n  horizon: 51"),
            "s.yaml:2: mpc.horizon: expected an integer from 1 to 50, found '51'");
  EXPECT_EQ(complaint("mpc:\n  horizon: 1.5"),
            "s.yaml:2: mpc.horizon: expected an integer from 1 to 50, found '1.5'");
  EXPECT_EQ(complaint("path:\n  any_angle: maybe"),
            "s.yaml:2: path.any_angle: expected true or false, found 'maybe'");
  EXPECT_EQ(complaint("corridor:\n  method: astar"),
            "s.yaml:2: corridor.method: expected mdsrc or fewest, found 'astar'");
  EXPECT_EQ(complaint("preset: fast"), "s.yaml:1: preset: expected default or paper, found 'fast'");
  EXPECT_EQ(complaint("robot:\n  raduis: 1"),
            "s.yaml:2: robot.'raduis': expected one of angular_acceleration_max, "
            "angular_braking_max, angular_delay, angular_lag, angular_max, "
            "discs, length, linear_acceleration_max, linear_braking_max, linear_delay, linear_lag, "
            "linear_max, linear_min, radius, width, found an "
            "unknown key");
  EXPECT_EQ(complaint("\nmcp: {}").substr(0, 17), "s.yaml:2: 'mcp': ");
  EXPECT_EQ(complaint("mpc: 3"), "s.yaml:1: mpc: expected a mapping, found '3'");
  EXPECT_EQ(complaint("mpc:\n  dt: 1\n  decay_rate: 5"),
            "s.yaml:3: mpc.decay_rate: expected at most 1 / mpc.step_length = 1 (Eq. 14), found 5");
  EXPECT_NE(complaint("mpc:\n  dt: .nan"), "none");
  EXPECT_NE(complaint("mpc:\n  dt: [0.1]"), "none");
  EXPECT_NE(complaint("mpc:\n  dt:"), "none");
}

// Found by tests/fuzz: yaml-cpp emits endless empty documents for these.
TEST(SettingsFile, RefusesTokensOutsideADocument) {
  for (const char* text : {",\nf\n", ",\xff'", "]", "}", "robot: {}\n...\n,", "a\n---\n]"})
    EXPECT_NE(complaint(text), "none") << text;
}

TEST(SettingsFile, ItsErrorsAreOneLineForAnyContent) {
  for (const std::string& text : {std::string("?\n\0\n", 4), std::string("\"\\\n\""),
                                  std::string("\"a\\nb\": 1"), std::string("robot: \"a\\nb\"")}) {
    const std::string message = complaint(text);
    EXPECT_NE(message, "none") << text;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST(SettingsFile, AssignsOneSetting) {
  Settings settings;
  ASSERT_TRUE(assign_setting(settings, "robot.linear_max=1.25"));
  ASSERT_TRUE(assign_setting(settings, "corridor.space=workspace"));
  ASSERT_TRUE(assign_setting(settings, "path.any_angle=false"));
  EXPECT_EQ(settings.robot.linear_max, 1.25);
  EXPECT_EQ(settings.corridor.space, CorridorSpace::Workspace);
  EXPECT_FALSE(settings.path.any_angle);
}

TEST(SettingsFile, ReportsErrorsInAnAssignment) {
  EXPECT_EQ(complaint_about("robot.radius=-1"),
            "robot.radius: expected a number from 0.01 to 10, found '-1'");
  EXPECT_EQ(complaint_about("robot.breadth=1"),
            "'robot.breadth': expected one of radius, length, width, discs, linear_min, "
            "linear_max, angular_max, "
            "linear_acceleration_max, angular_acceleration_max, linear_braking_max, "
            "angular_braking_max, linear_delay, angular_delay, linear_lag, angular_lag, found an "
            "unknown key");
  EXPECT_NE(complaint_about("body.width=1").find("found an unknown group"), std::string::npos);
  EXPECT_EQ(complaint_about("radius=1"), "expected group.name=value, found 'radius=1'");
  for (const char* text : {"", "=", ".", "robot.radius", "robot.radius=", "robot.radius=nan",
                           "robot.radius=1e400", "robot.=1", ".radius=1"}) {
    EXPECT_NE(complaint_about(text), "none") << text;
  }
}

TEST(SettingsFile, ReadsABodyOfDiscsInOneLineOrInSeveral) {
  for (const char* list :
       {" [[0.2, 0, 0.25], [-0.2, 0, 0.3]]", "\n    - [0.2, 0, 0.25]\n    - [-0.2, 0.0, 3e-1]"}) {
    const auto read = parse_settings(std::string("robot:\n  discs:") + list + "\n", "s.yaml");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(to_text(read->robot.discs), "[[0.2, 0, 0.25], [-0.2, 0, 0.3]]");
    EXPECT_EQ(footprint_of(read->robot).num_discs(), 2);
    EXPECT_EQ(values(*parse_settings(settings_yaml(*read), "s.yaml")), values(*read));
  }
  Settings settings;
  ASSERT_TRUE(assign_setting(settings, "robot.discs=[[0.1, 0, 0.2]]"));
  ASSERT_TRUE(assign_setting(settings, "robot.discs=[]"));
  EXPECT_EQ(settings.robot.discs.count, 0);
}

TEST(SettingsFile, AnErrorInABodyOfDiscsIsOneLine) {
  const auto complaint = [](const std::string& text) {
    const auto read = parse_settings(text, "s.yaml");
    return read ? "none" : read.error().message;
  };
  const std::string range =
      "up to 8 of [x, y, radius], radius from 0.01 to 10, x and y from -20 to 20";
  EXPECT_EQ(complaint("robot:\n  discs: [[0, 0, -1]]\n"),
            "s.yaml:2: robot.discs: expected " + range + ", found [0, 0, -1]");
  EXPECT_EQ(complaint("robot:\n  discs: 0.3\n"),
            "s.yaml:2: robot.discs: expected lists of 3 numbers, found '0.3'");
  EXPECT_EQ(complaint("robot:\n  length: 1\n  width: 1\n  discs: [[0, 0, 1]]\n"),
            "s.yaml:4: robot.discs: expected no robot.length and robot.width together with discs");
  EXPECT_EQ(complaint_about("robot.discs=[[0, 0]]"),
            "robot.discs: expected " + range + ", found '[[0, 0]]'");
}

TEST(SettingsFile, IsDocumentedInDocs) {
  EXPECT_TRUE(settings_markdown() == test::content_of(FAIRWAY_SOURCE_DIR "/docs/settings.md"))
      << "run: fairway settings --markdown > docs/settings.md";
}

TEST(SettingsFile, EverySettingHasAUniqueNameAndAMeaning) {
  const Settings settings;
  std::set<std::string> names;
  visit_settings(settings, [&](const char* group, auto&& visit_fields) {
    visit_fields([&](const auto& /*value*/, const SettingInfo& info) {
      EXPECT_TRUE(names.insert(std::string(group) + "." + info.name).second) << info.name;
      EXPECT_GT(std::string(info.meaning).size(), 5U) << info.name;
    });
  });
  EXPECT_GT(names.size(), 30U);
}

}  // namespace
}  // namespace fairway::io
