// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "fairway/map/bit_grid.hpp"
#include "fairway/mpc/solution.hpp"
#include "fairway/navigation/navigation_status.hpp"
#include "fairway/prediction/moving_obstacle.hpp"

namespace fairway {

class EntranceMap;

/// The measurements of a control cycle. All times are on one clock of the caller [s]. A measurement
/// without a time is as new as `time`.
struct Measurements {
  double time = 0.0;  ///< time of the cycle
  Pose2 pose;         ///< of the robot: position [m], heading [rad], in the frame of map and goal
  std::optional<double> pose_time{};       ///< time for which the pose is valid
  MovingObstacles obstacles{};             ///< moving obstacles tracked by other software
  std::optional<double> obstacles_time{};  ///< time of their measurement
  /// Whether a tracker runs continuously: an empty list must be new too.
  bool obstacles_due = false;
  std::optional<double>
      map_time{};           ///< time at which a changing map was current; a fixed map always is
  Fleet fleet{};            ///< other robots, which are not among the obstacles
  std::uint32_t robot = 0;  ///< number of the robot in the fleet
  /// Where people appear at this site, if that is known; must be valid during the call.
  const EntranceMap* entrances = nullptr;
};

/// The input of the navigator in a cycle: measurements and the map. Times are as in Measurements.
struct NavigationInput {
  double time = 0.0;            ///< time of the cycle
  Pose2 pose;                   ///< of the robot, in the map's frame
  double pose_time = 0.0;       ///< time for which the pose is valid
  MovingObstacles obstacles;    ///< moving obstacles
  double obstacles_time = 0.0;  ///< time of their measurement; see obstacles_due if there are none
  /// Whether a tracker runs continuously: an empty list becomes stale too.
  bool obstacles_due = false;
  /// The newest static obstacles, with the zones; must be valid during the call.
  const BitGrid* map = nullptr;
  double map_time = 0.0;    ///< time of their measurement; that of a fixed map is `time`
  Fleet fleet{};            ///< other robots, which are not among the obstacles
  std::uint32_t robot = 0;  ///< number of the robot in the fleet
  bool planning = false;    ///< whether a plan is being made for a robot that has none
  bool hold = false;        ///< whether the robot is to stop along its corridor, for a while
  const EntranceMap* entrances = nullptr;  ///< where people appear, if that is known
};

/// The result of a cycle.
struct NavigationStep {
  Twist2 command;  ///< command until the next cycle; finite and within the limits
  NavigationStatus status = NavigationStatus::NoPlan;
  LimitingFactor limit = LimitingFactor::None;  ///< reason why the robot is not faster
  bool wants_plan = false;    ///< whether the navigator requests a new plan; the facades make it
  std::size_t rectangle = 0;  ///< index of the corridor's rectangle that contains the robot
  const MpcSolution* plan = nullptr;  ///< predicted motion; valid until the next cycle; may be null
  double lateral = 0.0;   ///< of a command to an omnidirectional base, to the left [m/s]
  double steering = 0.0;  ///< angle of the steered wheel of a car or tricycle, also at rest [rad]
};

/// Why a robot does not drive, or not faster, with numbers.
struct StepExplanation {
  enum class Kind : std::uint8_t {
    None,  ///< nothing is wrong: the robot drives as fast as its limits and corridor allow
    MovingObstacle,  ///< it waits for a moving obstacle, or keeps its distance from it
    Robot,           ///< the same, of another robot of the fleet
    Stop,            ///< no new command leaves a stop that is free
    Path,            ///< there is no path
    Input,           ///< an input is too old
    Other,           ///< the status or limiting factor says it all; see `fairway statuses`
  };
  Kind kind = Kind::None;
  std::string text;  ///< one sentence without a full stop; empty for None
  /// Of the moving obstacle or robot in the way, in the frame of the map [m].
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  double found = 0.0;   ///< distance between the bodies or to the obstacle [m]; age of an input [s]
  double needed = 0.0;  ///< length of a stop [m], or the greatest age [s]; 0: none
};

[[nodiscard]] constexpr const char* to_text(StepExplanation::Kind kind) noexcept {
  switch (kind) {
    case StepExplanation::Kind::None:
      return "none";
    case StepExplanation::Kind::MovingObstacle:
      return "moving obstacle";
    case StepExplanation::Kind::Robot:
      return "robot";
    case StepExplanation::Kind::Stop:
      return "stop";
    case StepExplanation::Kind::Path:
      return "path";
    case StepExplanation::Kind::Input:
      return "input";
    case StepExplanation::Kind::Other:
      return "other";
  }
  return "unknown";
}

}  // namespace fairway
