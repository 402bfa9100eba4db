// SPDX-License-Identifier: Apache-2.0
// What the monitor sees, and what it answers.
#include "fairway/monitor/safety_monitor.hpp"

#include <gtest/gtest.h>

#include "monitor_body.hpp"
#include "support/runs/allocation_guard.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

using test::ahead;
using test::box;
using test::kInfinity;
using test::kNan;
using test::plain;
using test::verdict_of;

TEST(SafetyMonitor, LetsACommandPassInTheOpen) {
  const MonitorVerdict verdict = verdict_of(plain(), {}, {}, {.linear = 0.8, .angular = -0.5});
  EXPECT_EQ(verdict.fraction, 1.0);
  EXPECT_EQ(verdict.command.linear, 0.8);
  EXPECT_EQ(verdict.command.angular, -0.5);
  EXPECT_EQ(verdict.reason, MonitorReason::None);
}

// What is on the border counts: of a zone, and of what is an error.
TEST(SafetyMonitor, BordersBelongToWhatTheyBound) {
  MonitorSettings settings = plain();
  settings.stop_zone = box(0.5, 1.0, 0.5);
  EXPECT_EQ(verdict_of(settings, {{1.0, 0.0}}, {}, {}).reason, MonitorReason::StopZone);
  settings = plain();
  settings.slow_zone = box(0.5, 1.0, 0.5);
  EXPECT_EQ(verdict_of(settings, {{1.0, 0.0}}, {}, {.linear = -1.0}).reason,
            MonitorReason::SlowZone);
  settings.slow_zone = box(0.3, 1.0, 0.5);  // a point on the body is a part of it
  EXPECT_EQ(verdict_of(settings, {{0.3, 0.0}}, {}, {.linear = -1.0}).reason, MonitorReason::None);
  SafetyMonitor monitor(plain());
  EXPECT_TRUE(monitor.see(0.0, std::vector<Vector2d>{{1e7, -1e7}}));
  const Twist2 fast{.linear = 20.0, .angular = -20.0};
  EXPECT_EQ(monitor.check(0.0, {.position = {-1e7, 1e7}}, fast, fast).reason, MonitorReason::None);
}

TEST(SafetyMonitor, GivesTheLargestOf32Fractions) {
  const MonitorVerdict verdict = ahead(plain(), 0.6);
  EXPECT_GT(verdict.fraction, 0.0);
  EXPECT_LT(verdict.fraction, 1.0);
  EXPECT_EQ(verdict.fraction * 32.0, std::round(verdict.fraction * 32.0));
  EXPECT_EQ(verdict.command.linear, verdict.fraction);
  // One 32nd more would not stop in time, all else being equal.
  const double more = verdict.fraction + 1.0 / 32.0;
  EXPECT_LT(verdict_of(plain(), {{0.9, 0.0}}, {.linear = 1.0}, {.linear = more}).fraction, 1.0);
  EXPECT_EQ(
      verdict_of(plain(), {{0.9, 0.0}}, {.linear = 1.0}, {.linear = verdict.fraction}).fraction,
      1.0);
}

TEST(SafetyMonitor, ReversesAndTurnsByTheSameRule) {
  EXPECT_LT(verdict_of(plain(), {{-0.6, 0.0}}, {.linear = -1.0}, {.linear = -1.0}).fraction, 1.0);
  EXPECT_EQ(verdict_of(plain(), {{0.9, 0.0}}, {.linear = -1.0}, {.linear = -1.0}).fraction, 1.0);
  EXPECT_LT(verdict_of(plain(), {{0.0, 0.3}}, {.angular = 2.0}, {.angular = 2.0}).fraction, 1.0);
}

// A robot that is already too near may leave, but must not come nearer.
TEST(SafetyMonitor, LeavesAPointThatIsNearerThanTheMargin) {
  MonitorSettings settings = plain();
  settings.margin = 0.1;
  const std::vector<Vector2d> wall{{0.34, 0.0}};
  EXPECT_EQ(verdict_of(settings, wall, {}, {.linear = -0.5}).fraction, 1.0);
  EXPECT_EQ(verdict_of(settings, wall, {}, {.linear = 0.5}).fraction, 0.0);
  const std::vector<Vector2d> inside{{0.25, 0.0}};
  EXPECT_EQ(verdict_of(settings, inside, {}, {.linear = -0.1}).fraction, 1.0);
  EXPECT_EQ(verdict_of(settings, inside, {}, {.linear = 0.1}).fraction, 0.0);
}

TEST(SafetyMonitor, TakesTheBodyForTheUnionOfItsPolygons) {
  MonitorSettings settings = plain();
  settings.footprint.push_back(box(0.2, 0.8, 0.05));  // a fork
  EXPECT_LT(verdict_of(settings, {{1.1, 0.0}}, {.linear = 1.0}, {.linear = 1.0}).fraction, 1.0);
  EXPECT_EQ(verdict_of(plain(), {{1.1, 0.0}}, {.linear = 1.0}, {.linear = 1.0}).fraction, 1.0);
}

// Outside of the notch of an L, though within its bounding box.
TEST(SafetyMonitor, TakesPolygonsThatAreNotConvex) {
  const MonitorSettings settings{
      .footprint = {{{-0.3, -0.3}, {0.3, -0.3}, {0.3, 0.0}, {0.0, 0.0}, {0.0, 0.3}, {-0.3, 0.3}}}};
  EXPECT_EQ(verdict_of(settings, {{0.2, 0.2}}, {}, {.linear = -0.1}).fraction, 1.0);
  EXPECT_LT(verdict_of(settings, {{0.2, 0.2}}, {.linear = 0.8}, {.linear = 0.8}).fraction, 1.0);
}

TEST(SafetyMonitor, StopsForAPointInTheStopZone) {
  MonitorSettings settings = plain();
  settings.stop_zone = box(0.3, 1.0, 0.5);
  const MonitorVerdict verdict = verdict_of(settings, {{0.9, 0.4}}, {}, {.linear = -0.1});
  EXPECT_EQ(verdict.reason, MonitorReason::StopZone);
  EXPECT_EQ(verdict.fraction, 0.0);
  EXPECT_EQ(verdict.command.linear, 0.0);
  EXPECT_EQ(verdict_of(settings, {{0.9, 0.6}}, {}, {.linear = -0.1}).fraction, 1.0);
}

TEST(SafetyMonitor, SlowsDownForAPointInTheSlowZone) {
  MonitorSettings settings = plain();
  settings.slow_zone = box(0.3, 3.0, 1.0);
  const std::vector<Vector2d> point{{2.5, 0.9}};
  const MonitorVerdict verdict = verdict_of(settings, point, {}, {.linear = 1.0, .angular = 0.5});
  EXPECT_EQ(verdict.reason, MonitorReason::SlowZone);
  EXPECT_DOUBLE_EQ(verdict.command.linear, 0.3);
  EXPECT_DOUBLE_EQ(verdict.command.angular, 0.15);
  EXPECT_EQ(verdict_of(settings, point, {}, {.linear = -0.3}).reason, MonitorReason::None);
  EXPECT_EQ(verdict_of(settings, {{2.5, 1.1}}, {}, {.linear = 1.0}).reason, MonitorReason::None);
  settings.slow_speed = 0.5;
  EXPECT_DOUBLE_EQ(verdict_of(settings, point, {}, {.linear = -1.0}).command.linear, -0.5);
  // An obstacle counts within it.
  const MonitorVerdict near = verdict_of(settings, {{0.32, 0.0}}, {}, {.linear = 1.0});
  EXPECT_EQ(near.reason, MonitorReason::Obstacle);
  EXPECT_LT(near.command.linear, 0.5);
}

// A mast, or the lidar's own housing, is seen inside the body.
TEST(SafetyMonitor, MistakesNoPartOfTheBodyForAnIntruder) {
  MonitorSettings settings = plain();
  settings.stop_zone = box(-1.0, 1.0, 1.0);
  settings.slow_zone = box(-1.0, 1.0, 1.0);
  EXPECT_EQ(verdict_of(settings, {{0.0, 0.0}}, {}, {.angular = 0.1}).fraction, 1.0);
}

TEST(SafetyMonitor, StopsWithoutNewPoints) {
  SafetyMonitor monitor(plain());
  EXPECT_EQ(monitor.check(0.0, {}, {}, {.linear = 1.0}).reason, MonitorReason::Stale);
  EXPECT_TRUE(monitor.see(10.0, {}));
  for (const double time : {10.0, 10.5, 9.5})
    EXPECT_EQ(monitor.check(time, {}, {}, {.linear = 1.0}).fraction, 1.0) << time;
  for (const double time : {10.51, 9.49, kNan, kInfinity}) {
    const MonitorVerdict verdict = monitor.check(time, {}, {}, {.linear = 1.0});
    EXPECT_EQ(verdict.reason, MonitorReason::Stale) << time;
    EXPECT_EQ(verdict.command.linear, 0.0) << time;
  }
}

TEST(SafetyMonitor, StopsOnWhatIsNotFiniteOrAbsurd) {
  SafetyMonitor monitor(plain());
  EXPECT_TRUE(monitor.see(0.0, {}));
  const auto reason = [&](const Pose2& pose, const Twist2& current, const Twist2& command) {
    const MonitorVerdict verdict = monitor.check(0.0, pose, current, command);
    EXPECT_TRUE(is_finite(verdict.command));
    return verdict.reason;
  };
  const Twist2 slow{.linear = 0.1};
  for (const double bad : {kNan, kInfinity, 1.01e7, -1.01e7}) {
    EXPECT_EQ(reason({.position = {bad, 0}}, slow, slow), MonitorReason::InvalidInput);
    EXPECT_EQ(reason({.position = {0, bad}}, slow, slow), MonitorReason::InvalidInput);
  }
  EXPECT_EQ(reason({.position = {0.99e7, -0.99e7}}, slow, slow), MonitorReason::None);
  EXPECT_EQ(reason({.heading = kNan}, slow, slow), MonitorReason::InvalidInput);
  for (const double bad : {kNan, -kInfinity, 20.1, -20.1}) {
    EXPECT_EQ(reason({}, {.linear = bad}, slow), MonitorReason::InvalidInput);
    EXPECT_EQ(reason({}, {.angular = bad}, slow), MonitorReason::InvalidInput);
    EXPECT_EQ(reason({}, slow, {.linear = bad}), MonitorReason::InvalidInput);
    EXPECT_EQ(reason({}, slow, {.angular = bad}), MonitorReason::InvalidInput);
  }
  EXPECT_EQ(reason({}, slow, {.linear = 19.9, .angular = -19.9}), MonitorReason::None);
}

TEST(SafetyMonitor, KeepsTheOlderPointsWhereNewOnesAreRefused) {
  SafetyMonitor monitor(plain());
  const std::vector<Vector2d> wall{{0.35, 0.0}};
  EXPECT_TRUE(monitor.see(0.0, wall));
  for (const double bad : {kNan, kInfinity, 1.01e7})
    EXPECT_FALSE(monitor.see(1.0, std::vector<Vector2d>{{0.0, bad}}));
  EXPECT_FALSE(monitor.see(kNan, {}));
  EXPECT_FALSE(monitor.see(1.0, std::vector<Vector2d>(8193, Vector2d::Zero())));
  EXPECT_LT(monitor.check(0.0, {}, {.linear = 1.0}, {.linear = 1.0}).fraction, 1.0);
  EXPECT_EQ(monitor.check(1.0, {}, {}, {.linear = 1.0}).reason, MonitorReason::Stale);
  EXPECT_TRUE(monitor.see(1.0, std::vector<Vector2d>(8192, Vector2d(0.99e7, 0.0))));
}

TEST(SafetyMonitor, PutsPointsIntoTheFrameOfTheRobot) {
  SafetyMonitor monitor(plain());
  EXPECT_TRUE(monitor.see(0.0, std::vector<Vector2d>{{5.0, 7.5}}));
  const Pose2 facing{.position = {5.0, 7.0}, .heading = std::acos(0.0)};
  const Pose2 beside{.position = {5.0, 7.0}, .heading = 0.0};
  EXPECT_LT(monitor.check(0.0, facing, {.linear = 1.0}, {.linear = 1.0}).fraction, 1.0);
  EXPECT_EQ(monitor.check(0.0, beside, {.linear = 1.0}, {.linear = 1.0}).fraction, 1.0);
}

TEST(SafetyMonitor, DoesNotAllocateWhileTheRobotDrives) {
  SafetyMonitor monitor(plain());
  const std::vector<Vector2d> points(8192, Vector2d(0.6, 0.1));
  if (!test::AllocationGuard::available) GTEST_SKIP() << "a sanitizer owns malloc";
  const test::AllocationGuard guard;
  const bool taken = monitor.see(0.0, points);
  const MonitorVerdict verdict = monitor.check(0.0, {}, {.linear = 1.0}, {.linear = 1.0});
  EXPECT_EQ(guard.count(), 0U);
  EXPECT_TRUE(taken);
  EXPECT_LT(verdict.fraction, 1.0);
}

}  // namespace
}  // namespace fairway
