// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/proof/body_deviation.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/safety/base_response.hpp"

namespace fairway {

namespace {

double turn_rate_limit(const BaseModel& base) noexcept {
  return is_steered(base) ? base.steering_rate_max : base.angular_acceleration;
}

SpeedChange quick_axis(double now, double sent, double limit, double time) noexcept {
  return quick_change(now, sent, {.acceleration = limit, .braking = limit}, time);
}

// By how much a speed was greater before than it is now, in the direction of motion.
double loss(double now, double least, double greatest) noexcept {
  return now >= 0.0 ? greatest - now : now - least;
}

}  // namespace

double change_time(const BaseModel& base, const BaseInput& from, const BaseInput& to) noexcept {
  const bool omni = base.kind == BaseKind::Omni;
  return std::max({std::abs(to.linear - from.linear) / base.linear_acceleration,
                   omni ? std::abs(to.lateral - from.lateral) / base.lateral_acceleration : 0.0,
                   std::abs(to.turn - from.turn) / turn_rate_limit(base)});
}

BaseInput quick_input(const BaseModel& base,
                      const BaseInput& now,
                      const BaseInput& sent,
                      double time) noexcept {
  return {.linear = quick_axis(now.linear, sent.linear, base.linear_acceleration, time).end,
          .lateral = quick_axis(now.lateral, sent.lateral, base.lateral_acceleration, time).end,
          .turn = quick_axis(now.turn, sent.turn, turn_rate_limit(base), time).end};
}

BodyDeviation::BodyDeviation(const BaseModel& base, const BodyManoeuvre& manoeuvre) noexcept
    : base_(base),
      quick_(manoeuvre.quick),
      later_(manoeuvre.later),
      both_(manoeuvre.later + manoeuvre.earlier),
      least_(twist_of(base, manoeuvre.input)),
      greatest_(least_) {}

BodyPiece BodyDeviation::next(const BaseInput& from,
                              const BaseInput& to,
                              const BaseInput& target,
                              double duration) noexcept {
  const BaseInput mean = 0.5 * (from + to);
  const SpeedChange linear =
      quick_axis(quick_.linear, target.linear, base_.linear_acceleration, duration);
  const SpeedChange lateral =
      quick_axis(quick_.lateral, target.lateral, base_.lateral_acceleration, duration);
  const SpeedChange turn = quick_axis(quick_.turn, target.turn, turn_rate_limit(base_), duration);
  quick_ = {.linear = linear.end, .lateral = lateral.end, .turn = turn.end};
  const PlanarTwist slow = twist_of(base_, mean);
  const double speed =
      std::max(std::hypot(slow.linear, slow.lateral), std::hypot(linear.mean, lateral.mean));
  BodyPiece piece{.from = from, .to = to, .duration = duration, .further = {0.0, 0.0}};
  along_ += duration * Eigen::Vector2d(linear.mean - mean.linear, lateral.mean - mean.lateral);
  const double before = std::abs(turned_);
  if (is_steered(base_)) {
    piece.bend = std::tan(mean.turn) / base_.wheelbase;
    turned_ += duration * speed * (std::tan(turn.mean) / base_.wheelbase - piece.bend);
  } else {
    turned_ += duration * (turn.mean - mean.turn);
  }
  const double turned = std::max(before, std::abs(turned_));
  aside_ += duration * speed * turned;
  // A steered base that is further along its path has also turned further.
  piece.turned = turned + std::abs(piece.bend) * along_.norm();
  piece.apart = along_.norm();
  const double ahead = std::max(0.0, slow.linear >= 0.0 ? along_.x() : -along_.x());
  piece.further.x() = std::copysign(ahead, slow.linear);
  spread(slow, duration, piece);
  piece.aside = aside_ + std::abs(along_.y());
  return piece;
}

// A base that follows later has gained, at each time, at most that time times what its speed has
// changed by since.
void BodyDeviation::spread(const PlanarTwist& slow, double duration, BodyPiece& piece) noexcept {
  if (both_ <= 0.0) return;
  const auto widen = [&](double PlanarTwist::*axis) {
    least_.*axis = std::min(least_.*axis, slow.*axis);
    greatest_.*axis = std::max(greatest_.*axis, slow.*axis);
    return std::copysign(loss(slow.*axis, least_.*axis, greatest_.*axis), slow.*axis);
  };
  const Eigen::Vector2d slower(widen(&PlanarTwist::linear), widen(&PlanarTwist::lateral));
  const double turns_less = widen(&PlanarTwist::angular);
  piece.further += later_ * slower;
  // What is gained on a path that still turns is not all gained in the direction of its end. Where
  // only one of two speeds is late, the base is beside the line on which both are.
  aside_ += std::abs(slow.angular) * duration * both_ * slower.norm();
  if (is_steered(base_)) {
    const double steering = std::atan(std::abs(piece.bend) * base_.wheelbase);
    const double most = std::min(base_.steering_max, steering + both_ * base_.steering_rate_max);
    piece.bend_change = std::tan(most) / base_.wheelbase - std::abs(piece.bend);
  } else {
    piece.turned_late = later_ * turns_less;
  }
}

}  // namespace fairway
