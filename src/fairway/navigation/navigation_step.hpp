// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "fairway/map/bit_grid.hpp"
#include "fairway/mpc/solution.hpp"
#include "fairway/navigation/navigation_status.hpp"
#include "fairway/prediction/moving_obstacle.hpp"
#include "fairway/prediction/shared_motion.hpp"

namespace fairway {

/// What the navigator is told in a cycle. All times are on the caller's clock [s].
struct NavigationInput {
  double time = 0.0;             ///< now
  Pose2 pose;                    ///< of the robot, in the map's frame
  double pose_time = 0.0;        ///< when the pose was true
  MovingObstacles obstacles;     ///< what moves
  double obstacles_time = 0.0;   ///< when they were seen; irrelevant when there are none, unless
  bool obstacles_due = false;    ///< someone looks for them all the time: then "none" ages, too
  const BitGrid* map = nullptr;  ///< the newest static obstacles; must live through the call
  double map_time = 0.0;         ///< when they were seen; a fixed map is always as new as `time`
  Fleet fleet{};                 ///< what other robots told; they are not among the obstacles
  std::uint32_t robot = 0;       ///< its own number in the fleet
};

/// What the navigator answers.
struct NavigationStep {
  Twist2 command;  ///< to send until the next cycle; finite and within the limits
  NavigationStatus status = NavigationStatus::NoPlan;
  LimitingFactor limit = LimitingFactor::None;  ///< what limits the robot now
  bool wants_plan = false;            ///< ask a Planner for a new plan from here, then follow() it
  std::size_t rectangle = 0;          ///< the one the robot is in
  const MpcSolution* plan = nullptr;  ///< what it intends; valid until the next cycle; may be null
};

}  // namespace fairway
