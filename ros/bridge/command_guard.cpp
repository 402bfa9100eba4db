// SPDX-License-Identifier: Apache-2.0
#include "bridge/command_guard.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "fairway/geometry/angle.hpp"

namespace fairway::bridge {

namespace {

constexpr int kCorners = 64;  // of the polygon about a disc

Polygon polygon_about(const Eigen::Vector2d& center, double radius) {
  Polygon polygon;
  const double corner = radius / std::cos(std::numbers::pi / kCorners);
  for (int i = 0; i < kCorners; ++i)
    polygon.push_back(center + corner * direction(2.0 * std::numbers::pi * i / kCorners));
  return polygon;
}

std::vector<Polygon> polygons_of(const Footprint& body) {
  if (body.is_rectangle()) {
    const auto corners = body.rectangle_at({}).corners();
    return {Polygon(corners.begin(), corners.end())};
  }
  std::vector<Polygon> polygons;
  for (int i = 0; i < body.num_discs(); ++i)
    polygons.push_back(polygon_about(body.disc_at(i).center, body.disc_at(i).radius));
  return polygons;
}

std::vector<Polygon> polygons_of(const BodyShape& body) {
  std::vector<Polygon> polygons;
  for (const ConvexPart& part : body.parts()) {
    if (part.count < 3 || part.radius > 0.0) {
      polygons.clear();
      for (const Footprint::Disc& disc : body.cover())
        polygons.push_back(polygon_about(disc.center, disc.radius));
      return polygons;
    }
    polygons.emplace_back(part.vertices.begin(), part.vertices.begin() + part.count);
  }
  return polygons;
}

// What does not depend on the kind of the base.
MonitorSettings monitor_settings(const Settings& settings, std::vector<Polygon> footprint) {
  const double period = settings.navigation.control_period;
  MonitorSettings monitor;
  monitor.footprint = std::move(footprint);
  monitor.ramp = period;
  monitor.hold = settings.safety.longest_hold * period;
  // Less than what the navigator keeps, so that it does not limit what was proven.
  monitor.margin = 0.5 * settings.safety.stop_margin;
  return monitor;
}

// Half a period is the mean delay of a base that ramps from command to command; that is `ramp`.
double further_delay(const Settings& settings) noexcept {
  constexpr double kRamp = 0.5;  // periods
  return std::max(0.0, settings.safety.actuation_lag - kRamp) * settings.navigation.control_period;
}

// The navigator brakes along its own ramp where scans stop; the monitor acts if it does not.
double oldest_scan(const Settings& settings, const MonitorSettings& monitor, double speed) {
  const double braking =
      monitor.linear_braking > 0.0 ? monitor.linear_braking : monitor.linear_acceleration;
  return settings.safety.map_timeout + monitor.hold + monitor.delay + monitor.linear_lag +
         speed / braking;
}

}  // namespace

MonitorSettings monitor_settings(const Settings& settings) {
  const RobotSettings& robot = settings.robot;
  MonitorSettings monitor = monitor_settings(settings, polygons_of(footprint_of(robot)));
  monitor.linear_acceleration = robot.linear_acceleration_max;
  monitor.angular_acceleration = robot.angular_acceleration_max;
  monitor.linear_braking = robot.linear_braking_max;
  monitor.angular_braking = robot.angular_braking_max;
  monitor.delay = robot.linear_delay + further_delay(settings);
  monitor.angular_delay = robot.angular_delay + further_delay(settings);
  monitor.linear_lag = robot.linear_lag;
  monitor.angular_lag = robot.angular_lag;
  monitor.max_age = oldest_scan(settings, monitor, std::max(robot.linear_max, -robot.linear_min));
  return monitor;
}

MonitorSettings monitor_settings(const Settings& settings, const RobotModel& robot) {
  MonitorSettings monitor = monitor_settings(settings, polygons_of(robot.body));
  const BaseModel& base = robot.base;
  monitor.linear_acceleration = base.linear_acceleration;
  monitor.angular_acceleration = base.angular_acceleration;
  monitor.delay = base.response_time;
  monitor.max_age = oldest_scan(settings, monitor, std::max(base.linear_max, -base.linear_min));
  return monitor;
}

const char* to_text(MonitorReason reason) noexcept {
  switch (reason) {
    case MonitorReason::None:
      return "none";
    case MonitorReason::InvalidInput:
      return "invalid input";
    case MonitorReason::Stale:
      return "no new scan";
    case MonitorReason::StopZone:
      return "stop zone";
    case MonitorReason::SlowZone:
      return "slow zone";
    case MonitorReason::Obstacle:
      return "obstacle";
  }
  return "unknown";
}

CommandGuard::Source& CommandGuard::source_at(const Pose2& mount) {
  constexpr double kSame = 0.01;  // [m], [rad]
  for (Source& source : sources_) {
    if ((source.mount.position - mount.position).norm() < kSame &&
        std::abs(shortest_turn(source.mount.heading, mount.heading)) < kSame)
      return source;
  }
  return sources_.emplace_back(Source{.mount = mount, .time = 0.0, .points = {}});
}

void CommandGuard::observe(const LidarScan& scan, const Pose2& mount) {
  if (!is_plausible(scan, scan.last_pose.position)) return;
  lay_beams(scan, std::numeric_limits<double>::infinity(), beams_);
  Source& source = source_at(mount);
  source.time = scan.time;
  source.points.clear();
  for (const Beam& beam : beams_) {
    if (beam.end == BeamEnd::Hit) source.points.push_back(beam.to);
  }
  // A lidar that ceased is forgotten; the navigator notices it.
  std::erase_if(sources_, [&](const Source& s) { return std::abs(scan.time - s.time) > max_age_; });
  points_.clear();
  for (const Source& each : sources_)
    points_.insert(points_.end(), each.points.begin(), each.points.end());
  if (points_.size() > SafetyMonitor::kMostPoints) {
    const Eigen::Vector2d here = scan.last_pose.position;
    const auto last = points_.begin() + static_cast<std::ptrdiff_t>(SafetyMonitor::kMostPoints);
    std::nth_element(points_.begin(), last, points_.end(), [&](const auto& a, const auto& b) {
      return (a - here).squaredNorm() < (b - here).squaredNorm();
    });
    points_.erase(last, points_.end());
  }
  monitor_.see(scan.time, points_);
}

}  // namespace fairway::bridge
