// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "fairway/mpc/control_solver.hpp"
#include "fairway/navigation/navigation_step.hpp"
#include "fairway/navigation/settings.hpp"
#include "fairway/perception/lidar_scan.hpp"
#include "fairway/planning/plan.hpp"

namespace fairway {

class Navigator;
class Perception;

/// Drives one robot to a goal without a map: on what its lidar has seen so far. Its interface is
/// that of MapNavigator.
///
/// Unknown space may be planned through, but the stop check treats it as blocked, so the robot is
/// never faster than it can stop inside what it has seen. The corridor covers the beginning of the
/// path, a little more than a horizon can reach. Plans are made again when an obstacle appears in
/// the corridor or on the path, when the corridor's end comes near, when the navigator asks, and
/// after a while without success; so a dead end is left as soon as it shows. All poses are in one
/// frame that need not be true far away: odometry will do.
class MaplessNavigator {
 public:
  /// @param position  Of the robot at first, where it is known [m]: its local map begins there.
  /// @throws std::invalid_argument unless validate(settings) holds.
  explicit MaplessNavigator(const Settings& settings,
                            const Eigen::Vector2d& position = Eigen::Vector2d::Zero());

  /// Solves with a solver of the caller's, which must outlive it.
  /// @throws std::invalid_argument unless validate(settings) holds.
  MaplessNavigator(const Settings& settings,
                   ControlSolver& solver,
                   const Eigen::Vector2d& position = Eigen::Vector2d::Zero());

  MaplessNavigator(MaplessNavigator&&) noexcept;
  MaplessNavigator& operator=(MaplessNavigator&&) noexcept;
  ~MaplessNavigator();

  /// Takes in one scan; several may come between two cycles.
  /// @param position  Of the robot at the scan's time [m].
  void observe(const LidarScan& scan, const Eigen::Vector2d& position);

  /// As MapNavigator::set_goal.
  void set_goal(const Goal& goal);

  /// As MapNavigator::follow: the path is in the frame of the poses.
  void follow(Path path, const std::optional<double>& goal_heading = {});

  /// Forgets the goal: the robot brakes to a standstill. Without a goal it stays stopped, too.
  void cancel();

  /// As MapNavigator::reset.
  void reset(const Twist2& actual = {}) noexcept;

  /// Drives on with other settings; what was seen so far is forgotten.
  /// @throws std::invalid_argument unless validate(settings) holds; then nothing changes.
  void set_settings(const Settings& settings);

  /// One control cycle: plans if there is need, then navigates. As MapNavigator::update.
  [[nodiscard]] NavigationStep update(const Measurements& measurements);

  /// Runs a cycle of a recorded run again, whose plans were made in a thread: takes over `plan` if
  /// the recorded cycle did, makes none itself, and then drives as `update` does.
  [[nodiscard]] NavigationStep replay(const NavigationInput& recorded, std::optional<Plan> plan);

  /// As MapNavigator::share.
  [[nodiscard]] SharedMotion share(std::uint32_t robot,
                                   double time,
                                   const Pose2& pose) const noexcept;

  [[nodiscard]] const Settings& settings() const noexcept;
  [[nodiscard]] const Plan& plan() const noexcept;
  [[nodiscard]] bool plan_is_current() const noexcept;

  /// Whether a plan was made in the last cycle, be it used or not.
  [[nodiscard]] bool planned() const noexcept;

  /// Whether the last cycle has begun to follow another plan.
  [[nodiscard]] bool follows_new_plan() const noexcept;

  /// Moving obstacles that the lidar tracks.
  [[nodiscard]] MovingObstacles tracked() const noexcept;

  /// As MapNavigator::wait_for_plan.
  void wait_for_plan() const noexcept;

  /// For those who watch the navigator closely; not part of the stable interface. The input lives
  /// until the next call of a function that is not const.
  [[nodiscard]] const Navigator& navigator() const noexcept;
  [[nodiscard]] const Perception& perception() const noexcept;
  [[nodiscard]] const NavigationInput& input() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace fairway
