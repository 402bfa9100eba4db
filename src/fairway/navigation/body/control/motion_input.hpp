// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "fairway/mpc/body/body_problem.hpp"
#include "fairway/trajectory/trajectory.hpp"

// The inputs and limits of a base in the form of the optimal control problem.

namespace fairway {

/// The model of a base that a solver is compiled for.
template <typename Motion>
[[nodiscard]] Motion motion_of(const BaseModel& base) noexcept {
  if constexpr (requires { Motion::wheelbase; }) return Motion{.wheelbase = base.wheelbase};
  return Motion{};
}

/// Converts an input. That of a steered base has the speed of the steered wheel.
template <typename Motion>
[[nodiscard]] typename Motion::Input solver_input(const BaseInput& input) noexcept {
  if constexpr (Motion::kInputs == 3) {
    return {input.linear, input.lateral, input.turn};
  } else if constexpr (requires { Motion::wheelbase; }) {
    return {input.linear / std::cos(input.turn), input.turn};
  } else {
    return {input.linear, input.turn};
  }
}

/// The inverse of `solver_input`.
template <typename Motion>
[[nodiscard]] BaseInput base_input(const typename Motion::Input& input) noexcept {
  if constexpr (Motion::kInputs == 3) {
    return {.linear = input[0], .lateral = input[1], .turn = input[2]};
  } else if constexpr (requires { Motion::wheelbase; }) {
    return {.linear = input[0] * std::cos(input[1]), .lateral = 0.0, .turn = input[1]};
  } else {
    return {.linear = input[0], .lateral = 0.0, .turn = input[1]};
  }
}

/// Limits of sums of the inputs by the wheels. Those of swerve modules are squares about their
/// circles: what is sent is limited exactly afterwards.
template <typename Motion>
void set_wheel_limits(const WheelLimit& wheels, BodyProblem<Motion>& problem) noexcept {
  const auto add = [&](const typename Motion::Input& normal) {
    if (problem.num_input_limits >= kMaxInputLimits) return;
    problem.input_limits[static_cast<std::size_t>(problem.num_input_limits++)] = {
        .normal = normal, .bound = wheels.speed_max};
  };
  problem.num_input_limits = 0;
  if constexpr (Motion::kInputs == 3) {
    if (wheels.kind == WheelKind::Mecanum) {
      for (const double side : {1.0, -1.0}) {
        for (const double turn : {wheels.half_sum, -wheels.half_sum})
          add({1.0, side, turn});
      }
    }
    if (wheels.kind != WheelKind::Swerve) return;
    for (int i = 0; i < wheels.num_modules; ++i) {
      const Eigen::Vector2d& at = wheels.modules[static_cast<std::size_t>(i)];
      add({1.0, 0.0, -at.y()});
      add({0.0, 1.0, at.x()});
    }
  } else if (wheels.kind == WheelKind::Differential) {
    add({1.0, 0.5 * wheels.track});
    add({1.0, -0.5 * wheels.track});
  }
}

/// Sets the limits of a base for steps of `problem.dt`.
template <typename Motion>
void set_base(const BaseModel& base, BodyProblem<Motion>& problem) noexcept {
  problem.motion = motion_of<Motion>(base);
  const double dt = problem.dt;
  const bool steered = is_steered(base);
  const double most_turn = steered ? base.steering_max : base.angular_max;
  const double turn_change = steered ? base.steering_rate_max : base.angular_acceleration;
  if constexpr (Motion::kInputs == 3) {
    problem.input_min = {base.linear_min, -base.lateral_max, -most_turn};
    problem.input_max = {base.linear_max, base.lateral_max, most_turn};
    problem.max_change =
        dt * Eigen::Vector3d(base.linear_acceleration, base.lateral_acceleration, turn_change);
  } else {
    double low = base.linear_min;
    double high = base.linear_max;
    if (steered && base.wheels.kind == WheelKind::Steered) {
      low = std::max(low, -base.wheels.speed_max);
      high = base.wheels.speed_max;
    }
    problem.input_min = {low, -most_turn};
    problem.input_max = {high, most_turn};
    problem.max_change = dt * Eigen::Vector2d(base.linear_acceleration, turn_change);
  }
  set_wheel_limits(base.wheels, problem);
}

}  // namespace fairway
