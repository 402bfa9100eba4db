// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/dead_reckoning.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/geometry/angle.hpp"
#include "fairway/mpc/control_problem.hpp"

namespace fairway {

namespace {

constexpr double kIntegrationStep = 0.025;  // [s] of integration
constexpr double kLongest = 2.0;            // [s] that are looked back
constexpr double kTrusted = 0.5;            // [s] of agreement, until other poses are taken
constexpr double kTurnTolerance = 0.4;      // [rad], and half of the turn made since

}  // namespace

void DeadReckoning::reset(const Twist2& actual) noexcept {
  history_.reset(actual);
  last_ = {};
  other_ = {};
}

void DeadReckoning::sent(double time, const Twist2& command, const Twist2& ramp) noexcept {
  if (std::isfinite(time)) history_.send(time, command, ramp);
}

void DeadReckoning::shift_times(double shift) noexcept {
  history_.shift_times(shift);
  for (Known* known : {&last_, &other_}) {
    known->since += shift;
    known->time += shift;
  }
}

Twist2 DeadReckoning::twist_at(double time) const noexcept {
  return {.linear = history_.ramped(time - linear_shift_).linear,
          .angular = history_.ramped(time - angular_shift_).angular};
}

Pose2 DeadReckoning::advanced(const Pose2& pose, double from, double to) const noexcept {
  const double duration = std::min(to - from, kLongest);
  if (!(duration > 1e-9)) return pose;
  const int steps = 1 + static_cast<int>(duration / kIntegrationStep);
  const double h = duration / steps;
  Pose2 at = pose;
  for (int i = 0; i < steps; ++i)
    at = step(at, twist_at(from + (i + 0.5) * h), h, Integration::Midpoint);
  return at;
}

bool DeadReckoning::agree(const Known& last,
                          const Pose2& pose,
                          double time,
                          double tolerance) const noexcept {
  if (!last.exists) return false;
  const Pose2 expected = advanced(last.pose, last.time, time);
  const double way = (expected.position - last.pose.position).norm();
  const double turn = std::abs(expected.heading - last.pose.heading);
  return (pose.position - expected.position).norm() <= tolerance + 0.5 * way &&
         std::abs(shortest_turn(expected.heading, pose.heading)) <= kTurnTolerance + 0.5 * turn;
}

bool DeadReckoning::fits(const Pose2& pose, double time, double tolerance) noexcept {
  const Known now{.exists = true, .since = time, .time = time, .pose = pose};
  const Twist2& latest = history_.latest();
  const bool stands = std::abs(latest.linear) < 1e-3 && std::abs(latest.angular) < 1e-3;
  bool fit = !last_.exists || time - last_.time > kLongest || agree(last_, pose, time, tolerance);
  if (!fit) {
    const double since =
        agree(other_, pose, time, tolerance) && time >= other_.time ? other_.since : time;
    other_ = now;
    other_.since = since;
    fit = stands && time - since >= kTrusted - 1e-9;
  }
  if (!fit) return false;
  last_ = now;
  other_ = {};
  return true;
}

}  // namespace fairway
