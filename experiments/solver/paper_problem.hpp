// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/geometry/oriented_rectangle.hpp"
#include "fairway/geometry/pose2.hpp"
#include "fairway/geometry/robot_settings.hpp"
#include "fairway/mpc/control_problem.hpp"
#include "fairway/mpc/mpc_settings.hpp"
#include "fairway/prediction/moving_obstacle.hpp"

namespace fairway {

/// What one cycle of the paper's Algorithm 3 hands to its optimal control problem.
struct PaperScene {
  Pose2 start;                ///< eta_t
  Twist2 previous_command;    ///< what the robot executes now
  Pose2 current_target;       ///< eta_cg1; heading within pi of the start's
  Pose2 next_target;          ///< eta_cg2; heading within pi of the current target's
  OrientedRectangle region;   ///< current rectangle, already moved inward, Eq. (10)
  MovingObstacles obstacles;  ///< beyond kMaxObstacles the first ones count
  double robot_radius = 0.0;  ///< added to every obstacle's radius: keep-out distance [m]
};

/// The MPC settings of the paper's Table I, where it gives a value: Euler steps, no weight on the
/// first change. Table I omits S: we take 0.1.
[[nodiscard]] MpcSettings paper_mpc_settings() noexcept;

/// The limits of Table I: never slower than 0.05 m/s, and no acceleration limit (1000 never binds).
[[nodiscard]] RobotSettings paper_robot_settings() noexcept;

/// Eq. (15): both targets at every step, every step in the one rectangle, constant velocities.
[[nodiscard]] ControlProblem paper_problem(const MpcSettings& mpc,
                                           const RobotSettings& robot,
                                           const PaperScene& scene) noexcept;

/// One obstacle of constant velocity over the horizon, keeping `keep_out` [m] from its centre.
void predict(const MovingObstacle& obstacle,
             double keep_out,
             const ControlProblem& problem,
             PredictedObstacle& prediction) noexcept;

}  // namespace fairway
