// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "fairway/mpc/control_problem.hpp"
#include "fairway/mpc/mpc_settings.hpp"
#include "fairway/planning/planner.hpp"
#include "fairway/tracking/corridor_follower.hpp"

namespace fairway {

/// Sets the two targets of the paper, Eq. (15): the seeds of the next two rectangles, or the goal
/// after the last. They equal one target at their weighted mean, which can leave the robot stuck
/// (docs/paper_notes.md).
void set_dual_targets(const CorridorFollower& corridor,
                      const Goal& goal,
                      const Pose2& pose,
                      const MpcSettings& settings,
                      ControlProblem& problem) noexcept;

/// Sets the single target of SMPC [17]: the centroid of the next overlap, or the goal in the last
/// rectangle.
void set_centroid_target(const CorridorFollower& corridor,
                         const Goal& goal,
                         const Pose2& pose,
                         const MpcSettings& settings,
                         ControlProblem& problem) noexcept;

}  // namespace fairway
