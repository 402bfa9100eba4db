// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/geometry/robot_model.hpp"
#include "fairway/trajectory/trajectory.hpp"

namespace fairway {

/// The plant of a robot on any base: its input follows what it is sent as its limits allow.
struct BodyRobot {
  RobotModel model;
  Pose2 pose;
  BaseInput input{};  ///< actual
  BaseInput sent{};   ///< last command

  [[nodiscard]] PlanarTwist twist() const noexcept { return twist_of(model.base, input); }

  /// Moves for `dt` [s]: the input ramps linearly, the pose follows it.
  void advance(double dt) noexcept;
};

}  // namespace fairway
