// SPDX-License-Identifier: Apache-2.0
#include "bridge/command_guard.hpp"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace fairway::bridge {
namespace {

// A scan of one beam straight ahead from the robot's centre.
struct Ahead {
  explicit Ahead(double distance, double time = 0.0) : ranges{static_cast<float>(distance)} {
    scan.time = time;
    scan.max_range = 20.0;
    scan.ranges = ranges;
  }
  std::vector<float> ranges;
  LidarScan scan;
};

TEST(CommandGuard, KnowsTheBodyOfTheRobot) {
  Settings settings;
  settings.robot.radius = 0.3;
  ASSERT_TRUE(validate(monitor_settings(settings)));
  EXPECT_EQ(monitor_settings(settings).footprint.size(), 1U);
  settings.robot.length = 1.0;
  settings.robot.width = 0.6;
  const MonitorSettings body = monitor_settings(settings);
  ASSERT_TRUE(validate(body));
  EXPECT_EQ(body.footprint[0].size(), 4U);
  settings = {};
  settings.robot.discs.count = 2;
  settings.robot.discs.discs[0] = {.center = {0.2, 0.0}, .radius = 0.25};
  settings.robot.discs.discs[1] = {.center = {-0.2, 0.0}, .radius = 0.25};
  EXPECT_EQ(monitor_settings(settings).footprint.size(), 2U);
  EXPECT_TRUE(validate(monitor_settings(settings)));
}

TEST(CommandGuard, KnowsWhatTheBaseCanDo) {
  Settings settings;
  settings.robot.linear_acceleration_max = 3.0;
  settings.robot.linear_braking_max = 0.5;
  settings.robot.angular_braking_max = 0.7;
  settings.robot.linear_delay = 0.5;
  settings.robot.angular_delay = 0.2;
  settings.robot.linear_lag = 0.3;
  settings.robot.angular_lag = 0.1;
  settings.safety.longest_hold = 5.0;
  const MonitorSettings monitor = monitor_settings(settings);
  EXPECT_EQ(monitor.linear_acceleration, 3.0);
  EXPECT_EQ(monitor.linear_braking, 0.5);
  EXPECT_EQ(monitor.angular_braking, 0.7);
  EXPECT_EQ(monitor.delay, 0.5);
  EXPECT_EQ(monitor.angular_delay, 0.2);
  EXPECT_EQ(monitor.linear_lag, 0.3);
  EXPECT_EQ(monitor.angular_lag, 0.1);
  EXPECT_EQ(monitor.hold, 0.5);
  EXPECT_EQ(monitor.ramp, 0.1);
  RobotModel body;
  body.base.response_time = 0.4;
  body.base.linear_acceleration = 0.3;
  EXPECT_EQ(monitor_settings(settings, body).delay, 0.4);
  EXPECT_EQ(monitor_settings(settings, body).linear_acceleration, 0.3);
  EXPECT_EQ(monitor_settings(settings, body).hold, 0.5);
}

TEST(CommandGuard, IsValidForSettingsAtTheEndsOfTheirRanges) {
  Settings settings;
  settings.robot.linear_acceleration_max = 1000.0;
  settings.robot.angular_acceleration_max = 0.01;
  settings.safety.map_timeout = 100.0;
  settings.safety.stop_margin = 1.0;
  settings.safety.actuation_lag = 5.0;
  EXPECT_TRUE(validate(monitor_settings(settings)));
  settings.robot.linear_acceleration_max = 0.01;
  settings.robot.linear_braking_max = 0.005;
  settings.robot.linear_delay = 0.6;
  settings.robot.linear_lag = 1.0;
  settings.robot.linear_max = 2.0;
  settings.navigation.control_period = 1.0;
  settings.safety.longest_hold = 20.0;
  EXPECT_EQ(monitor_settings(settings).linear_braking, 0.005);
  EXPECT_TRUE(validate(monitor_settings(settings)));
  EXPECT_EQ(monitor_settings(settings).hold, 20.0);
  EXPECT_EQ(monitor_settings(settings).delay, 0.6 + 4.5);
  settings.robot.linear_braking_max = 0.0;
  EXPECT_TRUE(validate(monitor_settings(settings)));
  settings.navigation.control_period = 0.005;
  settings.safety.longest_hold = 1.0;
  EXPECT_TRUE(validate(monitor_settings(settings)));
}

TEST(CommandGuard, StopsInFrontOfObstaclesOfTheScan) {
  CommandGuard guard{monitor_settings(Settings{})};
  const Twist2 fast{.linear = 1.0};
  EXPECT_EQ(guard.check(0.0, {}, fast, fast).reason, MonitorReason::Stale);
  guard.observe(Ahead(5.0).scan);
  EXPECT_EQ(guard.check(0.0, {}, fast, fast).fraction, 1.0);
  guard.observe(Ahead(0.5, 0.1).scan);
  EXPECT_EQ(guard.check(0.1, {}, fast, fast).reason, MonitorReason::Obstacle);
  EXPECT_LT(guard.check(0.1, {}, fast, fast).command.linear, 1.0);
}

TEST(CommandGuard, IgnoresAnImplausibleScanAndBeamsThatHitNothing) {
  CommandGuard guard{monitor_settings(Settings{})};
  Ahead bad(0.5);
  bad.scan.angle_step = std::numeric_limits<double>::quiet_NaN();
  guard.observe(bad.scan);
  EXPECT_EQ(guard.check(0.0, {}, {}, {.linear = 0.5}).reason, MonitorReason::Stale);
  guard.observe(Ahead(std::numeric_limits<double>::infinity()).scan);
  EXPECT_EQ(guard.check(0.0, {}, {}, {.linear = 0.5}).reason, MonitorReason::None);
}

// 10000 beams, of which the last one hits a post just ahead: it must not be the one that is left
// out.
TEST(CommandGuard, KeepsTheNearestOfTooManyPoints) {
  CommandGuard guard{monitor_settings(Settings{})};
  Ahead scan(9.0);
  scan.ranges.assign(10000, 9.0F);
  scan.ranges.back() = 0.5F;
  scan.scan.ranges = scan.ranges;
  scan.scan.angle_step = 1e-4;
  scan.scan.first_angle = -9999 * 1e-4;
  guard.observe(scan.scan);
  EXPECT_EQ(guard.check(0.0, {}, {.linear = 1.0}, {.linear = 1.0}).reason, MonitorReason::Obstacle);
}

// The scan of the lidar at the back does not replace that of the one in front.
TEST(CommandGuard, CountsThePointsOfSeveralLidarsTogether) {
  MonitorSettings settings = monitor_settings(Settings{});
  settings.max_age = 0.5;
  CommandGuard guard{settings};
  const Pose2 front{.position = {0.2, 0.0}, .heading = 0.0};
  const Pose2 back{.position = {-0.2, 0.0}, .heading = 3.14};
  const Twist2 fast{.linear = 1.0};
  guard.observe(Ahead(0.6, 0.0).scan, front);
  guard.observe(Ahead(9.0, 0.05).scan, back);
  EXPECT_EQ(guard.check(0.05, {}, fast, fast).reason, MonitorReason::Obstacle);
  // A newer scan of the same lidar replaces it, and one that is too old is forgotten.
  guard.observe(Ahead(9.0, 0.1).scan, front);
  EXPECT_EQ(guard.check(0.1, {}, fast, fast).reason, MonitorReason::None);
  guard.observe(Ahead(0.6, 0.2).scan, front);
  guard.observe(Ahead(9.0, 0.8).scan, back);
  EXPECT_EQ(guard.check(0.8, {}, fast, fast).reason, MonitorReason::None);
}

TEST(CommandGuard, NamesEveryReason) {
  for (const MonitorReason reason :
       {MonitorReason::None, MonitorReason::InvalidInput, MonitorReason::Stale,
        MonitorReason::StopZone, MonitorReason::SlowZone, MonitorReason::Obstacle})
    EXPECT_STRNE(to_text(reason), "unknown");
}

}  // namespace
}  // namespace fairway::bridge
