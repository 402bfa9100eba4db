// SPDX-License-Identifier: Apache-2.0
// Bases as RobotSettings describe them, driven with what the monitor of the nodes lets pass.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "bridge/command_guard.hpp"
#include "fairway/safety/base_response.hpp"
#include "support/random/random_world.hpp"

namespace fairway::bridge {
namespace {

using Eigen::Vector2d;
using fairway::test::Random;

Settings random_settings(Random& random) {
  Settings settings;
  RobotSettings& robot = settings.robot;
  const auto rate = [&] {
    return random.chance(0.2) ? random.uniform(0.05, 0.3) : random.uniform(0.3, 3.0);
  };
  robot.radius = random.uniform(0.1, 0.4);
  if (random.chance(0.5)) {
    robot.width = random.uniform(0.2, 0.5);
    robot.length = robot.width + random.uniform(0.0, 0.4);
    robot.radius = 0.5 * std::hypot(robot.length, robot.width);
  }
  robot.linear_max = random.uniform(0.3, 2.0);
  robot.linear_min = random.chance(0.5) ? -robot.linear_max : 0.0;
  robot.linear_acceleration_max = rate();
  robot.angular_acceleration_max = 2.0 * rate();
  robot.linear_braking_max = random.chance(0.3) ? 0.0 : rate();
  robot.angular_braking_max = random.chance(0.3) ? 0.0 : 2.0 * rate();
  if (random.chance(0.7)) robot.linear_delay = random.uniform(0.0, 0.6);
  robot.angular_delay = random.chance(0.5) ? robot.linear_delay : random.uniform(0.0, 0.6);
  if (random.chance(0.5)) robot.linear_lag = random.uniform(0.0, 0.3);
  if (random.chance(0.5)) robot.angular_lag = random.uniform(0.0, 0.3);
  settings.navigation.control_period = random.uniform(0.02, 0.2);
  settings.safety.longest_hold = random.uniform(1.0, 4.0);
  return settings;
}

// The clearance of the body to a point [m]; negative inside a disc.
double clearance(const Footprint& body, const Pose2& pose, const Vector2d& point) {
  const Vector2d local = inverse_transform(pose, point);
  if (!body.is_rectangle()) return local.norm() - body.circumscribed_radius();
  const auto corners = body.rectangle_at({}).corners();
  Vector2d half = Vector2d::Zero();
  for (const Vector2d& corner : corners)
    half = half.cwiseMax(corner.cwiseAbs());
  return (local.cwiseAbs() - half).cwiseMax(0.0).norm();
}

// A base of the family in motion: each axis as the slow or as the quick one.
struct Base {
  Pose2 pose;
  bool quick_linear = false;
  bool quick_angular = false;

  void move(const BaseResponse& from, const BaseResponse& to, double h) {
    const auto mean = [](double a, double b) { return 0.5 * (a + b); };
    const double v = quick_linear ? mean(from.quick.linear, to.quick.linear)
                                  : mean(from.slow.linear, to.slow.linear);
    const double w = quick_angular ? mean(from.quick.angular, to.quick.angular)
                                   : mean(from.slow.angular, to.slow.angular);
    pose.position += h * v * direction(pose.heading + 0.5 * h * w);
    pose.heading += h * w;
  }
};

struct Outcome {
  int judged = 0;
  int reduced = 0;
  int touched = 0;
};

// Drives a while, then meets points; the verdict's command is held as long as is promised, and the
// base is sent a standstill after that.
void drive_once(Random& random, const Settings& settings, Outcome& outcome) {
  const RobotSettings& robot = settings.robot;
  const double period = settings.navigation.control_period;
  const BaseActuation actuation = actuation_of(robot);
  const auto ramp_of = [&](const Twist2& from, const Twist2& to) {
    return Twist2{
        .linear = std::max(period, change_time(from.linear, to.linear, actuation.linear)),
        .angular = std::max(period, change_time(from.angular, to.angular, actuation.angular))};
  };
  SafetyMonitor monitor(monitor_settings(settings));
  CommandHistory history;
  BaseResponse response;
  Twist2 sent;
  Twist2 wanted;
  double time = 0.0;
  const auto limited = [&](double from, double to, const AxisActuation& axis) {
    return limited_change(from, to, axis, period);
  };
  for (int cycle = random.integer(0, 40); cycle >= 0; --cycle) {
    if (random.chance(0.15)) {
      wanted = {.linear = random.uniform(robot.linear_min, robot.linear_max),
                .angular = random.uniform(-robot.angular_max, robot.angular_max)};
    }
    const Twist2 command{.linear = limited(sent.linear, wanted.linear, actuation.linear),
                         .angular = limited(sent.angular, wanted.angular, actuation.angular)};
    ASSERT_TRUE(monitor.see(time, {}));
    ASSERT_EQ(monitor.check(time, {}, sent, command).reason, MonitorReason::None);
    history.send(time, command, ramp_of(history.reached(time), command));
    sent = command;
    advance(response, history, actuation, time, time + period);
    time += period;
  }
  std::vector<Vector2d> points;
  // About as far away as the base needs to stop, in front of it or anywhere.
  const double speed = std::abs(sent.linear);
  const double stop = speed * (actuation.linear.delay + actuation.linear.lag + 2.0 * period) +
                      0.5 * speed * speed / actuation.linear.braking;
  for (int i = 0; i < 4; ++i) {
    const double aside = i < 2 ? 0.5 : 3.14;
    const double back = sent.linear < 0.0 ? 3.14 : 0.0;
    points.push_back((robot.radius + random.uniform(0.0, 0.5 + 1.3 * stop)) *
                     direction(back + random.uniform(-aside, aside)));
  }
  const Footprint body = footprint_of(robot);
  std::erase_if(points, [&](const Vector2d& p) { return clearance(body, {}, p) < 0.02; });
  ASSERT_TRUE(monitor.see(time, points));
  const Twist2 next{.linear = limited(sent.linear, wanted.linear, actuation.linear),
                    .angular = limited(sent.angular, wanted.angular, actuation.angular)};
  const MonitorVerdict verdict = monitor.check(time, {}, sent, next);
  if (verdict.fraction == 0.0) return;
  ++outcome.judged;
  if (verdict.fraction < 1.0) ++outcome.reduced;
  const double hold = settings.safety.longest_hold * period;
  history.send(time, verdict.command, ramp_of(history.reached(time), verdict.command));
  std::array<Base, 4> bases;
  for (std::size_t i = 0; i < bases.size(); ++i) {
    bases[i].quick_linear = i % 2 == 1;
    bases[i].quick_angular = i / 2 == 1;
  }
  bool stopped = false;
  const double end = time + hold + 60.0;
  for (const double stop_at = time + hold; time < end;) {
    constexpr double kStep = 4e-3;
    const double h = stopped ? kStep : std::min(kStep, stop_at - time);
    const BaseResponse before = response;
    advance(response, history, actuation, time, time + h);
    time += h;
    for (Base& base : bases) {
      base.move(before, response, h);
      for (const Vector2d& point : points) {
        if (clearance(body, base.pose, point) > 0.0) continue;
        ++outcome.touched;
        return;
      }
    }
    const auto at_rest = [](const Twist2& twist) {
      return std::abs(twist.linear) < 1e-5 && std::abs(twist.angular) < 1e-5;
    };
    if (stopped && time > stop_at + 1.5 && at_rest(response.slow) && at_rest(response.quick)) break;
    if (!stopped && time >= stop_at - 1e-9) {
      history.send(time, {}, ramp_of(history.reached(time), {}));
      stopped = true;
    }
  }
}

TEST(CommandGuard, WhatItLetsPassStopsInTimeOnEveryBaseOfTheSettings) {
  Random random(11);
  Outcome outcome;
  for (int trial = 0; trial < 400; ++trial) {
    const Settings settings = random_settings(random);
    if (!validate(settings)) continue;
    drive_once(random, settings, outcome);
    ASSERT_EQ(outcome.touched, 0) << "trial " << trial;
  }
  EXPECT_GT(outcome.judged, 200);
  EXPECT_GT(outcome.reduced, 20);
}

}  // namespace
}  // namespace fairway::bridge
