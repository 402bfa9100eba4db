// SPDX-License-Identifier: Apache-2.0
#include "bridge/command_guard.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace fairway::bridge {

namespace {

constexpr int kCorners = 32;  // of the polygon about a disc

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

// What of a robot the monitor needs to know.
struct Limits {
  double linear_min;
  double linear_max;
  double linear_acceleration;
  double angular_acceleration;
};

MonitorSettings monitor_settings(const Settings& settings,
                                 const Limits& robot,
                                 std::vector<Polygon> footprint) {
  constexpr double kLate = 1.5;  // periods from one command to the next, at most
  const double period = settings.navigation.control_period;
  return {
      .footprint = std::move(footprint),
      .linear_acceleration = std::clamp(robot.linear_acceleration, 0.2, 20.0),
      .angular_acceleration = std::clamp(robot.angular_acceleration, 0.2, 100.0),
      .delay = std::clamp(settings.safety.actuation_lag * period, 0.0, 1.0),
      .hold = std::clamp(kLate * period, 0.01, 1.0),
      // Less than what the navigator keeps, so that it does not limit what was proven.
      .margin = 0.5 * settings.safety.stop_margin,
      // The navigator brakes along its own ramp where scans stop; the monitor acts if it does not.
      .max_age =
          std::clamp(settings.safety.map_timeout + period +
                         std::max(robot.linear_max, -robot.linear_min) / robot.linear_acceleration,
                     0.01, 10.0)};
}

}  // namespace

MonitorSettings monitor_settings(const Settings& settings) {
  const RobotSettings& robot = settings.robot;
  return monitor_settings(settings,
                          {.linear_min = robot.linear_min,
                           .linear_max = robot.linear_max,
                           .linear_acceleration = robot.linear_acceleration_max,
                           .angular_acceleration = robot.angular_acceleration_max},
                          polygons_of(footprint_of(robot)));
}

MonitorSettings monitor_settings(const Settings& settings, const RobotModel& robot) {
  return monitor_settings(settings,
                          {.linear_min = robot.base.linear_min,
                           .linear_max = robot.base.linear_max,
                           .linear_acceleration = robot.base.linear_acceleration,
                           .angular_acceleration = robot.base.angular_acceleration},
                          polygons_of(robot.body));
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

void CommandGuard::observe(const LidarScan& scan) {
  if (!is_plausible(scan, scan.last_pose.position)) return;
  lay_beams(scan, std::numeric_limits<double>::infinity(), beams_);
  points_.clear();
  for (const Beam& beam : beams_) {
    if (beam.end == BeamEnd::Hit) points_.push_back(beam.to);
  }
  if (points_.size() > SafetyMonitor::kMostPoints) points_.resize(SafetyMonitor::kMostPoints);
  monitor_.see(scan.time, points_);
}

}  // namespace fairway::bridge
