// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/geometry/oriented_rectangle.hpp"
#include "fairway/geometry/pose2.hpp"
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

/// The parts of the problem that the settings alone decide: horizon, model, limits, weights.
/// A change limit too wide to bind is left out. @pre 1 <= settings.horizon <= kMaxHorizon
[[nodiscard]] ControlProblem problem_from_settings(const MpcSettings& settings,
                                                   const Twist2& previous_command) noexcept;

/// Eq. (15): both targets at every step, every step in the one rectangle, constant velocities.
[[nodiscard]] ControlProblem paper_problem(const MpcSettings& settings,
                                           const PaperScene& scene) noexcept;

/// One obstacle of constant velocity over the horizon, keeping `keep_out` [m] from its centre.
void predict(const MovingObstacle& obstacle,
             double keep_out,
             const ControlProblem& problem,
             PredictedObstacle& prediction) noexcept;

}  // namespace fairway
