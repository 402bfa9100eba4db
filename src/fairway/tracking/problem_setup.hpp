// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/geometry/robot_settings.hpp"
#include "fairway/mpc/solution.hpp"
#include "fairway/prediction/moving_obstacle.hpp"

namespace fairway {

/// The moving obstacles and robots around a robot.
struct MovingAround {
  MovingObstacles obstacles;
  double age = 0.0;   ///< time from their measurement to the start of the problem [s]
  Fleet fleet{};      ///< other robots
  double time = 0.0;  ///< time of the start of the problem, on the fleet's clock [s]
};

/// Sets predictions over the horizon for the nearest kMaxObstacles moving obstacles and robots.
/// Obstacles move at constant velocity, and other robots along their published plans.
///
/// The distance to keep is that of the bodies plus `obstacle_margin`. For obstacles it grows by
/// `obstacle_growth` per second ahead. It also includes what straight motion between two steps can
/// come closer than at the steps.
void set_predictions(const PredictionSettings& settings,
                     const RobotSettings& robot,
                     const MovingAround& around,
                     const Eigen::Vector2d& position,
                     ControlProblem& problem) noexcept;

/// Returns the angular speed for the rest of a turn on the spot [rad/s]. It is high at first and
/// allows to stop at the end.
[[nodiscard]] double turning_speed(double turn, const RobotSettings& robot, double period) noexcept;

}  // namespace fairway
