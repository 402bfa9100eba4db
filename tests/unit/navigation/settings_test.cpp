// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/settings.hpp"

#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "fairway/safety/braking_profile.hpp"

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

// Found from outside: the stop was cut off after 256 cycles, and the angular speed fell to 0 at
// once.
TEST(Settings, AStopThatIsTooLongToBeHeldIsRefused) {
  Settings settings;
  settings.robot.angular_acceleration_max = 0.01;
  EXPECT_EQ(validate(settings).error().message,
            "robot.angular_acceleration_max: expected enough to stop within 588 cycles of "
            "navigation.control_period, found 1500");
  settings.robot.angular_braking_max = 1.0;
  EXPECT_TRUE(validate(settings)) << "it brakes harder than it accelerates";
  settings.robot.linear_braking_max = 0.01;
  EXPECT_NE(validate(settings).error().message.find("robot.linear_braking_max"), std::string::npos);
}

TEST(Settings, EveryStopThatIsAcceptedEndsAtStandstill) {
  Settings settings;
  for (const double period : {0.005, 0.1, 1.0}) {
    for (const double change : {0.01, 0.05, 0.3, 2.0}) {
      settings.navigation.control_period = period;
      settings.robot.linear_acceleration_max = settings.robot.angular_acceleration_max = change;
      if (!validate(settings)) continue;
      const RobotSettings& robot = settings.robot;
      const StopSequence stop =
          brake_from({.linear = robot.linear_max, .angular = -robot.angular_max}, robot, period);
      ASSERT_FALSE(stop.empty());
      const Twist2& last = stop.back();
      EXPECT_EQ(last.linear, 0.0);
      EXPECT_EQ(last.angular, 0.0);
    }
  }
}

}  // namespace
}  // namespace fairway
