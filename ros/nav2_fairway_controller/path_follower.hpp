// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "bridge/obstacle_board.hpp"
#include "fairway/navigation/facade/map_navigator.hpp"

namespace fairway::nav2 {

/// What the follower is told in a cycle. Times on the node's clock [s]; one frame for everything.
struct FollowerInput {
  double time = 0.0;
  Pose2 pose;
  double pose_time = 0.0;
  Twist2 twist;  ///< that the robot really has
  const BitGrid& obstacles;
  double obstacles_time = 0.0;  ///< when the costmap was up to date
  const bridge::ObstacleBoard& moving;
};

/// What became of a cycle.
struct FollowerStep {
  Twist2 command;
  NavigationStatus status = NavigationStatus::NoPlan;
  bool standing = false;  ///< the command is zero, and no other is to be expected without help
  std::string reason;     ///< why it stands or brakes, for a person
};

/// Follows a path that another planner made, inside a map that moves with the robot: the part of
/// Nav2's controller that does not depend on Nav2.
///
/// The navigator cuts the path where it leaves the map, covers what is left with a corridor where
/// the robot's disc fits along it, and else plans its own way to where it ends.
class PathFollower {
 public:
  /// @pre settings are valid.
  explicit PathFollower(const Settings& settings);

  /// Drives on with other settings. @pre validate(settings) holds.
  void set_settings(const Settings& settings);

  /// A new path, in the frame of the poses; an empty one makes the robot brake.
  void set_path(Path path, const std::optional<double>& goal_heading);

  /// At most this fast [m/s]; none, or not positive: as the settings say.
  void set_speed_limit(const std::optional<double>& limit);

  /// Forgets the path: the robot brakes to a stand.
  void cancel();

  /// Before a new task: forgets what was sent.
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
