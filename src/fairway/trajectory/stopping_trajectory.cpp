// SPDX-License-Identifier: Apache-2.0
#include "fairway/trajectory/stopping_trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fairway {

namespace {

// Adds a step to an input, cut into equal ones none of which is too long.
void add_step(const BaseInput& to, double time, double longest, Trajectory& trajectory) {
  if (time < 1e-9) return;
  const BaseInput from = trajectory.inputs.back();
  const int count = std::max(1, static_cast<int>(std::ceil(time / longest)));
  for (int i = 1; i <= count; ++i) {
    const double share = static_cast<double>(i) / count;
    trajectory.inputs.push_back((1.0 - share) * from + share * to);
    trajectory.steps.push_back(time / count);
  }
}

double greatest_acceleration(const BaseModel& base, const PlanarTwist& twist) noexcept {
  double least = std::numeric_limits<double>::infinity();
  const auto bound = [&](double part, double limit) {
    if (std::abs(part) > 1e-12) least = std::min(least, limit / std::abs(part));
  };
  bound(twist.linear, base.linear_acceleration);
  bound(twist.lateral, base.lateral_acceleration);
  bound(twist.angular, base.angular_acceleration);
  return least;
}

}  // namespace

Trajectory stopping_trajectory(const BaseModel& base,
                               const MotionPath& path,
                               double longest_step,
                               double steering) {
  const bool steered = is_steered(base);
  Trajectory trajectory;
  trajectory.start = path.start;
  trajectory.inputs.push_back({.turn = steered ? steering : 0.0});
  for (const MotionPiece& piece : path.pieces) {
    if (steered) {
      const double angle = std::atan(base.wheelbase * piece.twist.angular / piece.twist.linear);
      add_step({.turn = angle}, std::abs(angle - steering) / base.steering_rate_max, longest_step,
               trajectory);
      trajectory.inputs.back().turn = angle;
      steering = angle;
    }
    const double fastest = 1.0 / speed_load(base, piece.twist);
    const double acceleration = greatest_acceleration(base, piece.twist);
    const double peak = std::min(fastest, std::sqrt(acceleration * piece.amount));
    const double ramp = peak / acceleration;
    const double cruise = std::max(0.0, piece.amount / peak - ramp);
    const BaseInput rest{.turn = steering};
    const BaseInput moving{.linear = peak * piece.twist.linear,
                           .lateral = peak * piece.twist.lateral,
                           .turn = steered ? steering : peak * piece.twist.angular};
    add_step(moving, ramp, longest_step, trajectory);
    add_step(moving, cruise, longest_step, trajectory);
    add_step(rest, ramp, longest_step, trajectory);
  }
  return trajectory;
}

BaseModel with_reserve(const BaseModel& base, double share, double speed_share) noexcept {
  BaseModel less = base;
  less.linear_min *= speed_share;
  less.linear_max *= speed_share;
  less.lateral_max *= speed_share;
  less.angular_max *= speed_share;
  less.linear_acceleration *= share;
  less.lateral_acceleration *= share;
  less.angular_acceleration *= share;
  less.steering_rate_max *= share;
  less.steering_max *= 1.0 - 0.05 * (1.0 - share);
  less.wheels.speed_max *= speed_share;
  return less;
}

}  // namespace fairway
