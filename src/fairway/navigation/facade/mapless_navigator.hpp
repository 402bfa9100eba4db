// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "fairway/mpc/solution.hpp"
#include "fairway/navigation/navigation_step.hpp"
#include "fairway/navigation/settings.hpp"
#include "fairway/perception/lidar_scan.hpp"
#include "fairway/planning/plan.hpp"
#include "fairway/zones/zones.hpp"

namespace fairway {

class Navigator;
class Perception;

/// Drives one robot to a goal without a map, on what its lidar has measured so far. Its interface
/// is that of MapNavigator.
///
/// Paths may lead through unknown space, but the stop check treats it as blocked. So the robot can
/// always stop inside what it has measured. The corridor covers the beginning of the path, slightly
/// more than a horizon can reach. A new plan is made when an obstacle appears in the corridor or on
/// the path, when the end of the corridor comes near, when the navigator requests one, and after
/// some time without success; the robot therefore leaves a dead end as soon as it is visible. All
/// poses are in one frame that may drift slowly; odometry suffices.
class MaplessNavigator {
 public:
  /// @param position  Initial position of the robot, if known [m]: its local map starts there.
  /// @throws std::invalid_argument unless validate(settings) holds.
  explicit MaplessNavigator(const Settings& settings,
                            const Eigen::Vector2d& position = Eigen::Vector2d::Zero());

  /// Makes a navigator that uses the caller's solver, which must outlive it.
  /// @throws std::invalid_argument unless validate(settings) holds.
  MaplessNavigator(const Settings& settings,
                   ControlSolver& solver,
                   const Eigen::Vector2d& position = Eigen::Vector2d::Zero());

  MaplessNavigator(MaplessNavigator&&) noexcept;
  MaplessNavigator& operator=(MaplessNavigator&&) noexcept;
  ~MaplessNavigator();

  /// Processes one scan; several scans may come between two cycles.
  /// @param position  Position of the robot at the scan's time [m].
  /// @return whether it was taken in, as MapNavigator::observe.
  bool observe(const LidarScan& scan, const Eigen::Vector2d& position);

  /// Sets the goal, as MapNavigator::set_goal does.
  void set_goal(const Goal& goal);

  /// Follows a path in the frame of the poses, as MapNavigator::follow does.
  void follow(Path path, const std::optional<double>& goal_heading = {});

  /// Drops the goal: the robot brakes to a standstill, and stays stopped without a goal.
  void cancel();

  /// Replaces the zones, as MapNavigator::set_zones does; they are in the frame of the poses.
  /// @throws std::invalid_argument unless validate(zones) holds.
  void set_zones(const Zones& zones);

  /// Stops along the corridor, and drives on, as MapNavigator does.
  void hold() noexcept;
  void resume() noexcept;
  [[nodiscard]] bool on_hold() const noexcept;

  /// Sets the actual twist, as MapNavigator::reset does.
  void reset(const Twist2& actual = {}) noexcept;

  /// Sets the command that was really sent, as MapNavigator::replace_last does.
  void replace_last(const Twist2& sent) noexcept;

  /// Changes the settings. The local map and the tracks of moving obstacles stay, unless those of
  /// `perception` change.
  /// @throws std::invalid_argument unless validate(settings) holds; then nothing changes.
  void set_settings(const Settings& settings);

  /// Runs one control cycle: plans if needed, then drives, as MapNavigator::update does.
  [[nodiscard]] NavigationStep update(const Measurements& measurements);

  /// Repeats a cycle of a recorded run, whose pose is already the one corrected by scans. Plans
  /// that were made in a thread are not made again: `plan` is taken over if the recorded cycle did.
  [[nodiscard]] NavigationStep replay(const NavigationInput& recorded, std::optional<Plan> plan);

  /// Returns the message to the other robots, as MapNavigator::share does.
  [[nodiscard]] SharedMotion share(std::uint32_t robot,
                                   double time,
                                   const Pose2& pose) const noexcept;

  /// Returns the settings, the plan being followed, and whether it is for the present goal.
  [[nodiscard]] const Settings& settings() const noexcept;
  [[nodiscard]] const Plan& plan() const noexcept;
  [[nodiscard]] bool plan_is_current() const noexcept;

  /// Returns why there is no path to the goal on what the robot has seen so far, in one sentence
  /// with numbers; empty if there is one, or without a goal. It makes a plan on a copy of the local
  /// map, which takes milliseconds: call it outside of a control loop.
  [[nodiscard]] std::string explanation() const;

  /// Explains the step of the last cycle, with numbers and the place of what the robot waits for.
  /// Call it before the next cycle, while the measurements given to `update` are valid, and outside
  /// of a control loop: it allocates.
  /// @param speed  At which the robot moves [m/s].
  [[nodiscard]] StepExplanation explain(const NavigationStep& step, double speed) const;

  /// Returns whether the last cycle made a plan, used or not.
  [[nodiscard]] bool planned() const noexcept;

  /// Returns whether the last cycle started to follow another plan.
  [[nodiscard]] bool follows_new_plan() const noexcept;

  /// Returns the robot's pose in the frame of goal and local map, for a pose by odometry. They
  /// differ only with `perception.match_scans`.
  [[nodiscard]] Pose2 corrected(const Pose2& odometry) const noexcept;

  /// Returns the covariance of a corrected pose, of (x, y, heading) [m, rad]; none without
  /// `perception.match_scans`.
  [[nodiscard]] std::optional<Eigen::Matrix3d> pose_covariance() const noexcept;

  /// Moving obstacles that the lidar tracks.
  [[nodiscard]] MovingObstacles tracked() const noexcept;

  /// Waits for a background plan, as MapNavigator::wait_for_plan does.
  void wait_for_plan() const noexcept;

  /// Internals for tests and diagnostics; not part of the stable interface. The input is valid
  /// until the next call of a non-const function.
  [[nodiscard]] const Navigator& navigator() const noexcept;
  [[nodiscard]] const Perception& perception() const noexcept;
  [[nodiscard]] const NavigationInput& input() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace fairway
