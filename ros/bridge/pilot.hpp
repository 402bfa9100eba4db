// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "bridge/any_navigator.hpp"
#include "bridge/fleet_board.hpp"
#include "bridge/obstacle_board.hpp"
#include "bridge/pose_history.hpp"

namespace fairway::bridge {

/// What a node decides once, when it starts.
struct PilotOptions {
  bool use_map = true;                ///< drive on a map; else on what the scans have shown
  bool use_scan = true;               ///< scans are needed, and their age is checked
  bool plan_in_background = true;     ///< false: the cycle waits for plans, and is deterministic
  std::size_t max_beams = 4096;       ///< beams of a scan that are used, the first ones
  double patience = 20.0;             ///< a goal without progress for so long is given up [s]
  double localisation_timeout = 2.0;  ///< oldest pose of the odometry's frame in the map [s]
};

/// Whether a robot can be driven that way; the error names the option.
[[nodiscard]] Expected<void> validate(const PilotOptions& options);

/// What the pilot is doing.
enum class PilotState : std::uint8_t {
  Idle,      ///< no goal, standing: sends nothing, so that others can drive
  Driving,   ///< on its way
  Stopping,  ///< braking to a stand, then idle
};

/// How the last goal ended, said once.
enum class GoalEnd : std::uint8_t { None, Reached, GivenUp };

/// What the pilot answers in a cycle.
struct PilotStep {
  bool send = false;  ///< whether to publish the command
  Twist2 command;
  NavigationStatus status = NavigationStatus::NoPlan;
  LimitingFactor limit = LimitingFactor::None;
  GoalEnd end = GoalEnd::None;
  std::string reason;                 ///< why it was given up, for a person
  bool new_plan = false;              ///< path and corridor have changed
  std::size_t rectangle = 0;          ///< of the corridor: the one the robot is in
  const MpcSolution* plan = nullptr;  ///< what it intends; valid until the next cycle; may be null
  double pose_time = 0.0;             ///< of the pose that was used [s]
};

/// The part of a node that does not depend on the middleware: it takes in measurements with their
/// times, keeps the frames apart, and passes everything to a navigator. One per robot; all calls
/// from one thread.
///
/// The world is the map's frame, or the odometry's where there is no map.
class Pilot {
 public:
  /// @pre settings and options are valid.
  Pilot(const Settings& settings, const PilotOptions& options);

  /// Drives on with other settings, towards the same goal. Without a map, what was seen so far is
  /// forgotten. @pre validate(settings) holds.
  void set_settings(const Settings& settings);

  void set_map(const OccupancyGrid& map);
  void add_odometry(double time, const Pose2& pose, const Twist2& twist);

  /// Where the odometry's frame lies in the map, as of `time`; infinite for one that never changes.
  void set_localisation(const Pose2& odometry_in_map, double time);

  /// A scan in the sensor's frame: `scan.time` is that of the last beam, `scan.first_pose` and
  /// `.last_pose` are filled in here. @param duration  from the first beam to the last [s].
  /// @return whether the poses at these times are known; if not, the scan was not used.
  bool add_scan(LidarScan scan, double duration, const Pose2& sensor_on_robot);

  /// Who else moves; positions in the world's frame.
  [[nodiscard]] ObstacleBoard& board() noexcept { return board_; }

  /// The other robots; what they tell, in the map's frame. Without a map there is no frame in
  /// common, and they are not looked at.
  [[nodiscard]] FleetBoard& fleet() noexcept { return fleet_; }

  /// What to tell the fleet after a cycle at `time`: what this robot does, and the stop to which it
  /// has bound itself until it tells something else. None before the pose is known, or without a
  /// map.
  [[nodiscard]] std::optional<SharedMotion> share(std::uint32_t robot, double time) const;

  /// Sends the robot somewhere. @pre the goal is finite, in the world's frame.
  void set_goal(const Goal& goal);

  /// Forgets the goal and brakes.
  void cancel();

  /// One control cycle at `time`.
  [[nodiscard]] PilotStep cycle(double time);

  [[nodiscard]] PilotState state() const noexcept { return state_; }
  [[nodiscard]] const Settings& settings() const noexcept { return settings_; }
  [[nodiscard]] const PilotOptions& options() const noexcept { return options_; }

  /// Where the robot is by the newest odometry; none before odometry, or localisation, is known.
  [[nodiscard]] std::optional<Pose2> pose() const;

  /// The plan that is followed and what the tracker sees; null before the first odometry.
  [[nodiscard]] const AnyNavigator* navigator() const noexcept {
    return navigator_ ? &*navigator_ : nullptr;
  }

  /// Whether any plan was made, be it usable or not.
  [[nodiscard]] bool has_planned() const noexcept { return has_planned_; }

  [[nodiscard]] const PoseHistory& odometry() const noexcept { return odometry_; }

 private:
  void make_navigator();
  [[nodiscard]] Settings with_options(const Settings& settings) const;
  [[nodiscard]] Pose2 in_world(const Pose2& pose) const;
  [[nodiscard]] Measurements measure(double time);
  void judge(const NavigationStep& step, PilotStep& answer);
  [[nodiscard]] std::string reason_of(const NavigationStep& step) const;

  Settings settings_;
  PilotOptions options_;
  std::optional<OccupancyGrid> map_;
  PoseHistory odometry_;
  std::optional<Pose2> localisation_;
  double localisation_time_ = 0.0;
  ObstacleBoard board_;
  FleetBoard fleet_;
  std::optional<AnyNavigator> navigator_;  // without a map, only once the first pose is known
  SeenObstacles seen_;                     // by others, in this cycle
  bool scanned_ = false;                   // a scan was used
  std::optional<Goal> goal_;
  PilotState state_ = PilotState::Idle;
  int zeros_left_ = 0;  // commands to send while stopping, once it stands
  bool has_planned_ = false;
  bool fresh_goal_ = false;  // set since the last cycle
  Twist2 sent_;
};

}  // namespace fairway::bridge
