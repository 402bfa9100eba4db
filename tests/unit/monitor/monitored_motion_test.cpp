// SPDX-License-Identifier: Apache-2.0
// The motion that the monitor expects of a base: hold, acceleration, braking, delay and lag.
#include <utility>

#include <gtest/gtest.h>

#include "fairway/monitor/safety_monitor.hpp"
#include "monitor_body.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

using test::ahead;
using test::kNan;
using test::plain;
using test::verdict_of;

// The robot drives at 1 m/s for 0.15 s, then brakes at 1 m/s2 over 0.5 m. With 0.01 m of margin
// this is 0.66 m, and at most one step of the simulation (0.01 m) more.
TEST(SafetyMonitor, NeedsHoldBrakingDistanceAndMargin) {
  EXPECT_EQ(ahead(plain(), 0.675).fraction, 1.0);
  EXPECT_LT(ahead(plain(), 0.655).fraction, 1.0);
  EXPECT_EQ(ahead(plain(), 0.655).reason, MonitorReason::Obstacle);
}

// 0.155 m while the command is in force, 0.5 m of braking and 0.01 m of margin: 0.665 m exactly.
TEST(SafetyMonitor, SimulatesTheHoldExactly) {
  MonitorSettings settings = plain();
  settings.hold = 0.155;
  EXPECT_EQ(ahead(settings, 0.6655).fraction, 1.0);
  EXPECT_EQ(ahead(settings, 0.6645).fraction, 31.0 / 32.0);
}

TEST(SafetyMonitor, EverySettingOfTheMotionCounts) {
  const auto needs = [](const MonitorSettings& settings, double distance) {
    EXPECT_EQ(ahead(settings, distance + 0.001).fraction, 1.0) << distance;
    EXPECT_LT(ahead(settings, distance - 0.001).fraction, 1.0) << distance;
  };
  MonitorSettings settings = plain();
  settings.linear_acceleration = 2.0;
  needs(settings, 0.15 + 0.25 + 0.01);
  settings = plain();
  settings.delay = 0.2;
  needs(settings, 0.2 + 0.15 + 0.5 + 0.01);
  settings = plain();
  settings.hold = 0.5;
  needs(settings, 0.5 + 0.5 + 0.01);
  settings = plain();
  settings.margin = 0.2;
  needs(settings, 0.15 + 0.5 + 0.2);
  settings = plain();
  settings.linear_braking = 0.5;
  needs(settings, 0.15 + 1.0 + 0.01);
  settings = plain();
  settings.linear_lag = 0.3;  // the speed follows a ramp so much later
  needs(settings, 0.15 + 0.3 + 0.5 + 0.01);
  settings = plain();
  settings.ramp = 2.0 / 2.0;  // no longer than braking at the limit takes
  needs(settings, 0.15 + 0.5 + 0.01);
  settings.linear_acceleration = 4.0;
  needs(settings, 0.15 + 0.5 + 0.01);  // a second, although braking takes a quarter of it
}

// From standstill the base gains speed at once, and loses it slowly.
TEST(SafetyMonitor, CountsAccelerationAndBrakingEachInItsDirection) {
  MonitorSettings settings = plain();
  settings.linear_acceleration = 4.0;
  settings.linear_braking = 0.5;
  settings.hold = 0.2;
  const auto from_rest = [&](double distance) { return ahead(settings, distance, 0.0).fraction; };
  const double needed = 0.5 * 0.8 * 0.2 + 0.8 * 0.8 / 2.0 / 0.5 + 0.01;  // 0.8 m/s are reached
  EXPECT_EQ(from_rest(needed + 0.002), 1.0);
  EXPECT_LT(from_rest(needed - 0.002), 1.0);
}

// Commands that the delay still holds back are executed first, also where they are reduced later.
TEST(SafetyMonitor, RemembersTheCommandsThatAreOnTheirWay) {
  MonitorSettings settings = plain();
  settings.delay = 0.6;
  settings.linear_acceleration = 10.0;
  SafetyMonitor monitor(settings);
  const Twist2 fast{.linear = 1.0};
  const std::vector<Vector2d> wall{{0.3 + 0.4, 0.0}};
  EXPECT_TRUE(monitor.see(0.0, {}));
  EXPECT_EQ(monitor.check(0.0, {}, {}, fast).fraction, 1.0);  // from standstill
  // It was sent, and the next cycle takes it back: the base will still drive 0.1 s of it.
  EXPECT_TRUE(monitor.see(0.1, wall));
  EXPECT_EQ(monitor.check(0.1, {}, fast, {}).fraction, 1.0);
  EXPECT_EQ(monitor.check(0.2, {}, {}, {.linear = 0.5}).fraction, 1.0);
  // Within the delay the base is at rest, though its command was fast until now.
  const std::vector<Vector2d> near{{0.3 + 0.1, 0.0}};
  EXPECT_TRUE(monitor.see(0.3, near));
  EXPECT_LT(monitor.check(0.3, {}, {.linear = 0.5}, {.linear = 0.1}).fraction, 1.0);
}

// 0.3 s after a robot at full speed was sent a standstill, a base with 0.6 s of delay has not
// begun to brake. Its queue, not the last command, says what it does next.
TEST(SafetyMonitor, KnowsThatALateBaseDoesNotBrakeYet) {
  MonitorSettings settings = plain();
  settings.delay = 0.6;
  settings.hold = 0.1;
  SafetyMonitor monitor(settings);
  const Twist2 fast{.linear = 1.0};
  EXPECT_TRUE(monitor.see(0.0, {}));
  EXPECT_EQ(monitor.check(0.0, {}, fast, {}).fraction, 1.0);
  for (const double time : {0.1, 0.2})
    EXPECT_EQ(monitor.check(time, {}, {}, {}).fraction, 1.0);
  // Another 0.3 m, 0.5 m of braking, and 0.01 m.
  const Twist2 turn{.angular = 0.01};
  EXPECT_TRUE(monitor.see(0.3, std::vector<Vector2d>{{0.3 + 0.82, 0.0}}));
  EXPECT_EQ(monitor.check(0.3, {}, {}, turn).fraction, 1.0);
  monitor.reset();
  EXPECT_EQ(monitor.check(0.3, {}, fast, {}).fraction, 0.0);
}

// A base that gains 0.01 m/s2: within 10 s it has not reached the command, after more it has.
TEST(SafetyMonitor, AfterTenSecondsTheBaseMovesAsItWasSent) {
  MonitorSettings settings = plain();
  settings.linear_acceleration = 0.01;
  settings.linear_braking = 1.0;
  settings.max_age = 100.0;
  for (const auto& [pause, fraction] : {std::pair{9.9, 1.0}, {10.0, 1.0}, {10.1, 0.0}}) {
    SafetyMonitor monitor(settings);
    EXPECT_TRUE(monitor.see(0.0, std::vector<Vector2d>{{0.3 + 0.3, 0.0}}));
    EXPECT_EQ(monitor.check(0.0, {}, {}, {}).fraction, 1.0);
    EXPECT_EQ(monitor.check(pause, {}, {.linear = 1.0}, {}).fraction, fraction) << pause;
  }
}

TEST(SafetyMonitor, TakesAStopOfMoreThanAMinuteForNone) {
  MonitorSettings settings = plain();
  settings.linear_acceleration = 0.01;
  settings.hold = 0.1;
  const auto fraction = [&](double speed) {
    const MonitorVerdict verdict =
        verdict_of(settings, {{18.0, 2.0}}, {.linear = speed}, {.linear = speed});
    return verdict.fraction;
  };
  EXPECT_EQ(fraction(0.59), 1.0);
  EXPECT_LT(fraction(0.65), 1.0);
}

// An invalid cycle leaves no trace in what is remembered.
TEST(SafetyMonitor, ForgetsNothingInAnInvalidCycle) {
  MonitorSettings settings = plain();
  settings.delay = 0.3;
  settings.max_age = 100.0;
  for (const bool bad_time : {true, false}) {
    SafetyMonitor monitor(settings);
    EXPECT_TRUE(monitor.see(0.0, std::vector<Vector2d>{{0.3 + 0.6, 0.0}}));
    (void)monitor.check(0.0, {}, {}, {});
    (void)monitor.check(bad_time ? kNan : 0.1, {}, {.linear = bad_time ? 0.0 : kNan}, {});
    // 1 m/s was sent at 0.1 s (at 0 s where that cycle had no time): it acts at 1.2 s.
    EXPECT_EQ(monitor.check(0.2, {}, {}, {}).fraction, 1.0);
    EXPECT_LT(monitor.check(2.2, {}, {.linear = 1.0}, {}).fraction, 1.0);
  }
}

// Nothing turns yet when the command's hold is over.
TEST(SafetyMonitor, LooksAtTheAxisWithTheLongerDelay) {
  MonitorSettings settings = plain();
  settings.angular_delay = 0.5;
  settings.hold = 0.3;
  const std::vector<Vector2d> beside{{0.18, 0.24}};
  EXPECT_LT(verdict_of(settings, beside, {}, {.angular = 1.5}).fraction, 1.0);
  EXPECT_EQ(verdict_of(settings, beside, {}, {.angular = 0.02}).fraction, 1.0);
}

TEST(SafetyMonitor, AfterAPauseTheBaseMovesAsItWasSent) {
  MonitorSettings settings = plain();
  settings.delay = 0.6;
  settings.max_age = 100.0;
  for (const double pause : {9.9, 10.1}) {
    SafetyMonitor monitor(settings);
    EXPECT_TRUE(monitor.see(0.0, std::vector<Vector2d>{{0.3 + 0.5, 0.0}}));
    (void)monitor.check(0.0, {}, {}, {});
    (void)monitor.check(pause - 0.1, {}, {}, {});
    // Other programs have driven it since.
    const double fraction = monitor.check(2.0 * pause - 0.1, {}, {.linear = 1.0}, {}).fraction;
    EXPECT_EQ(fraction, 0.0) << pause;
  }
}

TEST(SafetyMonitor, KnowsHowFastATurnEnds) {
  // The corner of the body, 0.36 m from its centre, turns into a point beside it.
  const auto turning = [](double acceleration) {
    MonitorSettings settings = plain();
    settings.angular_acceleration = acceleration;
    return verdict_of(settings, {{0.18, 0.30}}, {.angular = 1.0}, {.angular = 1.0}).fraction;
  };
  EXPECT_EQ(turning(20.0), 1.0);
  EXPECT_LT(turning(0.6), 1.0);
}

// While the base does not follow yet it goes on as it did.
TEST(SafetyMonitor, CountsTheOldCommandDuringTheDelay) {
  MonitorSettings settings = plain();
  settings.delay = 0.5;
  settings.linear_acceleration = 20.0;
  EXPECT_EQ(ahead(settings, 0.24, 0.0).fraction, 1.0);
  EXPECT_EQ(ahead(settings, 0.24, 1.0).fraction, 0.0);
  EXPECT_EQ(ahead(settings, 0.24, 1.0).reason, MonitorReason::Obstacle);
}

}  // namespace
}  // namespace fairway
