// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/settings.hpp"

#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace fairway {
namespace {

TEST(Settings, DefaultsAndThePapersAreValid) {
  EXPECT_TRUE(validate(Settings{}).has_value());
  EXPECT_TRUE(validate(paper_settings()).has_value());
}

TEST(Settings, EveryFieldHasAUniqueNameAndAMeaning) {
  std::set<std::string> names;
  const Settings settings;
  visit_settings(settings, [&](const char* group, auto&& visit_fields) {
    visit_fields([&](const auto&, const SettingInfo& info) {
      EXPECT_TRUE(names.insert(std::string(group) + "." + info.name).second) << info.name;
      EXPECT_FALSE(std::string(info.meaning).empty()) << info.name;
    });
  });
  EXPECT_GT(names.size(), 40U);
}

TEST(Settings, AnErrorNamesTheSettingTheRangeAndTheNumber) {
  Settings settings;
  settings.robot.linear_max = -1.0;
  const auto valid = validate(settings);
  ASSERT_FALSE(valid.has_value());
  EXPECT_EQ(valid.error().message, "robot.linear_max: expected a number from 0.01 to 10, found -1");
  settings.robot.linear_max = std::nan("");
  EXPECT_FALSE(validate(settings).has_value());
}

TEST(Settings, ADecayRateAboveTheInverseStepIsRefused) {
  Settings settings;
  settings.mpc.decay_rate = 11.0;
  settings.mpc.step_length = 0.1;
  EXPECT_FALSE(validate(settings).has_value());
}

}  // namespace
}  // namespace fairway
