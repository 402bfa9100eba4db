// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/planning/plan.hpp"
#include "fairway/tracking/timed_targets.hpp"

namespace fairway {

/// Input from which the targets of a cycle are computed.
struct TargetInput {
  const CorridorFollower& corridor;
  const ReferencePath& path;  ///< the corridor's reference path, or a detour
  const Goal& goal;
  const Pose2& pose;  ///< pose of the robot
  TargetStart start;
};

/// Sets the targets of all steps by the method that `tracking.target_mode` selects.
void set_targets(const TargetInput& input,
                 const TrackingSettings& tracking,
                 const MpcSettings& mpc,
                 const RobotSettings& robot,
                 ControlProblem& problem) noexcept;

}  // namespace fairway
