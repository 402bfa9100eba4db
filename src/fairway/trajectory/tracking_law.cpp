// SPDX-License-Identifier: Apache-2.0
#include "fairway/trajectory/tracking_law.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/geometry/angle.hpp"

namespace fairway {

BaseInput corrected_input(const BaseModel& base,
                          const TrackingGains& gains,
                          const Pose2& reference,
                          const BaseInput& input,
                          const Pose2& pose) noexcept {
  // The place to be at, seen from the robot.
  const Eigen::Vector2d ahead = inverse_transform(pose, reference.position);
  const double turn = shortest_turn(pose.heading, reference.heading);
  const double speed = input.linear;
  BaseInput wanted = input;
  if (base.kind == BaseKind::Omni) {
    wanted.linear += gains.along * ahead.x();
    wanted.lateral += gains.along * ahead.y();
    wanted.turn += gains.turning * turn;
    return wanted;
  }
  // Corrections act while the base drives: at rest a wheeled base cannot move sideways anyway.
  const double driving = std::min(1.0, std::abs(speed) / (0.1 * base.linear_max));
  wanted.linear += driving * gains.along * ahead.x();
  const double side = speed < 0.0 ? -1.0 : 1.0;
  const double bend = gains.across * ahead.y() + side * gains.heading * turn;
  if (is_steered(base)) {
    const double curvature = std::tan(input.turn) / base.wheelbase + driving * bend;
    wanted.turn = std::atan(base.wheelbase * curvature);
  } else {
    const bool turning = std::abs(input.turn) > 0.05 * base.angular_max;
    wanted.turn += speed * bend + (turning ? gains.turning * turn * (1.0 - driving) : 0.0);
  }
  return wanted;
}

BaseInput limited_input(const BaseModel& base,
                        const BaseInput& sent,
                        const BaseInput& wanted,
                        double period) noexcept {
  const auto step = [&](double from, double to, double limit) {
    return std::clamp(to, from - limit * period, from + limit * period);
  };
  BaseInput input = wanted;
  input.linear = std::clamp(input.linear, base.linear_min, base.linear_max);
  const bool steered = is_steered(base);
  const double most_turn = steered ? base.steering_max : base.angular_max;
  input.turn = std::clamp(input.turn, -most_turn, most_turn);
  if (base.kind == BaseKind::Omni)
    input.lateral = std::clamp(input.lateral, -base.lateral_max, base.lateral_max);
  BaseInput target = input;
  input.linear = step(sent.linear, input.linear, base.linear_acceleration);
  input.lateral = step(sent.lateral, input.lateral, base.lateral_acceleration);
  input.turn =
      step(sent.turn, input.turn, steered ? base.steering_rate_max : base.angular_acceleration);
  // What remains: wheels, and the angular limits of a steered base.
  const auto keeps = [&](const BaseInput& candidate) {
    constexpr double kRounding = 1.0 + 1e-9;
    const PlanarTwist twist = twist_of(base, candidate);
    const double change = std::abs(twist.angular - twist_of(base, sent).angular);
    return speed_load(base, twist) <= kRounding &&
           change <= kRounding * base.angular_acceleration * period;
  };
  if (keeps(input)) return input;
  // One speed falls more slowly than the other one rises. All in proportion, the wheels keep their
  // limit: what is wanted keeps it, and so does everything between that and what was sent.
  const double load = speed_load(base, twist_of(base, target));
  if (load > 1.0) {
    target.linear /= load;
    target.lateral /= load;
    if (!steered) target.turn /= load;
  }
  const BaseInput change = target + -1.0 * sent;
  const auto share_of = [&](double difference, double limit) {
    return std::abs(difference) > limit * period ? limit * period / std::abs(difference) : 1.0;
  };
  const double share = std::min(
      {share_of(change.linear, base.linear_acceleration),
       share_of(change.lateral, base.lateral_acceleration),
       share_of(change.turn, steered ? base.steering_rate_max : base.angular_acceleration)});
  input = sent + share * change;
  // A steered base turns by a function of both inputs: closer to what was sent, which kept it.
  constexpr int kTries = 12;
  constexpr double kCloser = 0.7;
  double part = share;
  for (int i = 0; i < kTries && !keeps(input); ++i) {
    part *= kCloser;
    input = sent + part * change;
  }
  return keeps(input) ? input : sent;
}

BaseInput settling_input(const BaseModel& base,
                         const Pose2& goal,
                         const BaseInput& sent,
                         const Pose2& pose,
                         double tolerance) noexcept {
  constexpr double kGain = 2.0;     // [1/s]
  constexpr double kSlow = 0.08;    // [m/s]
  constexpr double kTurning = 0.2;  // [rad/s]
  const Eigen::Vector2d ahead = inverse_transform(pose, goal.position);
  const double turn = shortest_turn(pose.heading, goal.heading);
  const auto towards = [&](double error, double most) {
    return std::abs(error) < tolerance ? 0.0 : std::clamp(kGain * error, -most, most);
  };
  BaseInput input = resting_input(base, sent);
  input.linear = towards(ahead.x(), kSlow);
  if (is_steered(base)) return input;
  if (base.kind == BaseKind::Omni) input.lateral = towards(ahead.y(), kSlow);
  input.turn = towards(turn, kTurning);
  return input;
}

BaseInput resting_input(const BaseModel& base, const BaseInput& input) noexcept {
  return {.linear = 0.0, .lateral = 0.0, .turn = is_steered(base) ? input.turn : 0.0};
}

bool is_at_rest(const BaseModel& base, const BaseInput& input) noexcept {
  constexpr double kRest = 1e-9;
  return std::abs(input.linear) < kRest && std::abs(input.lateral) < kRest &&
         (is_steered(base) || std::abs(input.turn) < kRest);
}

}  // namespace fairway
