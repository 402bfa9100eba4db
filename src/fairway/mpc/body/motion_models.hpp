// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <Eigen/Core>

#include "fairway/geometry/pose2.hpp"
#include "fairway/geometry/robot_model.hpp"

// The inputs of each kind of base and the twist that they cause. A solver is compiled for each
// model. Derivatives of the twist are ordered (linear, lateral, angular).

namespace fairway {

/// Two driven wheels. The inputs are the linear and the angular speed.
struct UnicycleMotion {
  static constexpr int kInputs = 2;
  static constexpr int kTurn = 1;  ///< the input that turns the body
  using Input = Eigen::Vector2d;

  [[nodiscard]] static PlanarTwist twist(const Input& input) noexcept {
    return {.linear = input[0], .lateral = 0.0, .angular = input[1]};
  }
  /// Computes the derivatives of the twist by the inputs.
  [[nodiscard]] static Eigen::Matrix<double, 3, 2> jacobian(const Input& /*input*/) noexcept {
    Eigen::Matrix<double, 3, 2> by_input = Eigen::Matrix<double, 3, 2>::Zero();
    by_input(0, 0) = 1.0;
    by_input(2, 1) = 1.0;
    return by_input;
  }
  /// Computes the second derivatives of (multiplier . twist) by the inputs.
  [[nodiscard]] static Eigen::Matrix2d hessian(const Input& /*input*/,
                                               const Eigen::Vector3d& /*multiplier*/) noexcept {
    return Eigen::Matrix2d::Zero();
  }
};

/// A steered wheel at distance `wheelbase` from a fixed axle: tricycle and car. The inputs are the
/// speed of the steered wheel and its angle, so the angle keeps its meaning at standstill. The
/// steering rate is the change of the second input.
struct SteeredMotion {
  static constexpr int kInputs = 2;
  static constexpr int kTurn = 1;
  using Input = Eigen::Vector2d;

  double wheelbase = 1.0;  ///< [m], positive

  [[nodiscard]] PlanarTwist twist(const Input& input) const noexcept {
    return {.linear = input[0] * std::cos(input[1]),
            .lateral = 0.0,
            .angular = input[0] * std::sin(input[1]) / wheelbase};
  }
  [[nodiscard]] Eigen::Matrix<double, 3, 2> jacobian(const Input& input) const noexcept {
    const double c = std::cos(input[1]);
    const double s = std::sin(input[1]);
    Eigen::Matrix<double, 3, 2> by_input = Eigen::Matrix<double, 3, 2>::Zero();
    by_input.col(0) << c, 0.0, s / wheelbase;
    by_input.col(1) << -input[0] * s, 0.0, input[0] * c / wheelbase;
    return by_input;
  }
  [[nodiscard]] Eigen::Matrix2d hessian(const Input& input,
                                        const Eigen::Vector3d& multiplier) const noexcept {
    const double c = std::cos(input[1]);
    const double s = std::sin(input[1]);
    const double mixed = -multiplier[0] * s + multiplier[2] * c / wheelbase;
    Eigen::Matrix2d by_input = Eigen::Matrix2d::Zero();
    by_input(0, 1) = by_input(1, 0) = mixed;
    by_input(1, 1) = -input[0] * (multiplier[0] * c + multiplier[2] * s / wheelbase);
    return by_input;
  }
};

/// Mecanum wheels or swerve modules. The inputs are the linear, lateral and angular speed.
struct OmniMotion {
  static constexpr int kInputs = 3;
  static constexpr int kTurn = 2;
  using Input = Eigen::Vector3d;

  [[nodiscard]] static PlanarTwist twist(const Input& input) noexcept {
    return {.linear = input[0], .lateral = input[1], .angular = input[2]};
  }
  [[nodiscard]] static Eigen::Matrix3d jacobian(const Input& /*input*/) noexcept {
    return Eigen::Matrix3d::Identity();
  }
  [[nodiscard]] static Eigen::Matrix3d hessian(const Input& /*input*/,
                                               const Eigen::Vector3d& /*multiplier*/) noexcept {
    return Eigen::Matrix3d::Zero();
  }
};

/// Integrates one step by the midpoint rule: it moves along the heading at the middle of the step.
[[nodiscard]] inline Pose2 midpoint_step(const Pose2& pose,
                                         const PlanarTwist& twist,
                                         double dt) noexcept {
  const Eigen::Vector2d move(dt * twist.linear, dt * twist.lateral);
  return {.position = pose.position + rotated(move, pose.heading + 0.5 * dt * twist.angular),
          .heading = pose.heading + dt * twist.angular};
}

}  // namespace fairway
