// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "fairway/map/bit_grid.hpp"
#include "fairway/mpc/solution.hpp"
#include "fairway/navigation/navigation_status.hpp"
#include "fairway/prediction/moving_obstacle.hpp"
#include "fairway/prediction/shared_motion.hpp"

namespace fairway {

/// What is measured for a control cycle. All times are on one clock of the caller's [s]; without a
/// time a measurement is as new as `time`.
struct Measurements {
  double time = 0.0;  ///< now
  Pose2 pose;         ///< of the robot: position [m], heading [rad], in the frame of map and goal
  std::optional<double> pose_time{};       ///< when the pose was true
  MovingObstacles obstacles{};             ///< moving obstacles that others track
  std::optional<double> obstacles_time{};  ///< when they were seen
  bool obstacles_due = false;  ///< a tracker runs all the time: an empty list must be new, too
  std::optional<double> map_time{};  ///< when a changing map was up to date; a fixed one always is
  Fleet fleet{};                     ///< other robots, which are not among the obstacles
  std::uint32_t robot = 0;           ///< the robot's own number in the fleet
};

/// What the navigator works on in a cycle: measurements, and the map. Times as in Measurements.
struct NavigationInput {
  double time = 0.0;             ///< now
  Pose2 pose;                    ///< of the robot, in the map's frame
  double pose_time = 0.0;        ///< when the pose was true
  MovingObstacles obstacles;     ///< moving obstacles
  double obstacles_time = 0.0;   ///< when they were seen; irrelevant when there are none, unless
  bool obstacles_due = false;    ///< a tracker runs all the time: an empty list ages, too
  const BitGrid* map = nullptr;  ///< the newest static obstacles; must live through the call
  double map_time = 0.0;         ///< when they were seen; a fixed map is always as new as `time`
  Fleet fleet{};                 ///< other robots, which are not among the obstacles
  std::uint32_t robot = 0;       ///< the robot's own number in the fleet
  bool planning = false;         ///< a plan is being made, for a robot that has none
};

/// The answer of a cycle.
struct NavigationStep {
  Twist2 command;  ///< to send until the next cycle; finite and within the limits
  NavigationStatus status = NavigationStatus::NoPlan;
  LimitingFactor limit = LimitingFactor::None;  ///< why the robot is not faster
  bool wants_plan = false;            ///< the navigator asks for a new plan; the facades see to it
  std::size_t rectangle = 0;          ///< index of the corridor's rectangle that the robot is in
  const MpcSolution* plan = nullptr;  ///< predicted motion; valid until the next cycle; may be null
};

}  // namespace fairway
