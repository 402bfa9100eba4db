// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/geometry/robot_settings.hpp"
#include "fairway/mpc/solution.hpp"
#include "fairway/prediction/moving_obstacle.hpp"
#include "fairway/prediction/shared_motion.hpp"

namespace fairway {

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
void set_predictions(const PredictionSettings& settings,
                     const RobotSettings& robot,
                     const MovingAround& around,
                     const Eigen::Vector2d& position,
                     ControlProblem& problem) noexcept;

/// Angular speed for the rest of a turn on the spot: fast at first, and able to stop at its end
/// [rad/s].
[[nodiscard]] double turning_speed(double turn, const RobotSettings& robot, double period) noexcept;

}  // namespace fairway
