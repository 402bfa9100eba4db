// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "bridge/any_navigator.hpp"
#include "bridge/command_guard.hpp"
#include "bridge/sensing/robot_senses.hpp"
#include "bridge/sensing/sensor_receiver.hpp"

namespace fairway::bridge {

/// The options of a node that are fixed at its start.
struct PilotOptions {
  bool use_map = true;                ///< drive on a map; otherwise on the cells seen by the scans
  bool use_scan = true;               ///< scans are needed, and their age is checked
  bool use_monitor = true;            ///< check every command with a SafetyMonitor; needs scans
  Polygon monitor_stop_zone{};        ///< a scan point in here stops the robot; empty: none
  Polygon monitor_slow_zone{};        ///< a scan point in here slows it down; empty: none
  double monitor_slow_speed = 0.3;    ///< greatest linear speed then [m/s]
  bool plan_in_background = true;     ///< false: the cycle waits for plans, and is deterministic
  std::size_t max_beams = 4096;       ///< only the first beams of a scan are used
  double patience = 20.0;             ///< a goal is given up after this time without progress [s]
  double localisation_timeout = 2.0;  ///< largest age of the odometry frame's pose in the map [s]
  Zones zones{};                      ///< that hold, in the world frame
  std::optional<RobotModel> body{};   ///< true outline and base, driven by a BodyNavigator
  std::uint32_t robot = 0;            ///< number in the fleet; see robot_number
};

/// Checks that a robot can be driven with these options; the error names the option.
[[nodiscard]] Expected<void> validate(const PilotOptions& options);

/// The state of the pilot.
enum class PilotState : std::uint8_t {
  Idle,      ///< no goal and at standstill: sends no commands, so that other programs can drive
  Driving,   ///< drives to the goal
  Stopping,  ///< brakes to standstill, then becomes idle
};

/// How the last goal ended; reported once.
enum class GoalEnd : std::uint8_t { None, Reached, GivenUp };

/// The result of a cycle.
struct PilotStep {
  bool send = false;  ///< whether to publish the command
  Twist2 command;
  double lateral = 0.0;   ///< completes the command of an omnidirectional body [m/s]
  double steering = 0.0;  ///< angle of the steered wheel, of a car or tricycle [rad]
  NavigationStatus status = NavigationStatus::NoPlan;
  LimitingFactor limit = LimitingFactor::None;
  GoalEnd end = GoalEnd::None;
  std::string reason;                   ///< why the goal was given up, for the user
  PathStatus path = PathStatus::Found;  ///< why there was no plan when it was given up, if so
  bool new_plan = false;                ///< path and corridor have changed
  std::size_t rectangle = 0;          ///< index of the corridor's rectangle that contains the robot
  const MpcSolution* plan = nullptr;  ///< predicted trajectory; valid until the next cycle; may be
                                      ///< null
  double pose_time = 0.0;             ///< time of the pose that was used [s]
  MonitorReason monitor = MonitorReason::None;  ///< why the safety monitor reduced the command
  /// Why a robot that should drive is at standstill, in one sentence with numbers; made once per
  /// second.
  std::string explanation{};
};

/// The part of a node that does not depend on the middleware. It receives measurements with their
/// times, separates the frames, and passes everything to a navigator. Use one per robot, with all
/// calls from one thread.
///
/// The world frame is the map's, or the odometry's without a map.
class Pilot : public SensorReceiver {
 public:
  /// @pre settings and options are valid.
  Pilot(const Settings& settings, const PilotOptions& options);

  /// Continues with other settings towards the same goal, or along the same path. A base with a
  /// delay still executes what was sent before, and nothing waits for a plan that is being made.
  /// Without a map, all cells seen before are forgotten if `perception.*` changes.
  /// @pre validate(settings) holds.
  void set_settings(const Settings& settings);

  void set_map(const OccupancyGrid& map);
  void add_odometry(double time, const Pose2& pose, const PlanarTwist& twist) override;
  void set_localisation(const Pose2& odometry_in_map, double time) override {
    senses_.set_localisation(odometry_in_map, time);
  }
  bool add_scan(LidarScan scan, double duration, const Pose2& sensor_on_robot) override;
  [[nodiscard]] ObstacleBoard& board() noexcept override { return senses_.board(); }

  /// The other robots' published motions, in the map's frame. Without a map there is no common
  /// frame, and they are ignored.
  [[nodiscard]] FleetBoard& fleet() noexcept { return senses_.fleet(); }

  /// The message to the fleet after a cycle at `time`. It has this robot's motion, and the stop to
  /// which it is committed until its next message. None before the pose is known, or without a map.
  [[nodiscard]] std::optional<SharedMotion> share(double time) const;

  /// Sets a goal in the world's frame. The next cycles refuse one that is not finite.
  void set_goal(const Goal& goal);

  /// Follows a path in the world's frame instead of a goal, as MapNavigator::follow does.
  /// @param bound  Greatest distance of the robot's centre from the path [m]; 0: none. Options with
  /// strips of their own have precedence. @pre the waypoints are finite, and there is at least one.
  void follow(Path path, const std::optional<double>& goal_heading, double bound = 0.0);

  /// Follows a path of poses with a body, as BodyNavigator::follow does: forwards and backwards as
  /// the headings ask, and within `max_deviation`. @pre options().body, and there is a pose.
  void follow(PosePath path);

  /// Removes the goal and brakes.
  void cancel();

  /// Runs one control cycle at `time`.
  [[nodiscard]] PilotStep cycle(double time);

  [[nodiscard]] PilotState state() const noexcept { return state_; }
  [[nodiscard]] const Settings& settings() const noexcept { return settings_; }
  [[nodiscard]] const PilotOptions& options() const noexcept { return options_; }

  /// The robot's pose by the newest odometry; none before odometry, or localisation, is known.
  [[nodiscard]] std::optional<Pose2> pose() const { return senses_.pose(); }

  /// The current plan and the tracker's obstacles; null before the first odometry.
  [[nodiscard]] const AnyNavigator* navigator() const noexcept {
    return navigator_ ? &*navigator_ : nullptr;
  }

  /// Whether any plan was made, even an unusable one.
  [[nodiscard]] bool has_planned() const noexcept { return has_planned_; }

  [[nodiscard]] const PoseHistory& odometry() const noexcept { return senses_.odometry(); }

 private:
  void make_navigator();
  void set_strips(Zones strips);
  [[nodiscard]] bool has_own_strips() const noexcept;
  void begin_goal();
  void make_guard();
  void reset_navigator(const PlanarTwist& actual);
  void guard(double time, PilotStep& answer);
  [[nodiscard]] Settings with_options(const Settings& settings) const;
  [[nodiscard]] bool waits_too_long(double time, const NavigationStep& step) noexcept;
  void explain(double time, const NavigationStep& step, PilotStep& answer);
  void judge(double time, const NavigationStep& step, PilotStep& answer);
  [[nodiscard]] std::string reason_of(const NavigationStep& step) const;

  Settings settings_;
  PilotOptions options_;
  std::optional<OccupancyGrid> map_;
  RobotSenses senses_;
  std::optional<AnyNavigator> navigator_;  // without a map, only once the first pose is known
  std::optional<Goal> goal_;
  Path path_;       // to the goal, if it was given; else empty
  PosePath poses_;  // the same for a body
  Zones strips_;    // around the path
  PilotState state_ = PilotState::Idle;
  int zeros_left_ = 0;  // remaining commands while stopping, after standstill
  bool has_planned_ = false;
  bool fresh_goal_ = false;            // set since the last cycle
  std::optional<double> waits_since_;  // at standstill, with a body [s]
  std::string explanation_;
  double explained_at_ = 0.0;  // [s]
  PlanarTwist sent_{};
  double steering_ = 0.0;  // last one sent, or that follows from the odometry [rad]
  std::optional<CommandGuard> guard_;
};

}  // namespace fairway::bridge
