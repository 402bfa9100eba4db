// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>

#include "fairway/geometry/robot_settings.hpp"
#include "fairway/mpc/control_problem.hpp"
#include "fairway/mpc/mpc_settings.hpp"
#include "fairway/tracking/corridor_follower.hpp"
#include "fairway/tracking/tracking_settings.hpp"
#include "fairway/tracking/zone_speeds.hpp"

namespace fairway {

/// The motion from which the targets start.
struct TargetStart {
  double speed = 0.0;                    ///< along the reference path, at present [m/s]
  double lead = 0.0;                     ///< time from the pose to the start of the problem [s]
  double heading = 0.0;                  ///< of the robot [rad]
  std::optional<double> goal_heading{};  ///< heading at the end of the path [rad]
  /// Arc length up to which the path is known to be free [m]; the robot can stop before it.
  double free_length = std::numeric_limits<double>::infinity();
  const PathSpeedLimits* speed_limits = nullptr;  ///< of zones along the path; null for none
  /// Whether the targets stay at a corner where the path turns back, until the robot is there. At
  /// the tip between two strips it has no clearance to drive a curve, and targets on both sides of
  /// the tip would hold it before it.
  bool waits_at_reversals = false;
};

/// Sets one target per step, moving along the reference path as fast as limits and clearance allow;
/// the default method.
///
/// The speed increases from `start.speed` to linear_max within the acceleration limit. It decreases
/// in time for the turns of the path and for the goal. At a turn by angle a, a circle that deviates
/// from the corner by at most `corner_deviation` has the radius deviation / (1 / cos(a/2) - 1); the
/// angular speed limit bounds the speed on it. If the robot's heading differs too much, the targets
/// wait while it turns.
///
/// Heading: that of the chord from the target to the point `chord_length` further along, which does
/// not jump at corners. At the goal it is the goal's heading, if given. Headings are not wrapped:
/// each is within pi of `heading` and of the one before.
void set_timed_targets(const ReferencePath& path,
                       const TargetStart& start,
                       const TrackingSettings& tracking,
                       const MpcSettings& mpc,
                       const RobotSettings& robot,
                       ControlProblem& problem) noexcept;

}  // namespace fairway
