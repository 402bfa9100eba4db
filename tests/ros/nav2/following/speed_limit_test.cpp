// SPDX-License-Identifier: Apache-2.0
#include "nav2_fairway_controller/following/speed_limit.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "ros/nav2/following/follower_rig.hpp"

namespace fairway::nav2 {
namespace {

TEST(SpeedLimit, GivesValidSettingsForEveryNumber) {
  Settings settings;
  settings.robot.linear_min = -0.5;
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double value : {0.0, 1e-300, 0.001, 0.0099, 0.01, 0.3, 1.0, 50.0, 100.0, 1e9, -1.0,
                             infinity, -infinity, std::nan("")}) {
    for (const bool percentage : {false, true}) {
      const LimitedSettings now = limited(settings, {.value = value, .percentage = percentage});
      EXPECT_TRUE(validate(now.settings).has_value()) << value << percentage;
      EXPECT_LE(now.settings.robot.linear_max, settings.robot.linear_max);
      EXPECT_GE(now.settings.robot.linear_min, -now.settings.robot.linear_max);
    }
  }
}

TEST(SpeedLimit, IsAbsoluteOrAPercentageAndZeroRemovesIt) {
  const Settings settings;  // 1 m/s
  EXPECT_EQ(limited(settings, {.value = 0.3}).settings.robot.linear_max, 0.3);
  EXPECT_EQ(limited(settings, {.value = 30.0, .percentage = true}).settings.robot.linear_max, 0.3);
  EXPECT_EQ(limited(settings, {}).settings.robot.linear_max, 1.0);
  EXPECT_TRUE(limited(settings, {}).fault.empty());
}

TEST(SpeedLimit, BelowTheLeastSpeedHoldsWithAReason) {
  Settings settings;
  settings.robot.linear_max = 0.5;
  const LimitedSettings now = limited(settings, {.value = 1.0, .percentage = true});
  EXPECT_TRUE(now.holds);
  EXPECT_NE(now.fault.find("0.005 m/s"), std::string::npos) << now.fault;
  EXPECT_NE(limited(settings, {.value = -1.0}).fault.find("ignored"), std::string::npos);
}

TEST(SpeedLimit, TooLowToDriveStopsTheRobotWithinItsLimitsUntilItIsLifted) {
  FollowerSettings settings;
  settings.robot.robot.linear_max = 0.5;
  Rig rig(Rig::free_hall({.position = {1, 3}, .heading = 0}), settings);
  rig.follower.set_path(Rig::dense({{1, 3}, {8, 3}}), {});
  rig.drive(3.0);
  rig.follower.set_speed_limit({.value = 1.0, .percentage = true});
  FollowerStep last = rig.drive(1.0);
  EXPECT_EQ(rig.robot().twist.linear, 0.0);
  EXPECT_EQ(last.fault, FollowerFault::None);
  EXPECT_NE(last.reason.find("below the least speed"), std::string::npos) << last.reason;
  last = rig.drive(6.0);
  EXPECT_EQ(last.fault, FollowerFault::NoControl) << "after the patience of 5 s";
  EXPECT_LE(rig.greatest_change, 0.2 + 1e-9);
  rig.follower.set_speed_limit({});
  EXPECT_EQ(rig.drive(30.0).status, NavigationStatus::GoalReached);
}

TEST(ControllerFrequency, GivesTheControlPeriodOrIsRefused) {
  EXPECT_EQ(period_of(20.0), 0.05);
  EXPECT_EQ(frequency_fault(period_of(20.0), 20.0), "");
  EXPECT_EQ(frequency_fault(0.0333, 30.0), "");
  EXPECT_NE(frequency_fault(0.1, 20.0).find("expected 0.05"), std::string::npos);
  for (const double frequency : {0.0, -5.0, std::nan(""), 0.5, 1000.0}) {
    EXPECT_FALSE(frequency_fault(period_of(frequency), frequency).empty()) << frequency;
    EXPECT_TRUE(std::isfinite(period_of(frequency)));
  }
}

TEST(ControllerFrequency, DoesNotChangeTheAcceleration) {
  for (const double frequency : {10.0, 20.0, 40.0}) {
    SCOPED_TRACE(frequency);
    FollowerSettings settings;
    settings.robot.navigation.control_period = period_of(frequency);
    Rig rig(Rig::free_hall({.position = {1, 3}, .heading = 0}), settings);
    rig.follower.set_path(Rig::dense({{1, 3}, {8, 3}}), {});
    EXPECT_EQ(rig.drive(30.0).status, NavigationStatus::GoalReached);
    EXPECT_LE(rig.greatest_change * frequency, 2.0 + 1e-6);
    EXPECT_GT(rig.greatest_change * frequency, 1.5);
  }
}

// Nav2's servers send a zero command as soon as the goal checker accepts the goal.
double speed_at_acceptance(const GoalTolerance& checker, const FollowerSettings& settings) {
  Rig rig(Rig::free_hall({.position = {1, 3}, .heading = 0}), settings);
  rig.goal = checker;
  rig.follower.set_path(Rig::dense({{1, 3}, {6, 3}}), {});
  for (int i = 0; i < 400; ++i) {
    const double distance = (rig.robot().pose.position - Eigen::Vector2d(6, 3)).norm();
    const double speed = rig.robot().twist.linear;
    if (distance <= checker.distance && (!checker.requires_stop || speed < 0.02)) return speed;
    rig.step();
  }
  ADD_FAILURE() << "not accepted";
  return 0.0;
}

TEST(GoalTolerance, OfACheckerThatAcceptsAMovingRobotIsEnteredSlowly) {
  FollowerSettings settings;
  settings.robot.robot.linear_max = 0.5;
  EXPECT_LE(speed_at_acceptance({.distance = 0.25}, settings), 0.2 + 1e-9);
  EXPECT_GT(speed_at_acceptance({.distance = 0.25}, settings), 0.1) << "not slower than needed";
  settings.robot.robot.linear_max = 1.0;
  EXPECT_LE(speed_at_acceptance({.distance = 0.25}, settings), 0.2 + 1e-9);
  EXPECT_LE(speed_at_acceptance({.distance = 0.05}, settings), 0.2 + 1e-9);
}

TEST(GoalTolerance, OfACheckerThatRequiresAStopIsReachedAtTheGoal) {
  Rig rig(Rig::free_hall({.position = {1, 3}, .heading = 0}));
  rig.goal = GoalTolerance{.distance = 0.05, .heading = 0.1, .requires_stop = true};
  rig.follower.set_path(Rig::dense({{1, 3}, {6, 3}}), 0.5);
  rig.drive(40.0);
  EXPECT_LT((rig.robot().pose.position - Eigen::Vector2d(6, 3)).norm(), 0.05);
  EXPECT_NEAR(rig.robot().pose.heading, 0.5, 0.1);
}

}  // namespace
}  // namespace fairway::nav2
