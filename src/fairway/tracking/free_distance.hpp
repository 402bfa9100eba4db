// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/geometry/robot_settings.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/prediction/moving_obstacle.hpp"
#include "fairway/tracking/corridor_follower.hpp"

namespace fairway {

/// Returns the length along the reference path for which a disc of `radius` [m] is free, at most
/// `limit` [m].
///
/// The test advances in steps of 0.1 m, so the result may be too short by that much, never too
/// long. If the disc is not free at the start, it is reduced to the size that is, because the robot
/// already is there.
[[nodiscard]] double free_length(const BitGrid& obstacles,
                                 const ReferencePath& path,
                                 double radius,
                                 double limit) noexcept;

/// Returns the distance along the reference path within which the robot must be able to stop [m].
/// This is the length that is free for it. The result is infinite if the whole path is free, or
/// free beyond what matters at the robot's greatest speed.
/// @param horizon  Time that the controller plans ahead [s].
[[nodiscard]] double distance_to_stop_in(const BitGrid& obstacles,
                                         const ReferencePath& path,
                                         const RobotSettings& robot,
                                         double horizon) noexcept;

/// A robot that follows a path among moving obstacles.
struct FollowingRobot {
  const RobotSettings& robot;
  double speed = 0.0;     ///< now [m/s]
  double reaction = 0.0;  ///< time until it brakes [s]
  double distance = 0.0;  ///< that it is to keep from the obstacles, beyond both radii [m]
  double horizon = 0.0;   ///< how far ahead the controller plans [s]
};

/// Returns the distance along the path at which the robot must be able to stop because of a moving
/// obstacle [m]. The result is infinite without one.
///
/// The robot follows the obstacle: it brakes in time to have the obstacle's speed along the path at
/// the distance to keep. The distance that is closed within the reaction time is added. This is
/// only for robots whose braking distance is more than half of what the horizon can hold; the
/// controller brakes the others in time by itself.
/// @param age  How long ago the obstacles were seen [s].
[[nodiscard]] double distance_to_follow_in(MovingObstacles obstacles,
                                           double age,
                                           const ReferencePath& path,
                                           const FollowingRobot& following) noexcept;

}  // namespace fairway
