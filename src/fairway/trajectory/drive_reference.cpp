// SPDX-License-Identifier: Apache-2.0
#include "fairway/trajectory/drive_reference.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "fairway/base/contract.hpp"
#include "fairway/trajectory/tracking_law.hpp"

namespace fairway {

DriveReference::DriveReference(const BaseModel& base,
                               std::vector<TrajectoryRow> rows,
                               double period)
    : base_(base),
      rows_(std::move(rows)),
      period_(period),
      duration_(period * static_cast<double>(rows_.size() - 1)) {
  FAIRWAY_EXPECTS(!rows_.empty() && period > 0.0);
}

Pose2 DriveReference::pose_at(double phase) const noexcept {
  if (rows_.empty()) return {};
  const double at = std::clamp(phase, 0.0, duration_) / period_;
  const std::size_t k = std::min(static_cast<std::size_t>(at), rows_.size() - 1);
  const double rest = (at - static_cast<double>(k)) * period_;
  return rest > 0.0 ? moved(rows_[k].pose, rows_[k].twist, rest) : rows_[k].pose;
}

// The rows hold means over their periods, which are the values in the middles of these.
BaseInput DriveReference::planned_at(double phase) const noexcept {
  if (rows_.empty()) return {};
  const double at = std::clamp(phase / period_ - 0.5, -0.5, static_cast<double>(rows_.size() - 1));
  const BaseInput first = resting_input(base_, rows_.front().input);
  if (at < 0.0) return (-2.0 * at) * first + (1.0 + 2.0 * at) * rows_.front().input;
  const std::size_t k = std::min(static_cast<std::size_t>(at), rows_.size() - 1);
  const double share = at - static_cast<double>(k);
  const BaseInput& next = k + 1 < rows_.size() ? rows_[k + 1].input : rows_[k].input;
  return (1.0 - share) * rows_[k].input + share * next;
}

BaseInput DriveReference::input_at(const DriveProgress& progress) const noexcept {
  const BaseInput planned = planned_at(progress.phase);
  return {.linear = progress.rate * planned.linear,
          .lateral = progress.rate * planned.lateral,
          .turn = is_steered(base_) ? planned.turn : progress.rate * planned.turn};
}

// The twist of the robot is rate x twist(phase). Its acceleration along every axis is therefore
// rate' x twist + rate^2 x twist'. Both limits of the base bound rate'.
DriveReference::RateBounds DriveReference::rate_bounds(
    const DriveProgress& progress) const noexcept {
  const double half = 0.5 * period_;
  const PlanarTwist before = twist_of(base_, planned_at(progress.phase - half));
  const PlanarTwist now = twist_of(base_, planned_at(progress.phase));
  const PlanarTwist after = twist_of(base_, planned_at(progress.phase + half));
  struct Axis {
    double speed;
    double slope;
    double limit;
  };
  const std::array<Axis, 3> axes{
      {{now.linear, (after.linear - before.linear) / period_, base_.linear_acceleration},
       {now.lateral, (after.lateral - before.lateral) / period_, base_.lateral_acceleration},
       {now.angular, (after.angular - before.angular) / period_, base_.angular_acceleration}}};
  RateBounds bounds{.low = -std::numeric_limits<double>::infinity(),
                    .high = std::numeric_limits<double>::infinity()};
  for (const Axis& axis : axes) {
    const double speed = std::abs(axis.speed);
    if (speed < 1e-6) continue;
    const double planned = progress.rate * progress.rate * std::copysign(1.0, axis.speed) *
                           std::clamp(axis.slope, -axis.limit, axis.limit);
    bounds.low = std::max(bounds.low, (-axis.limit - planned) / speed);
    bounds.high = std::min(bounds.high, (axis.limit - planned) / speed);
  }
  // A rate beyond 1 may leave no choice: then the change that exceeds a limit least.
  if (bounds.low > bounds.high) bounds.low = bounds.high = 0.5 * (bounds.low + bounds.high);
  return bounds;
}

DriveProgress DriveReference::advanced(const DriveProgress& progress,
                                       double target,
                                       double time) const noexcept {
  constexpr double kLongestStep = 0.02;  // [s]
  constexpr int kMostSteps = 64;
  const int steps = std::clamp(static_cast<int>(std::ceil(time / kLongestStep)), 1, kMostSteps);
  const double step = time / steps;
  DriveProgress now = progress;
  for (int i = 0; i < steps; ++i) {
    const RateBounds bounds = rate_bounds(now);
    const double rate =
        now.rate + std::clamp(target - now.rate, step * bounds.low, step * bounds.high);
    now.phase += 0.5 * step * (now.rate + rate);
    now.rate = rate;
    if (now.phase <= 0.0 && now.rate <= 0.0) now = {.phase = 0.0, .rate = 0.0};
    if (now.phase >= duration_) now = {.phase = duration_, .rate = 0.0};
  }
  return now;
}

}  // namespace fairway
