// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "fairway/monitor/guarded_polygon.hpp"
#include "fairway/monitor/safety_monitor.hpp"

namespace fairway {

Expected<void> validate(const MonitorSettings& s) {
  if (s.footprint.empty() || !std::all_of(s.footprint.begin(), s.footprint.end(), is_polygon) ||
      !(s.stop_zone.empty() || is_polygon(s.stop_zone)) ||
      !(s.slow_zone.empty() || is_polygon(s.slow_zone))) {
    return fail("monitor: expected polygons of at least 3 corners, and at least one for the body");
  }
  const auto within = [](double value, double least, double most) {
    return value >= least && value <= most;
  };
  constexpr double kMostChange = 1000.0;  // of a speed [m/s^2, rad/s^2]
  constexpr double kLeastChange = 0.01;
  constexpr double kMostDelay = 6.0;  // [s]
  const auto change = [&](double gain, double loss) {
    return within(gain, kLeastChange, kMostChange) && within(loss, 0.0, kMostChange);
  };
  if (!change(s.linear_acceleration, s.linear_braking) ||
      !change(s.angular_acceleration, s.angular_braking) || !within(s.delay, 0.0, kMostDelay) ||
      !within(s.angular_delay.value_or(s.delay), 0.0, kMostDelay) ||
      !within(s.linear_lag, 0.0, 1.0) || !within(s.angular_lag, 0.0, 1.0) ||
      !within(s.ramp, 0.0, 1.0) || !within(s.slow_speed, 0.01, 10.0) ||
      !within(s.hold, 0.001, 20.0) || !within(s.margin, 0.0, 1.0) ||
      !within(s.max_age, 0.01, 1000.0))
    return fail("monitor: expected numbers in the ranges of MonitorSettings");
  return {};
}

}  // namespace fairway
