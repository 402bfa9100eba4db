// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "monitor_body.hpp"
#include "support/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;
using test::plain;
using test::verdict_of;

// An oracle of another kind: the base is driven in fine steps with what the monitor let pass.
TEST(SafetyMonitor, WhatItLetsPassStopsInTimeOnTheBase) {
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

}  // namespace
}  // namespace fairway
