// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/geometry/pose2.hpp"
#include "fairway/geometry/robot_settings.hpp"
#include "fairway/prediction/moving_obstacle.hpp"

namespace fairway {

/// Commands that bring the robot to a standstill, one per control period.
struct StopSequence {
  static constexpr int kMaxLength = 640;
  int count = 0;  ///< after the last one the robot is stopped
  std::array<Twist2, kMaxLength> commands;
};

/// The command of one cycle on the way from `current` to `wanted`: each speed changed by no more
/// than the acceleration limits allow in `period` [s].
[[nodiscard]] Twist2 limited_change(const Twist2& current,
                                    const Twist2& wanted,
                                    const RobotSettings& robot,
                                    double period) noexcept;

/// Braking from `current` as hard as the limits allow, one command per `period` [s].
[[nodiscard]] StopSequence brake_from(const Twist2& current,
                                      const RobotSettings& robot,
                                      double period) noexcept;

/// Pieces of a control period in each of which the twist is taken as constant.
inline constexpr int kRampPieces = 4;

/// The mean twist in one of these pieces, while the base ramps linearly from `from` to `to`.
[[nodiscard]] Twist2 ramp_mean(const Twist2& from, const Twist2& to, int piece) noexcept;

/// Where a robot at `pose` that moves with `current` now will be at the end of each control period
/// while it executes `command` and then `stop` from its command number `done` on; the first sample
/// is now. Cycles beyond those that fit are left out, and the last sample is where it stops.
[[nodiscard]] SampledMotion stop_track(const Pose2& pose,
                                       const Twist2& current,
                                       const Twist2& command,
                                       const StopSequence& stop,
                                       int done,
                                       double period,
                                       double time) noexcept;

}  // namespace fairway
