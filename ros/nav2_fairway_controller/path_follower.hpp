// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "bridge/obstacle_board.hpp"
#include "fairway/navigation/facade/map_navigator.hpp"

namespace fairway::nav2 {

/// The input of a cycle. Times are on the node's clock [s]; all poses are in one frame.
struct FollowerInput {
  double time = 0.0;
  Pose2 pose;
  double pose_time = 0.0;
  Twist2 twist;  ///< actual twist of the robot
  const BitGrid& obstacles;
  double obstacles_time = 0.0;  ///< time of the costmap's last update
  const bridge::ObstacleBoard& moving;
};

/// The result of a cycle.
struct FollowerStep {
  Twist2 command;
  NavigationStatus status = NavigationStatus::NoPlan;
  bool standing = false;  ///< the command is zero, and will stay zero without intervention
  std::string reason;     ///< why the robot stops or brakes, for the user
};

/// Follows a path of another planner inside a map that moves with the robot. This is the part of
/// Nav2's controller that does not depend on Nav2.
///
/// The navigator cuts the path where it leaves the map. If the robot's disc fits along the rest, it
/// covers that with a corridor; otherwise it plans its own path to the same end.
class PathFollower {
 public:
  /// @pre settings are valid.
  explicit PathFollower(const Settings& settings);

  /// Continues with other settings. @pre validate(settings) holds.
  void set_settings(const Settings& settings);

  /// Sets a new path, in the frame of the poses; an empty one makes the robot brake.
  void set_path(Path path, const std::optional<double>& goal_heading);

  /// Sets a speed limit [m/s]; without a positive one the settings apply.
  void set_speed_limit(const std::optional<double>& limit);

  /// Removes the path: the robot brakes to standstill.
  void cancel();

  /// Prepares a new task: forgets the last command.
  void reset();

  [[nodiscard]] FollowerStep update(const FollowerInput& input);

  [[nodiscard]] const Settings& settings() const noexcept { return settings_; }
  [[nodiscard]] const Plan& plan() const noexcept { return navigator_.plan(); }

 private:
  [[nodiscard]] Settings limited() const;

  Settings settings_;
  std::optional<double> speed_limit_;
  MapNavigator navigator_;
  bool starts_ = true;  // no command was sent since the last reset
};

}  // namespace fairway::nav2
