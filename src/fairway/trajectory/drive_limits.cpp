// SPDX-License-Identifier: Apache-2.0
#include "fairway/trajectory/drive_limits.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fairway::internal {

namespace {

using Eigen::Vector2d;

double angular_of(const BaseModel& base, const Inputs& v) noexcept {
  return twist_of(base, input_of(v)).angular;
}

// A point of the polytope of speeds: wheels as half-planes, tangents where they are round.
void add_wheel_constraints(Stage& stage, const BaseModel& base, const Inputs& next) {
  const PlanarTwist twist = twist_of(base, input_of(next));
  const auto add = [&](const Inputs& gradient, double load) {
    StageVector g = StageVector::Zero();
    g.segment<3>(kInputs) = gradient;
    g.segment<3>(kChanges) = gradient;
    constrain(stage, g, std::max(base.wheels.speed_max - load, -0.1 * base.wheels.speed_max));
  };
  const double now = base.wheels.speed_max * wheel_load(base, twist);
  switch (base.wheels.kind) {
    case WheelKind::None:
      return;
    case WheelKind::Differential: {
      const double half = 0.5 * base.wheels.track;
      for (const double a : {1.0, -1.0}) {
        for (const double b : {half, -half})
          add({a, 0.0, b}, a * twist.linear + b * twist.angular);
      }
      return;
    }
    case WheelKind::Mecanum:
      for (int i = 0; i < 8; ++i) {
        const Inputs sign((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0,
                          (i & 4) != 0 ? base.wheels.half_sum : -base.wheels.half_sum);
        add(sign, sign.dot(next));
      }
      return;
    case WheelKind::Swerve:
      for (int i = 0; i < base.wheels.num_modules; ++i) {
        const Vector2d& place = base.wheels.modules[static_cast<std::size_t>(i)];
        const Vector2d v(twist.linear - twist.angular * place.y(),
                         twist.lateral + twist.angular * place.x());
        constexpr int kTangents = 12;
        for (int t = 0; t < kTangents; ++t) {
          const Vector2d n = direction(2.0 * std::numbers::pi * t / kTangents);
          add({n.x(), n.y(), n.y() * place.x() - n.x() * place.y()}, n.dot(v));
        }
      }
      return;
    case WheelKind::Steered: {
      // |u| / cos(steering), linearised.
      const double sign = next.x() < 0.0 ? -1.0 : 1.0;
      const double c = std::cos(next.z());
      add({sign / c, 0.0, std::abs(next.x()) * std::sin(next.z()) / (c * c)}, now);
      return;
    }
  }
}

// Angular speed and acceleration of a steered base follow from speed and angle, linearised.
void add_angular_constraints(
    Stage& stage, const BaseModel& base, const Inputs& now, const Inputs& next, double step) {
  const auto slope_at = [&](const Inputs& v) {
    const double c = std::cos(v.z());
    return Inputs(std::tan(v.z()) / base.wheelbase, 0.0, v.x() / (base.wheelbase * c * c));
  };
  StageVector angular = StageVector::Zero();
  angular.segment<3>(kInputs) = slope_at(next);
  angular.segment<3>(kChanges) = slope_at(next);
  const double speed = angular_of(base, next);
  for (const double sign : {1.0, -1.0}) {
    constrain(stage, sign * angular,
              std::max(base.angular_max - sign * speed, -0.1 * base.angular_max));
  }
  // Its slope, (change of speed tan(angle) + speed change of angle / cos^2(angle)) / wheelbase per
  // step, is extreme at the ends of the step, or nearly so.
  const Inputs change = next - now;
  for (const double share : {0.0, 1.0}) {
    const Inputs at = now + share * change;
    const double tangent = std::tan(at.z());
    const double square = 1.0 + tangent * tangent;  // 1 / cos^2
    const Inputs along(change.z() * square, 0.0,
                       change.x() * square + 2.0 * at.x() * change.z() * square * tangent);
    StageVector gradient = StageVector::Zero();
    gradient.segment<3>(kInputs) = along / base.wheelbase;
    gradient.segment<3>(kChanges) =
        (share * along + Inputs(tangent, 0.0, at.x() * square)) / base.wheelbase;
    const double slope = (change.x() * tangent + at.x() * change.z() * square) / base.wheelbase;
    const double most = base.angular_acceleration;
    for (const double sign : {1.0, -1.0}) {
      StageVector g = sign * gradient;
      g(kStep) -= most;
      // What is exceeded is regained: a longer step is always possible.
      constrain(stage, g, std::max(most * step - sign * slope, -0.15 * most * step));
    }
  }
}

}  // namespace

InputLimits::InputLimits(const BaseModel& base) noexcept
    : low(base.linear_min, -base.lateral_max, -base.angular_max),
      high(base.linear_max, base.lateral_max, base.angular_max),
      slope(base.linear_acceleration, base.lateral_acceleration, base.angular_acceleration),
      lateral(base.kind == BaseKind::Omni) {
  if (!is_steered(base)) return;
  low.z() = -base.steering_max;
  high.z() = base.steering_max;
  slope.z() = base.steering_rate_max;
}

void constrain(Stage& stage, const StageVector& gradient, double bound) {
  stage.constraints.push_back({.gradient = gradient, .bound = bound});
}

void constrain_between(
    Stage& stage, const StageVector& gradient, double now, double low, double high, double trust) {
  constrain(stage, gradient, std::min(trust, std::max(high - now, 0.0)));
  constrain(stage, -gradient, std::min(trust, std::max(now - low, 0.0)));
}

void add_limits(Stage& stage,
                const BaseModel& base,
                const Inputs& now,
                const Inputs& next,
                double step,
                const TrustRegion& trust) {
  const InputLimits limits(base);
  const Inputs change = next - now;
  for (int i = 0; i < 3; ++i) {
    if (i == 1 && !limits.lateral) continue;
    StageVector input = StageVector::Zero();
    input(kInputs + i) = 1.0;
    input(kChanges + i) = 1.0;
    const double most = trust.input * std::max(limits.high(i), -limits.low(i));
    constrain_between(stage, input, next(i), limits.low(i), limits.high(i), most);
    for (const double sign : {1.0, -1.0}) {
      StageVector slope = StageVector::Zero();
      slope(kChanges + i) = sign;
      slope(kStep) = -limits.slope(i);
      constrain(stage, slope, std::max(limits.slope(i) * step - sign * change(i), 0.0));
    }
  }
  StageVector time = StageVector::Zero();
  time(kStep) = 1.0;
  constrain_between(stage, time, step, kShortestStep, kLongestStep, trust.step * step);
  add_wheel_constraints(stage, base, next);
  if (is_steered(base)) add_angular_constraints(stage, base, now, next, step);
}

}  // namespace fairway::internal
