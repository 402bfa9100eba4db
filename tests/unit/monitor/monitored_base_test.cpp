// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "monitor_body.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;
using test::plain;
using test::verdict_of;

// An oracle of another kind: the base is driven in fine steps with what the monitor let pass.
TEST(SafetyMonitor, ACommandThatItAcceptsStopsInTimeOnTheBase) {
  test::Random random(5);
  for (int trial = 0; trial < 300; ++trial) {
    MonitorSettings settings = plain();
    settings.delay = random.uniform(0.0, 0.4);
    settings.hold = random.uniform(0.02, 0.3);
    settings.linear_acceleration = random.uniform(0.3, 3.0);
    settings.angular_acceleration = random.uniform(0.5, 5.0);
    const Twist2 before{.linear = random.uniform(-0.3, 0.3), .angular = random.uniform(-0.5, 0.5)};
    const Twist2 wanted{.linear = random.uniform(-2.0, 2.0), .angular = random.uniform(-2.0, 2.0)};
    std::vector<Vector2d> points;
    for (int i = 0; i < 5; ++i) {
      const double angle = random.uniform(-3.14, 3.14);
      points.push_back(random.uniform(0.6, 1.5) * direction(angle));
    }
    const MonitorVerdict verdict = verdict_of(settings, points, before, wanted);
    if (verdict.fraction == 0.0) continue;
    constexpr double kStep = 1e-3;  // [s]
    Twist2 twist = before;
    Pose2 pose;
    for (int i = 0; i < 6000; ++i) {
      const double t = i * kStep;
      const Twist2 target = t < settings.delay                   ? before
                            : t < settings.delay + settings.hold ? verdict.command
                                                                 : Twist2{};
      const auto ramp = [&](double from, double to, double rate) {
        return from + std::clamp(to - from, -rate * kStep, rate * kStep);
      };
      twist.linear = ramp(twist.linear, target.linear, settings.linear_acceleration);
      twist.angular = ramp(twist.angular, target.angular, settings.angular_acceleration);
      pose.position += kStep * twist.linear * direction(pose.heading);
      pose.heading += kStep * twist.angular;
      for (const Vector2d& point : points) {
        const Vector2d local = inverse_transform(pose, point);
        const double outside = Vector2d(std::max(0.0, std::abs(local.x()) - 0.3),
                                        std::max(0.0, std::abs(local.y()) - 0.2))
                                   .norm();
        // Less than half a step of the simulation and half of the margin.
        ASSERT_GT(outside, 0.5 * settings.margin) << "trial " << trial << " after " << t << " s";
      }
    }
  }
}

// A base with delay, lag and different braking, sent other commands in each of the cycles before.
// The oracle follows each axis in steps of a millisecond, as hard as it can.
struct HardAxis {
  double gain, loss, delay, lag;
  double speed = 0.0;

  void step(const std::vector<std::pair<double, double>>& sent, double time, double h) {
    double command = 0.0;
    for (const auto& [when, value] : sent)
      if (when + delay <= time + 1e-9) command = value;
    const double wanted = lag > 0.0 ? speed + (command - speed) * h / lag : command;
    const bool brakes = wanted * speed < 0.0 || std::abs(wanted) < std::abs(speed);
    const double most = (brakes ? loss : gain) * h;
    speed += std::clamp(wanted - speed, -most, most);
  }
};

TEST(SafetyMonitor, KnowsWhereTheCommandsOfTheLastCyclesLead) {
  test::Random random(17);
  int reduced = 0;
  for (int trial = 0; trial < 200; ++trial) {
    MonitorSettings settings = plain();
    settings.delay = random.uniform(0.0, 0.5);
    settings.angular_delay = random.uniform(0.0, 0.5);
    settings.linear_lag = random.chance(0.5) ? random.uniform(0.0, 0.3) : 0.0;
    settings.angular_lag = random.chance(0.5) ? random.uniform(0.0, 0.3) : 0.0;
    settings.linear_acceleration = random.uniform(0.5, 3.0);
    settings.linear_braking = random.uniform(0.5, 3.0);
    settings.angular_acceleration = random.uniform(0.5, 5.0);
    settings.angular_braking = random.uniform(0.5, 5.0);
    const double period = random.uniform(0.05, 0.15);
    HardAxis linear{settings.linear_acceleration, settings.linear_braking, settings.delay,
                    settings.linear_lag};
    HardAxis angular{settings.angular_acceleration, settings.angular_braking,
                     *settings.angular_delay, settings.angular_lag};
    std::vector<std::pair<double, double>> speeds;
    std::vector<std::pair<double, double>> turns;
    constexpr double kStep = 1e-3;  // [s]
    SafetyMonitor monitor(settings);
    Twist2 sent;
    Pose2 pose;
    double time = 0.0;
    const auto drive_to = [&](double end) {
      for (; time < end - 1e-9; time += kStep) {
        linear.step(speeds, time, kStep);
        angular.step(turns, time, kStep);
        pose.position += kStep * linear.speed * direction(pose.heading);
        pose.heading += kStep * angular.speed;
      }
    };
    const auto send = [&](double when, const Twist2& command) {
      speeds.emplace_back(when, command.linear);
      turns.emplace_back(when, command.angular);
      sent = command;
    };
    int cycle = 0;
    for (; cycle < 12; ++cycle) {
      drive_to(cycle * period);
      EXPECT_TRUE(monitor.see(time, {}));
      if (cycle % 4 == 0) {
        const Twist2 next{.linear = random.uniform(-1.0, 1.0),
                          .angular = random.uniform(-1.0, 1.0)};
        (void)monitor.check(cycle * period, pose, sent, next);
        send(cycle * period, next);
      } else {
        (void)monitor.check(cycle * period, pose, sent, sent);
      }
    }
    const double now = cycle * period;
    drive_to(now);
    std::vector<Vector2d> points;
    for (int i = 0; i < 6; ++i)
      points.push_back(
          transform(pose, random.uniform(0.45, 1.5) * direction(random.uniform(-3.14, 3.14))));
    EXPECT_TRUE(monitor.see(now, points));
    const MonitorVerdict verdict = monitor.check(now, pose, sent, sent);
    if (verdict.fraction == 0.0) continue;
    if (verdict.fraction < 1.0) ++reduced;
    send(now, verdict.command);
    send(now + settings.hold, {});
    const double end = now + 8.0;
    while (time < end) {
      drive_to(time + 5.0 * kStep);
      for (const Vector2d& point : points) {
        const Vector2d local = inverse_transform(pose, point);
        const double outside = Vector2d(std::max(0.0, std::abs(local.x()) - 0.3),
                                        std::max(0.0, std::abs(local.y()) - 0.2))
                                   .norm();
        ASSERT_GT(outside, 0.3 * settings.margin) << "trial " << trial << " at " << time - now;
      }
    }
  }
  EXPECT_GT(reduced, 10);
}

}  // namespace
}  // namespace fairway
