// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/geometry/oriented_rectangle.hpp"
#include "fairway/geometry/pose2.hpp"
#include "fairway/geometry/robot_settings.hpp"
#include "fairway/mpc/control_problem.hpp"
#include "fairway/mpc/mpc_settings.hpp"
#include "fairway/prediction/moving_obstacle.hpp"

namespace fairway {

/// The input of one optimal control problem in the paper's Algorithm 3.
struct PaperScene {
  Pose2 start;                ///< eta_t
  Twist2 previous_command;    ///< the twist that the robot executes now
  Pose2 current_target;       ///< eta_cg1; heading within pi of the start's
  Pose2 next_target;          ///< eta_cg2; heading within pi of the current target's
  OrientedRectangle region;   ///< current rectangle, already moved inward, Eq. (10)
  MovingObstacles obstacles;  ///< beyond kMaxObstacles only the first ones are used
  double robot_radius = 0.0;  ///< added to every obstacle's radius: keep-out distance [m]
};

/// The MPC settings of the paper's Table I: Euler steps, no weight on the first change. Table I
/// omits S: we use 0.1.
[[nodiscard]] MpcSettings paper_mpc_settings() noexcept;

/// The limits of Table I: at least 0.05 m/s, and no acceleration limit (1000 is never active).
[[nodiscard]] RobotSettings paper_robot_settings() noexcept;

/// Eq. (15): both targets at every step, every step in the one rectangle, constant velocities.
[[nodiscard]] ControlProblem paper_problem(const MpcSettings& mpc,
                                           const RobotSettings& robot,
                                           const PaperScene& scene) noexcept;

/// One obstacle of constant velocity over the horizon, with the keep-out distance `keep_out` [m].
void predict(const MovingObstacle& obstacle,
             double keep_out,
             const ControlProblem& problem,
             PredictedObstacle& prediction) noexcept;

}  // namespace fairway
