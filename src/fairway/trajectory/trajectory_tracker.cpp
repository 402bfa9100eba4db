// SPDX-License-Identifier: Apache-2.0
#include "fairway/trajectory/trajectory_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fairway/base/contract.hpp"
#include "fairway/geometry/angle.hpp"

namespace fairway {

TrajectoryTracker::TrajectoryTracker(const BaseModel& base,
                                     std::vector<TrajectoryRow> rows,
                                     double period,
                                     const TrackingGains& gains)
    : base_(base),
      rows_(std::move(rows)),
      period_(period),
      gains_(gains) {
  FAIRWAY_EXPECTS(!rows_.empty() && period > 0.0);
}

void TrajectoryTracker::reset() noexcept {
  next_ = 0;
  sent_ = {};
}

BaseInput TrajectoryTracker::update(const Pose2& pose) noexcept {
  if (finished()) return sent_ = limited({.turn = is_steered(base_) ? sent_.turn : 0.0});
  const TrajectoryRow& row = rows_[next_++];
  if (!is_finite(pose)) return sent_ = limited({.turn = is_steered(base_) ? sent_.turn : 0.0});
  return sent_ = limited(corrected(row, pose));
}

BaseInput TrajectoryTracker::corrected(const TrajectoryRow& row, const Pose2& pose) const noexcept {
  // The place to be at, seen from the robot.
  const Eigen::Vector2d ahead = inverse_transform(pose, row.pose.position);
  const double turn = shortest_turn(pose.heading, row.pose.heading);
  const double speed = row.input.linear;
  BaseInput input = row.input;
  if (base_.kind == BaseKind::Omni) {
    if (next_ == rows_.size()) return input;
    input.linear += gains_.along * ahead.x();
    input.lateral += gains_.along * ahead.y();
    input.turn += gains_.turning * turn;
    return input;
  }
  // Corrections act while the base drives: at rest a wheeled base cannot move sideways anyway.
  const double driving = std::min(1.0, std::abs(speed) / (0.1 * base_.linear_max));
  input.linear += driving * gains_.along * ahead.x();
  const double side = speed < 0.0 ? -1.0 : 1.0;
  const double bend = gains_.across * ahead.y() + side * gains_.heading * turn;
  if (is_steered(base_)) {
    const double curvature = std::tan(row.input.turn) / base_.wheelbase + driving * bend;
    input.turn = std::atan(base_.wheelbase * curvature);
  } else {
    const bool turning = std::abs(row.input.turn) > 0.05 * base_.angular_max;
    input.turn += speed * bend + (turning ? gains_.turning * turn * (1.0 - driving) : 0.0);
  }
  return input;
}

BaseInput TrajectoryTracker::limited(const BaseInput& wanted) const noexcept {
  const auto step = [&](double from, double to, double limit) {
    return std::clamp(to, from - limit * period_, from + limit * period_);
  };
  BaseInput input = wanted;
  input.linear = std::clamp(input.linear, base_.linear_min, base_.linear_max);
  const bool steered = is_steered(base_);
  const double most_turn = steered ? base_.steering_max : base_.angular_max;
  input.turn = std::clamp(input.turn, -most_turn, most_turn);
  if (base_.kind == BaseKind::Omni)
    input.lateral = std::clamp(input.lateral, -base_.lateral_max, base_.lateral_max);
  input.linear = step(sent_.linear, input.linear, base_.linear_acceleration);
  input.lateral = step(sent_.lateral, input.lateral, base_.lateral_acceleration);
  input.turn =
      step(sent_.turn, input.turn, steered ? base_.steering_rate_max : base_.angular_acceleration);
  // What remains, wheels and the angular limits of a steered base: closer to what was sent before,
  // which kept them.
  const auto keeps = [&](const BaseInput& candidate) {
    constexpr double kRounding = 1.0 + 1e-9;
    const PlanarTwist twist = twist_of(base_, candidate);
    const double change = std::abs(twist.angular - twist_of(base_, sent_).angular);
    return speed_load(base_, twist) <= kRounding &&
           change <= kRounding * base_.angular_acceleration * period_;
  };
  constexpr int kHalvings = 12;
  double share = 1.0;
  for (int i = 0; i < kHalvings && !keeps(input); ++i) {
    share *= 0.7;
    input = sent_ + share * (input + -1.0 * sent_);
  }
  return keeps(input) ? input : sent_;
}

}  // namespace fairway
