// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "fairway/monitor/safety_monitor.hpp"

namespace fairway {

namespace {

bool is_polygon(const Polygon& polygon) noexcept {
  constexpr double kFurthest = 100.0;  // corner from the robot [m]
  const auto bad = [](const Eigen::Vector2d& corner) {
    return !(corner.cwiseAbs().maxCoeff() <= kFurthest && corner.allFinite());
  };
  return polygon.size() >= 3 && std::none_of(polygon.begin(), polygon.end(), bad) &&
         std::adjacent_find(polygon.begin(), polygon.end()) == polygon.end() &&
         polygon.front() != polygon.back();
}

}  // namespace

Expected<void> validate(const MonitorSettings& s) {
  if (s.footprint.empty() || !std::all_of(s.footprint.begin(), s.footprint.end(), is_polygon) ||
      !(s.stop_zone.empty() || is_polygon(s.stop_zone)) ||
      !(s.slow_zone.empty() || is_polygon(s.slow_zone))) {
    return fail("monitor: expected polygons of at least 3 corners, and at least one for the body");
  }
  const auto within = [](double value, double least, double most) {
    return value >= least && value <= most;
  };
  if (!within(s.slow_speed, 0.01, 10.0) || !within(s.linear_acceleration, 0.2, 20.0) ||
      !within(s.angular_acceleration, 0.2, 100.0) || !within(s.delay, 0.0, 1.0) ||
      !within(s.hold, 0.01, 1.0) || !within(s.margin, 0.0, 1.0) || !within(s.max_age, 0.01, 10.0))
    return fail("monitor: expected numbers in the ranges of MonitorSettings");
  return {};
}

}  // namespace fairway
