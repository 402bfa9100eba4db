// SPDX-License-Identifier: Apache-2.0
#include "fairway/monitor/safety_monitor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>

#include "fairway/monitor/guarded_polygon.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr int kFractions = 32;
constexpr double kTravel = 0.005;    // of the body in a step of the simulation [m]
constexpr double kLongStep = 0.02;   // [s]
constexpr double kLongStop = 60.0;   // [s]; a stop that takes longer is none
constexpr double kAtRest = 1e-4;     // [m/s, rad/s]
constexpr double kRounding = 1e-9;   // [s]
constexpr double kForgotten = 10.0;  // [s]; after a pause the base moves as it was sent
constexpr std::size_t kMostSent = 1024;
constexpr double kFurthest = 1e7;  // [m]; beyond that a place is an error
constexpr double kFastest = 20.0;  // [m/s, rad/s]; beyond that a twist is an error

bool is_good(const Vector2d& point) noexcept {
  return std::abs(point.x()) <= kFurthest && std::abs(point.y()) <= kFurthest;
}

bool is_good(const Twist2& twist) noexcept {
  return std::abs(twist.linear) <= kFastest && std::abs(twist.angular) <= kFastest;
}

}  // namespace

SafetyMonitor::SafetyMonitor(MonitorSettings settings)
    : settings_(std::move(settings)),
      time_(-std::numeric_limits<double>::infinity()),
      linear_(linear_axis(settings_)),
      angular_(angular_axis(settings_)) {
  if (const auto valid = validate(settings_); !valid)
    throw std::invalid_argument(valid.error().message);
  for (const Polygon& polygon : settings_.footprint)
    for (const Vector2d& corner : polygon)
      radius_ = std::max(radius_, corner.norm());
  points_.reserve(kMostPoints);
  near_.reserve(kMostPoints);
  sent_.reserve(kMostSent);
  queue_.reserve(kMostSent + 2);
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
  if (std::isfinite(time) && is_good(current)) follow(time, current);
  if (!is_good(pose.position) || !std::isfinite(pose.heading) || !is_good(current) ||
      !is_good(command))
    return stop(MonitorReason::InvalidInput);
  if (!(std::abs(time - time_) <= settings_.max_age)) return stop(MonitorReason::Stale);  // or NaN
  MonitorVerdict verdict{command, 1.0, MonitorReason::None};
  const Eigen::Rotation2Dd to_robot(-pose.heading);
  const bool in_reach_only = settings_.stop_zone.empty() && settings_.slow_zone.empty();
  const double far = reach(command) + radius_ + settings_.margin;
  near_.clear();
  for (const Vector2d& point : points_) {
    const Vector2d local = to_robot * (point - pose.position);
    if (in_reach_only && local.norm() > far) continue;
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
    if (n == 0 || stops_in_time(verdict.command)) break;
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

// The base has had what was sent at the last check, until now.
void SafetyMonitor::follow(double time, const Twist2& sent) noexcept {
  const double elapsed = std::max(0.0, time - time_of_check_);  // 0 where the clock was set back
  time_of_check_ = time;
  if (!(elapsed <= kForgotten)) {
    linear_.begin(sent.linear);
    angular_.begin(sent.angular);
    sent_.clear();
    return;
  }
  if (sent_.size() == kMostSent) sent_.erase(sent_.begin());
  sent_.push_back({now_, sent});
  const double end = now_ + elapsed;
  while (now_ < end - kRounding) {
    const double change = std::min(linear_.obey(sent_, now_), angular_.obey(sent_, now_));
    const double step = std::min({end - now_, change, kLongStep});
    linear_.advance(step);
    angular_.advance(step);
    now_ += step;
  }
  now_ = end;
  const double old = now_ - std::max(linear_.delay, angular_.delay) - kLongStep;
  std::erase_if(sent_, [&](const SentCommand& s) { return s.time < old; });
}

// No further can the base get before it has stopped.
double SafetyMonitor::reach(const Twist2& command) const noexcept {
  double fastest = std::max(linear_.fastest(), std::abs(command.linear));
  for (const SentCommand& sent : sent_)
    fastest = std::max(fastest, std::abs(sent.command.linear));
  return fastest * (settings_.delay + settings_.hold + settings_.ramp + settings_.linear_lag) +
         0.5 * fastest * fastest / linear_.loss;
}

// Each of the two axes is slow or quick, so four bases are followed.
bool SafetyMonitor::stops_in_time(const Twist2& command) noexcept {
  queue_.assign(sent_.begin(), sent_.end());
  queue_.push_back({now_, command});
  queue_.push_back({now_ + settings_.hold, {}});
  MonitoredAxis linear = linear_;
  MonitoredAxis angular = angular_;
  std::array<Pose2, 4> bases{};
  std::array<double, 4> free{};  // each may move so far until a point is too near [m]
  const double last = now_ + settings_.hold + std::max(linear.delay, angular.delay);
  double t = now_;
  while (!near_.empty() && t - now_ <= kLongStop) {
    const double change = std::min(linear.obey(queue_, t), angular.obey(queue_, t));
    const double speed = linear.fastest() + radius_ * angular.fastest();
    if (t > last - kRounding && linear.fastest() < kAtRest && angular.fastest() < kAtRest)
      return true;
    const double step = std::min({change, kLongStep, kTravel / std::max(speed, kTravel)});
    const MonitoredAxis before = linear;
    const MonitoredAxis turn = angular;
    linear.advance(step);
    angular.advance(step);
    t += step;
    for (std::size_t i = 0; i < bases.size(); ++i) {
      const double v = i % 2 == 0 ? before.slow + linear.slow : before.quick + linear.quick;
      const double w = i / 2 == 0 ? turn.slow + angular.slow : turn.quick + angular.quick;
      Pose2& base = bases[i];
      const double middle = base.heading + 0.25 * step * w;
      base.position += 0.5 * step * v * Vector2d(std::cos(middle), std::sin(middle));
      base.heading += 0.5 * step * w;
      free[i] -= step * speed;
      if (free[i] <= 0.0 && (free[i] = clearance(base)) < 0.0) return false;
    }
  }
  return near_.empty();
}

// How far a base there may move until a point is too near to it; less than 0 where one is.
double SafetyMonitor::clearance(const Pose2& base) const noexcept {
  const Eigen::Rotation2Dd to_body(-base.heading);
  double least = std::numeric_limits<double>::infinity();
  for (const NearPoint& point : near_) {
    const Vector2d offset = point.position - base.position;
    const double outside = offset.norm() - radius_ - settings_.margin;
    least = std::min(least, outside > 0.0 ? outside : distance(to_body * offset) - point.least);
  }
  return least;
}

}  // namespace fairway
