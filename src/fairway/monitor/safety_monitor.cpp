// SPDX-License-Identifier: Apache-2.0
#include "fairway/monitor/safety_monitor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr int kFractions = 32;
constexpr double kTravel = 0.01;   // of the body in a step of the simulation [m]
constexpr double kFurthest = 1e7;  // [m]; beyond that a place is an error
constexpr double kFastest = 20.0;  // [m/s, rad/s]; beyond that a twist is an error

bool is_good(const Vector2d& point) noexcept {
  return std::abs(point.x()) <= kFurthest && std::abs(point.y()) <= kFurthest;
}

bool is_good(const Twist2& twist) noexcept {
  return std::abs(twist.linear) <= kFastest && std::abs(twist.angular) <= kFastest;
}

// Negative inside.
double signed_distance(const Polygon& polygon, const Vector2d& point) noexcept {
  double least = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d from = polygon[i] - point;
    const Vector2d to = polygon[(i + 1) % polygon.size()] - point;
    const Vector2d edge = to - from;
    const double share = std::clamp(-from.dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (from + share * edge).norm());
    if ((from.y() > 0.0) != (to.y() > 0.0) && from.x() - from.y() * edge.x() / edge.y() > 0.0)
      inside = !inside;
  }
  return inside ? -least : least;
}

}  // namespace

SafetyMonitor::SafetyMonitor(MonitorSettings settings)
    : settings_(std::move(settings)),
      time_(-std::numeric_limits<double>::infinity()) {
  if (const auto valid = validate(settings_); !valid)
    throw std::invalid_argument(valid.error().message);
  for (const Polygon& polygon : settings_.footprint)
    for (const Vector2d& corner : polygon)
      radius_ = std::max(radius_, corner.norm());
  points_.reserve(kMostPoints);
  near_.reserve(kMostPoints);
}

bool SafetyMonitor::see(double time, std::span<const Vector2d> points) noexcept {
  const auto bad = [](const Vector2d& point) { return !is_good(point); };
  if (!std::isfinite(time) || points.size() > kMostPoints || std::ranges::any_of(points, bad))
    return false;
  points_.assign(points.begin(), points.end());
  time_ = time;
  return true;
}

MonitorVerdict SafetyMonitor::check(double time,
                                    const Pose2& pose,
                                    const Twist2& current,
                                    const Twist2& command) noexcept {
  const auto stop = [](MonitorReason reason) { return MonitorVerdict{{}, 0.0, reason}; };
  if (!is_good(pose.position) || !std::isfinite(pose.heading) || !is_good(current) ||
      !is_good(command))
    return stop(MonitorReason::InvalidInput);
  if (!(std::abs(time - time_) <= settings_.max_age)) return stop(MonitorReason::Stale);  // or NaN
  MonitorVerdict verdict{command, 1.0, MonitorReason::None};
  const Eigen::Rotation2Dd to_robot(-pose.heading);
  near_.clear();
  for (const Vector2d& point : points_) {
    const Vector2d local = to_robot * (point - pose.position);
    const double away = distance(local);
    near_.push_back({local, std::min(settings_.margin, away)});
    if (away <= 0.0) continue;  // a part of the robot itself is in no zone
    if (signed_distance(settings_.stop_zone, local) <= 0.0) return stop(MonitorReason::StopZone);
    if (signed_distance(settings_.slow_zone, local) <= 0.0 &&
        std::abs(command.linear) * verdict.fraction > settings_.slow_speed) {
      verdict = {{}, settings_.slow_speed / std::abs(command.linear), MonitorReason::SlowZone};
    }
  }
  const double most = verdict.fraction;
  for (int n = kFractions; n >= 0; --n) {
    verdict.fraction = most * n / kFractions;
    verdict.command = {.linear = verdict.fraction * command.linear,
                       .angular = verdict.fraction * command.angular};
    if (n == 0 || stops_in_time(current, verdict.command)) break;
    verdict.reason = MonitorReason::Obstacle;
  }
  return verdict;
}

double SafetyMonitor::distance(const Vector2d& point) const noexcept {
  double least = std::numeric_limits<double>::infinity();
  for (const Polygon& polygon : settings_.footprint)
    least = std::min(least, signed_distance(polygon, point));
  return least;
}

bool SafetyMonitor::stops_in_time(Twist2 twist, const Twist2& command) const noexcept {
  const double fastest = std::max(std::abs(twist.linear), std::abs(command.linear)) +
                         radius_ * std::max(std::abs(twist.angular), std::abs(command.angular));
  const double step = std::min(settings_.hold, kTravel / std::max(fastest, kTravel));
  const double end = settings_.delay + settings_.hold;
  const Twist2 before = twist;
  const auto change = [&](double& speed, double wanted, double acceleration) {
    const double old = speed;
    speed += std::clamp(wanted - speed, -step * acceleration, step * acceleration);
    return 0.5 * step * (old + speed);
  };
  Vector2d position = Vector2d::Zero();
  double heading = 0.0;
  for (double t = 0.0; t < end || twist.linear != 0.0 || twist.angular != 0.0; t += step) {
    const Twist2 wanted = t < settings_.delay ? before : t < end ? command : Twist2{};
    const double length = change(twist.linear, wanted.linear, settings_.linear_acceleration);
    const double turn = change(twist.angular, wanted.angular, settings_.angular_acceleration);
    const double middle = heading + 0.5 * turn;
    position += length * Vector2d(std::cos(middle), std::sin(middle));
    heading += turn;
    const Eigen::Rotation2Dd to_body(-heading);
    for (const NearPoint& point : near_) {
      const Vector2d offset = point.position - position;
      if (offset.norm() > radius_ + settings_.margin) continue;
      if (distance(to_body * offset) < point.least) return false;
    }
  }
  return true;
}

}  // namespace fairway
