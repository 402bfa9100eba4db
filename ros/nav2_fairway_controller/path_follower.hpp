// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "bridge/sensing/obstacle_board.hpp"
#include "fairway/navigation/facade/map_navigator.hpp"
#include "nav2_fairway_controller/following/follower_mailbox.hpp"
#include "nav2_fairway_controller/following/path_piece.hpp"
#include "nav2_fairway_controller/following/stop_reason.hpp"

namespace fairway::nav2 {

/// The input of a cycle. Times are on the node's clock [s]; all poses are in the costmap's frame.
struct FollowerInput {
  double time = 0.0;
  Pose2 pose;
  double pose_time = 0.0;
  Twist2 twist;          ///< actual twist of the robot
  double lateral = 0.0;  ///< actual speed to the left [m/s]
  const BitGrid& obstacles;
  double obstacles_time = 0.0;  ///< time of the costmap's last update
  const bridge::ObstacleBoard& moving;
  /// Pose of the path's frame in the costmap's frame now; none if no transform is known now.
  std::optional<Pose2> path_frame = Pose2{};
  std::optional<GoalTolerance> goal{};  ///< what the goal checker accepts, if known
};

/// The error that a cycle reports to Nav2.
enum class FollowerFault : std::uint8_t { None, NoControl, BadPath, NoFrame };

/// The result of a cycle.
struct FollowerStep {
  Twist2 command;
  double lateral = 0.0;  ///< speed to the left, of a base that moves to all sides [m/s]
  NavigationStatus status = NavigationStatus::NoPlan;
  LimitingFactor limit = LimitingFactor::None;  ///< reason why the robot is not faster
  std::size_t rectangle = 0;                    ///< of the corridor, with the robot
  /// The error to report; only while the command is zero, so that the robot brakes within its
  /// limits before.
  FollowerFault fault = FollowerFault::None;
  std::string reason;      ///< why the robot is stopped or brakes, with numbers; empty otherwise
  double driven = 0.0;     ///< arc length of the robot on the path [m]
  double remaining = 0.0;  ///< length of the rest of the path [m]
  double deviation = 0.0;  ///< distance from the path [m]
};

/// Follows a path of another planner inside a map that moves with the robot. This is the part of
/// Nav2's controller that does not depend on Nav2.
///
/// The path stays in its own frame and is transformed in every cycle. The robot follows one piece
/// of it after another (PathPiece). A corridor covers the piece; if the robot's disc does not fit
/// along it, the navigator searches its own path to the end of the piece.
///
/// With `following.max_deviation`, the robot's centre stays within that distance of the path, and
/// the robot stops before obstacles on it. Without it, a piece has a bound of its own only where
/// the robot would otherwise skip a part of the path through free space.
///
/// The functions `set_...`, `cancel` and `reset` may be called from any thread. They take effect at
/// the start of the next cycle. All others belong to the thread that calls `update`.
class PathFollower {
 public:
  /// @pre the settings are valid.
  explicit PathFollower(const FollowerSettings& settings);

  /// Continues with other settings. @pre they are valid.
  void set_settings(const FollowerSettings& settings) { mailbox_.post_settings(settings); }

  /// Sets a new path, in its own frame. A path that is equal to the one being followed continues
  /// it. @pre path_fault(path) is empty.
  void set_path(Path path, const std::optional<double>& goal_heading) {
    mailbox_.post_path({.path = std::move(path), .goal_heading = goal_heading});
  }

  /// Sets a speed limit; see `limited`.
  void set_speed_limit(const SpeedLimit& limit) { mailbox_.post_limit(limit); }

  /// Removes the path: the robot brakes to standstill.
  void cancel() { mailbox_.post_cancel(); }

  /// Prepares a new task: forgets the path and the last command.
  void reset() { mailbox_.post_reset(); }

  /// Runs one control cycle.
  [[nodiscard]] FollowerStep update(const FollowerInput& input);

  [[nodiscard]] const FollowerSettings& settings() const noexcept { return settings_; }
  [[nodiscard]] const Plan& plan() const noexcept { return navigator_.plan(); }
  [[nodiscard]] const std::optional<PathPiece>& piece() const noexcept { return piece_; }

 private:
  void apply(FollowerChanges changes);
  void drop_path();
  void update_limits(const FollowerInput& input);
  [[nodiscard]] bool update_frame(const FollowerInput& input);
  void update_piece(const FollowerInput& input, const Measurements& measurements);
  [[nodiscard]] bool needs_piece(double time) const noexcept;
  void try_pieces(const FollowerInput& input, const Measurements& measurements);
  [[nodiscard]] bool follow(const PathPiece& piece,
                            double bound,
                            const FollowerInput& input,
                            const Measurements& measurements);
  void set_map(const FollowerInput& input);
  [[nodiscard]] FollowerStep judged(const NavigationStep& step, const FollowerInput& input);
  [[nodiscard]] std::string reason_of(const NavigationStep& step) const;

  FollowerMailbox mailbox_;
  FollowerSettings settings_;
  MapNavigator navigator_;
  bool starts_ = true;  // no command was sent since the last reset

  SpeedLimit limit_;
  bool settings_changed_ = false;  // since the navigator received them
  bool approaches_ = false;        // whether the limit near the goal applies
  bool holds_ = false;             // whether the speed limit is too low to drive
  std::string limit_fault_;

  PathProgress progress_;
  std::optional<double> goal_heading_;  // in the path's frame
  bool is_new_ = false;                 // the position on the path is not known yet
  Pose2 frame_;                         // the path's frame in the costmap's
  std::optional<double> frame_time_;    // when it was last known
  std::optional<PathPiece> piece_;
  Pose2 piece_frame_;  // when the piece was chosen
  double piece_time_ = 0.0;
  bool piece_failed_ = false;  // no plan was found for it
  Path strip_;                 // center line of the strip, in the costmap's frame; empty: no strip
  double strip_bound_ = 0.0;
  bool map_is_set_ = false;  // in this cycle
  BitGrid map_;              // with the strip
  std::string blocked_;      // why there is no piece
  FollowerFault blocked_fault_ = FollowerFault::NoControl;
  double best_ = 0.0;                    // greatest arc length reached
  std::optional<double> progress_time_;  // when it was reached
};

}  // namespace fairway::nav2
