// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/navigation/body/drive/drive_follower.hpp"
#include "fairway/prediction/moving_obstacle.hpp"

namespace fairway {

/// Makes the message of a robot with a body to the other robots, after a cycle. The robot's number
/// is left to the caller.
/// @param pose       At the begin of the cycle.
/// @param under_way  Whether it follows a drive.
[[nodiscard]] SharedMotion report_body(const BodyShape& body,
                                       const DriveFollower& follower,
                                       const Pose2& pose,
                                       double time,
                                       double period,
                                       bool under_way) noexcept;

}  // namespace fairway
