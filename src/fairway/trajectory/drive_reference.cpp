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
                               double period,
                               const std::optional<BaseInput>& begin)
    : base_(base),
      rows_(std::move(rows)),
      period_(period),
      duration_(period * static_cast<double>(rows_.size() - 1)) {
  FAIRWAY_EXPECTS(!rows_.empty() && period > 0.0);
  begin_ = begin.value_or(resting_input(base_, rows_.front().input));
  begin_twist_ = twist_of(base_, begin_);
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
  if (at < 0.0) return (-2.0 * at) * begin_ + (1.0 + 2.0 * at) * rows_.front().input;
  const std::size_t k = std::min(static_cast<std::size_t>(at), rows_.size() - 1);
  const double share = at - static_cast<double>(k);
  const BaseInput& next = k + 1 < rows_.size() ? rows_[k + 1].input : rows_[k].input;
  return (1.0 - share) * rows_[k].input + share * next;
}

// The same for the twists of the rows.
PlanarTwist DriveReference::twist_at(double phase) const noexcept {
  if (rows_.empty()) return {};
  const auto mixed = [](double share, const PlanarTwist& a, const PlanarTwist& b) {
    return PlanarTwist{.linear = (1.0 - share) * a.linear + share * b.linear,
                       .lateral = (1.0 - share) * a.lateral + share * b.lateral,
                       .angular = (1.0 - share) * a.angular + share * b.angular};
  };
  const double at = std::clamp(phase / period_ - 0.5, -0.5, static_cast<double>(rows_.size() - 1));
  if (at < 0.0) return mixed(1.0 + 2.0 * at, begin_twist_, rows_.front().twist);
  const std::size_t k = std::min(static_cast<std::size_t>(at), rows_.size() - 1);
  const std::size_t next = std::min(k + 1, rows_.size() - 1);
  return mixed(at - static_cast<double>(k), rows_[k].twist, rows_[next].twist);
}

BaseInput DriveReference::input_at(const DriveProgress& progress) const noexcept {
  const BaseInput planned = planned_at(progress.phase);
  return {.linear = progress.rate * planned.linear,
          .lateral = progress.rate * planned.lateral,
          .turn = is_steered(base_) ? planned.turn : progress.rate * planned.turn};
}

std::array<DriveReference::Axis, 3> DriveReference::axes_at(double phase) const noexcept {
  const double half = 0.5 * period_;
  const PlanarTwist before = twist_at(phase - half);
  const PlanarTwist now = twist_at(phase);
  const PlanarTwist after = twist_at(phase + half);
  return {{{now.linear, (after.linear - before.linear) / period_, base_.linear_acceleration},
           {now.lateral, (after.lateral - before.lateral) / period_, base_.lateral_acceleration},
           {now.angular, (after.angular - before.angular) / period_, base_.angular_acceleration}}};
}

// The twist of the robot is rate x twist(phase). Its acceleration along every axis is therefore
// rate' x twist + rate^2 x twist'. Both limits of the base bound rate'.
DriveReference::RateBounds DriveReference::rate_bounds(
    const DriveProgress& progress) const noexcept {
  const std::array<Axis, 3> axes = axes_at(progress.phase);
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

// With b = rate^2 and b' its slope over the phase, the acceleration along an axis is
// speed b' / 2 + slope b. That is linear in both, so the greatest b follows from one pass from the
// end, for braking, and one from the begin, for accelerating.
void DriveReference::limit_rate(std::vector<double> most) {
  FAIRWAY_EXPECTS(most.empty() || most.size() == rows_.size());
  greatest_rates_ = std::move(most);
  std::vector<double>& b = greatest_rates_;
  if (b.empty()) return;
  constexpr double kShare = 0.95;  // of the accelerations; the rest is for control
  constexpr double kSlow = 1e-6;
  for (double& rate : b)
    rate *= rate;
  for (std::size_t k = b.size() - 1; k-- > 0;) {
    for (const Axis& axis : axes_at(static_cast<double>(k) * period_)) {
      if (std::abs(axis.speed) < kSlow) continue;
      const double limit = kShare * axis.limit;
      const double pull = 0.5 * axis.speed / period_;
      const double factor = std::clamp(axis.slope, -limit, limit) - pull;
      // -limit <= pull b_next + factor b <= limit
      if (factor > 0.0) b[k] = std::min(b[k], (limit - pull * b[k + 1]) / factor);
      if (factor < 0.0) b[k] = std::min(b[k], (limit + pull * b[k + 1]) / -factor);
    }
  }
  for (std::size_t k = 0; k + 1 < b.size(); ++k) {
    for (const Axis& axis : axes_at(static_cast<double>(k) * period_)) {
      if (std::abs(axis.speed) < kSlow) continue;
      const double limit = kShare * axis.limit;
      const double along = std::copysign(1.0, axis.speed);
      const double planned = along * std::clamp(axis.slope, -limit, limit) * b[k];
      const double gain = 2.0 * period_ * (limit - planned) / std::abs(axis.speed);
      b[k + 1] = std::min(b[k + 1], b[k] + gain);
    }
  }
  for (double& square : b)
    square = std::sqrt(std::max(0.0, square));
}

double DriveReference::greatest_rate(double phase) const noexcept {
  if (greatest_rates_.empty()) return 1.0;
  const double at = std::clamp(phase, 0.0, duration_) / period_;
  const std::size_t k = std::min(static_cast<std::size_t>(at), greatest_rates_.size() - 1);
  const std::size_t next = std::min(k + 1, greatest_rates_.size() - 1);
  const double share = at - static_cast<double>(k);
  return (1.0 - share) * greatest_rates_[k] + share * greatest_rates_[next];
}

DriveProgress DriveReference::advanced(const DriveProgress& progress,
                                       double target,
                                       double time,
                                       double longest_step) const noexcept {
  constexpr int kMostSteps = 64;
  const int steps =
      std::clamp(static_cast<int>(std::ceil(time / longest_step - 1e-9)), 1, kMostSteps);
  const double step = time / steps;
  DriveProgress now = progress;
  for (int i = 0; i < steps; ++i) {
    const RateBounds bounds = rate_bounds(now);
    const double most = greatest_rate(now.phase + step * now.rate);
    const double wanted = std::clamp(target, -most, most);
    const double rate =
        now.rate + std::clamp(wanted - now.rate, step * bounds.low, step * bounds.high);
    now.phase += 0.5 * step * (now.rate + rate);
    now.rate = rate;
    if (now.phase <= 0.0 && now.rate <= 0.0) now = {.phase = 0.0, .rate = 0.0};
    if (now.phase >= duration_) now = {.phase = duration_, .rate = 0.0};
  }
  return now;
}

}  // namespace fairway
