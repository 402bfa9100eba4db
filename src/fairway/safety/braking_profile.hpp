// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/base/fixed_vector.hpp"
#include "fairway/geometry/pose2.hpp"
#include "fairway/geometry/robot_settings.hpp"
#include "fairway/prediction/moving_obstacle.hpp"

namespace fairway {

/// Commands that bring the robot to a standstill, one per control period. After the last one the
/// robot is stopped.
using StopSequence = FixedVector<Twist2, 640>;

/// Returns the command of one cycle that leads from `current` towards `wanted`. Each speed changes
/// by no more than the acceleration limits allow in `period` [s].
[[nodiscard]] Twist2 limited_change(const Twist2& current,
                                    const Twist2& wanted,
                                    const RobotSettings& robot,
                                    double period) noexcept;

/// Brakes from `current` as hard as the limits allow, with one command per `period` [s].
[[nodiscard]] StopSequence brake_from(const Twist2& current,
                                      const RobotSettings& robot,
                                      double period) noexcept;

/// Number of pieces of a control period; the twist is taken as constant in each.
inline constexpr int kRampPieces = 4;

/// The mean twist in one of these pieces, while the base ramps linearly from `from` to `to`.
[[nodiscard]] Twist2 ramp_mean(const Twist2& from, const Twist2& to, int piece) noexcept;

/// Predicts where a robot is at the end of each control period during a command and the stop after
/// it. The robot is at `pose`, moves with `current`, and executes `command` and then `stop` from
/// its command number `done` on. The first sample is now; the last one is where it stops. Cycles
/// beyond the last sample that fits are left out.
[[nodiscard]] SampledMotion stop_track(const Pose2& pose,
                                       const Twist2& current,
                                       const Twist2& command,
                                       const StopSequence& stop,
                                       std::size_t done,
                                       double period,
                                       double time) noexcept;

}  // namespace fairway
