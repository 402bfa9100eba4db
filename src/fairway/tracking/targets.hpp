// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/planning/plan.hpp"
#include "fairway/tracking/timed_targets.hpp"

namespace fairway {

/// What the targets of a cycle depend on.
struct TargetInput {
  const CorridorFollower& corridor;
  const ReferencePath& path;  ///< the corridor's, or a detour
  const Goal& goal;
  const Pose2& pose;  ///< of the robot
  TargetStart start;
};

/// Sets the targets of all steps as `tracking.target_mode` says.
void set_targets(const TargetInput& input,
                 const TrackingSettings& tracking,
                 const MpcSettings& mpc,
                 const RobotSettings& robot,
                 ControlProblem& problem) noexcept;

}  // namespace fairway
