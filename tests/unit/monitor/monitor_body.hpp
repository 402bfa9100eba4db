// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/monitor/safety_monitor.hpp"

namespace fairway::test {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

inline Polygon box(double back, double front, double half_width) {
  return {{back, -half_width}, {front, -half_width}, {front, half_width}, {back, half_width}};
}

// A body from -0.3 to 0.3 m that is 0.4 m wide.
inline MonitorSettings plain() { return {.footprint = {box(-0.3, 0.3, 0.2)}}; }

// What the monitor says of a command, with these points seen just now.
inline MonitorVerdict verdict_of(const MonitorSettings& settings,
                                 const std::vector<Eigen::Vector2d>& points,
                                 const Twist2& current,
                                 const Twist2& command) {
  SafetyMonitor monitor(settings);
  EXPECT_TRUE(monitor.see(0.0, points));
  return monitor.check(0.0, {}, current, command);
}

// Straight on at 1 m/s towards a point so far in front of the body, which moves with `speed`.
inline MonitorVerdict ahead(const MonitorSettings& settings, double distance, double speed = 1.0) {
  return verdict_of(settings, {{0.3 + distance, 0.0}}, {.linear = speed}, {.linear = 1.0});
}

}  // namespace fairway::test
