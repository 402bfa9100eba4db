// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/targets.hpp"

#include "fairway/tracking/waypoint_targets.hpp"

namespace fairway {

void set_targets(const TargetInput& input,
                 const TrackingSettings& tracking,
                 const MpcSettings& mpc,
                 const RobotSettings& robot,
                 ControlProblem& problem) noexcept {
  switch (tracking.target_mode) {
    case TargetMode::ReferencePath:
      set_timed_targets(input.path, input.start, tracking, mpc, robot, problem);
      break;
    case TargetMode::DualWaypoints:
      set_dual_targets(input.corridor, input.goal, input.pose, mpc, problem);
      break;
    case TargetMode::OverlapCentroid:
      set_centroid_target(input.corridor, input.goal, input.pose, mpc, problem);
      break;
  }
}

}  // namespace fairway
