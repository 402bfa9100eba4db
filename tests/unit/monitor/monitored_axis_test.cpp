// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/monitor/safety_monitor.hpp"
#include "monitor_body.hpp"

namespace fairway {
namespace {

constexpr double kNear = 1e-12;

MonitoredAxis axis(double gain, double loss, double lag = 0.0, double ramp = 0.0) {
  return {.gain = gain, .loss = loss, .lag = lag, .ramp = ramp};
}

// The axis at `speed`, sent `command` now, after `time`.
MonitoredAxis after(MonitoredAxis a, double speed, double command, double time) {
  a.begin(speed);
  const std::vector<SentCommand> sent{{0.0, {.linear = command}}};
  EXPECT_EQ(a.obey(sent, 0.0), std::numeric_limits<double>::infinity());
  a.advance(time);
  return a;
}

TEST(MonitoredAxis, GainsAndLosesSpeedByItsLimits) {
  EXPECT_NEAR(after(axis(2.0, 0.5), 0.0, 1.0, 0.1).quick, 0.2, kNear);
  EXPECT_NEAR(after(axis(2.0, 0.5), 0.3, 0.2, 0.1).quick, 0.25, kNear);
  EXPECT_NEAR(after(axis(2.0, 0.5), 0.3, 0.2, 0.3).quick, 0.2, kNear);
  EXPECT_NEAR(after(axis(2.0, 0.5), -0.3, -0.2, 0.1).quick, -0.25, kNear);
  EXPECT_NEAR(after(axis(2.0, 0.5), -0.2, -0.5, 0.1).quick, -0.4, kNear);
}

// Half of the time it loses 0.1 m/s, in the other half it gains 0.4 m/s to the other side.
TEST(MonitoredAxis, ReversesThroughStandstill) {
  EXPECT_NEAR(after(axis(2.0, 0.5), 0.1, -1.0, 0.4).quick, -0.4, kNear);
  EXPECT_NEAR(after(axis(2.0, 0.5), -0.1, 1.0, 0.4).quick, 0.4, kNear);
  // The slow one ramps evenly: 0.2 s of loss and 0.5 s of gain for 1.1 m/s.
  EXPECT_NEAR(after(axis(2.0, 0.5), 0.1, -1.0, 0.35).slow, 0.1 - 0.55, kNear);
}

TEST(MonitoredAxis, RampsNoFasterThanItsRamp) {
  const MonitoredAxis slow = after(axis(2.0, 0.5, 0.0, 0.4), 0.5, 0.4, 0.1);
  EXPECT_NEAR(slow.slow, 0.475, kNear);
  EXPECT_NEAR(slow.quick, 0.45, kNear);
  EXPECT_NEAR(after(axis(2.0, 0.5, 0.0, 0.4), 0.5, 0.1, 0.4).slow, 0.3, kNear);  // 0.8 s by loss
}

// A lag of any length: what is left of a change shrinks by exp(-t / lag).
TEST(MonitoredAxis, FollowsWithItsLag) {
  for (const double lag : {0.05, 0.3}) {
    const MonitoredAxis late = after(axis(100.0, 100.0, lag), 0.0, 1.0, 0.05);
    EXPECT_NEAR(late.quick, 1.0 - std::exp(-0.05 / lag), kNear);
    // Half of the ramp is the mean of its command over the first 0.01 s.
    const MonitoredAxis first = after(axis(100.0, 100.0, lag), 0.0, 1.0, 0.01);
    EXPECT_NEAR(first.slow, 0.5 * (1.0 - std::exp(-0.01 / lag)), kNear);
  }
}

TEST(MonitoredAxis, ObeysWhatHasComeThroughTheDelay) {
  MonitoredAxis late = axis(1.0, 1.0);
  late.delay = 0.5;
  late.part = &Twist2::angular;
  late.begin(0.2);
  const std::vector<SentCommand> sent{{0.0, {.angular = 0.3}}, {0.1, {.angular = 0.4}}};
  EXPECT_NEAR(late.obey(sent, 0.2), 0.3, kNear);
  EXPECT_EQ(late.command, 0.2);
  EXPECT_NEAR(late.obey(sent, 0.5), 0.1, kNear);
  EXPECT_EQ(late.command, 0.3);
  EXPECT_EQ(late.obey(sent, 0.61), std::numeric_limits<double>::infinity());
  EXPECT_EQ(late.command, 0.4);
  EXPECT_EQ(late.fastest(), 0.4);
  EXPECT_NEAR(late.rate, 1.0, kNear);
}

TEST(MonitoredAxis, TakesItsNumbersFromTheSettings) {
  MonitorSettings settings = test::plain();
  settings.delay = 0.3;
  EXPECT_EQ(linear_axis(settings).loss, 1.0);
  EXPECT_EQ(angular_axis(settings).loss, 2.0);
  EXPECT_EQ(angular_axis(settings).delay, 0.3);
  settings.linear_braking = 0.05;
  settings.angular_braking = 0.06;
  settings.angular_delay = 0.4;
  settings.linear_lag = 0.1;
  settings.angular_lag = 0.2;
  settings.ramp = 0.15;
  EXPECT_EQ(linear_axis(settings).loss, 0.05);
  EXPECT_EQ(angular_axis(settings).loss, 0.06);
  EXPECT_EQ(linear_axis(settings).delay, 0.3);
  EXPECT_EQ(angular_axis(settings).delay, 0.4);
  EXPECT_EQ(linear_axis(settings).lag, 0.1);
  EXPECT_EQ(angular_axis(settings).lag, 0.2);
  EXPECT_EQ(linear_axis(settings).ramp, 0.15);
  EXPECT_EQ(angular_axis(settings).ramp, 0.15);
}

}  // namespace
}  // namespace fairway
