// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/solution.hpp"
#include "fairway/navigation/navigation_status.hpp"
#include "fairway/navigation/settings.hpp"
#include "fairway/prediction/moving_obstacle.hpp"

namespace fairway {

/// Horizon, start, weights and limits of one cycle; no regions, no obstacles, no targets.
///
/// Where the last command is outside the speed range (a limit was lowered), the range is widened
/// just so far that the acceleration limit can be kept on the way back: acceleration wins over
/// speed.
void set_limits(const Settings& settings,
                const Pose2& pose,
                const Twist2& last_command,
                ControlProblem& problem) noexcept;

/// The nearest kMaxObstacles moving obstacles at constant velocity over the horizon.
/// @param age  How long ago they were seen [s]; they are moved on by as much.
void set_predictions(const Settings& settings,
                     MovingObstacles obstacles,
                     double age,
                     const Eigen::Vector2d& position,
                     ControlProblem& problem) noexcept;

/// The row that holds a plan back, in the words of the navigator.
[[nodiscard]] Limit limit_of(const RowName& row) noexcept;

/// Angular speed for the rest of a turn on the spot: fast at first, and able to stop at its end
/// [rad/s].
[[nodiscard]] double turning_speed(double turn, const MpcSettings& limits) noexcept;

}  // namespace fairway
