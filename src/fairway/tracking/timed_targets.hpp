// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>

#include "fairway/geometry/robot_settings.hpp"
#include "fairway/mpc/control_problem.hpp"
#include "fairway/mpc/mpc_settings.hpp"
#include "fairway/tracking/corridor_follower.hpp"
#include "fairway/tracking/tracking_settings.hpp"

namespace fairway {

/// The motion from which targets start.
struct TargetStart {
  double speed = 0.0;                    ///< along the reference path, now [m/s]
  double lead = 0.0;                     ///< time from the pose to the start of the problem [s]
  double heading = 0.0;                  ///< of the robot [rad]
  std::optional<double> goal_heading{};  ///< at the end of the path [rad]
  /// Arc length up to which the path is known to be free [m]: the robot can stop before it.
  double free_length = std::numeric_limits<double>::infinity();
};

/// Sets one target per step, moving along the reference path as fast as the robot may and can: our
/// default.
///
/// Speed: from `start.speed` up with the acceleration limit to linear_max, down in time for the
/// path's turns and for the goal. At a turn by angle a, a circle that leaves the corner by at most
/// `corner_deviation` has radius deviation / (1 / cos(a/2) - 1), and the angular speed limit bounds
/// the speed on it. A robot with another heading turns first: the targets wait. Heading: the chord
/// from the target to the point `chord_length` further on, which does not jump where the path
/// does; at the goal the goal's heading, if it has one. Not wrapped: within pi of `heading` and of
/// the step before.
void set_timed_targets(const ReferencePath& path,
                       const TargetStart& start,
                       const TrackingSettings& tracking,
                       const MpcSettings& mpc,
                       const RobotSettings& robot,
                       ControlProblem& problem) noexcept;

}  // namespace fairway
