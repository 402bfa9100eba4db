// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/solution.hpp"
#include "fairway/navigation/navigation_status.hpp"
#include "fairway/navigation/settings.hpp"
#include "fairway/prediction/moving_obstacle.hpp"
#include "fairway/prediction/shared_motion.hpp"

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

/// What moves around a robot, and how it is known.
struct MovingAround {
  MovingObstacles obstacles;
  double age = 0.0;   ///< how long before the start of the problem they were seen [s]
  Fleet fleet{};      ///< other robots
  double time = 0.0;  ///< of the start of the problem, on the fleet's clock [s]
};

/// The nearest kMaxObstacles of what moves, over the horizon: obstacles at constant velocity, other
/// robots as they told that they intend.
///
/// The distance to keep is that of the bodies and `obstacle_margin`, grown for obstacles by
/// `obstacle_growth` per second ahead, and by what straight motion between two steps can come
/// nearer than at the steps.
void set_predictions(const Settings& settings,
                     const MovingAround& around,
                     const Eigen::Vector2d& position,
                     ControlProblem& problem) noexcept;

/// The row that holds a plan back, in the words of the navigator.
[[nodiscard]] Limit limit_of(const RowName& row) noexcept;

/// Angular speed for the rest of a turn on the spot: fast at first, and able to stop at its end
/// [rad/s].
[[nodiscard]] double turning_speed(double turn, const MpcSettings& limits) noexcept;

}  // namespace fairway
