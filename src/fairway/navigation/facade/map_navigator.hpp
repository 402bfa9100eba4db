// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "fairway/map/occupancy_grid.hpp"
#include "fairway/mpc/control_solver.hpp"
#include "fairway/navigation/navigation_step.hpp"
#include "fairway/navigation/settings.hpp"
#include "fairway/perception/lidar_scan.hpp"
#include "fairway/planning/plan.hpp"

namespace fairway {

class Navigator;
class Planner;
struct PreparedMap;

/// Drives one robot to a goal, or along a path, on a map that may change.
///
///     fairway::MapNavigator navigator(settings, map);
///     navigator.set_goal({{9.0, 1.0}});
///     while (driving) send(navigator.update({.time = now(), .pose = pose()}).command);
///
/// It makes the plans: for a new goal; when the map changes under the plan or opens a shorter one;
/// when the robot left its corridor or is stuck; and while there is no plan every
/// `planning.retry_period`, so that a door that opens again is found. With `planning.background`
/// false the cycle that needs a plan makes it, and the result depends on the inputs only; with true
/// a thread makes it, and no cycle waits.
///
/// A cycle that neither makes nor takes over a plan does not allocate. Not thread-safe: all calls
/// from one thread.
class MapNavigator {
 public:
  /// Without a map the robot stays stopped (LimitingFactor::StaleMap) until `set_map`.
  /// @throws std::invalid_argument unless validate(settings) holds.
  explicit MapNavigator(const Settings& settings);

  /// @throws std::invalid_argument unless validate(settings) holds.
  MapNavigator(const Settings& settings, const OccupancyGrid& map);

  /// Solves with a solver of the caller's, which must outlive it; robots of one thread can share
  /// one. @throws std::invalid_argument unless validate(settings) holds.
  MapNavigator(const Settings& settings, ControlSolver& solver);

  /// For many robots on one map: map, planner and solver are the caller's and outlive it, and the
  /// caller tells by `map_changed` when it has changed the map. Plans are never made in a thread.
  /// @throws std::invalid_argument unless validate(settings) holds.
  MapNavigator(const Settings& settings,
               const PreparedMap& map,
               Planner& planner,
               ControlSolver& solver);

  MapNavigator(MapNavigator&&) noexcept;
  MapNavigator& operator=(MapNavigator&&) noexcept;
  ~MapNavigator();

  /// Another map, or one that lies elsewhere.
  void set_map(const OccupancyGrid& map);

  /// The same with the obstacles of a map. @param obstacles  Unknown cells decided already.
  void set_map(const BitGrid& obstacles);

  /// The map has changed inside a window of cells, corners included. What lies outside the window
  /// is not looked at, so the cost is that of the window.
  /// @throws std::invalid_argument unless `map` has the cells of the present map.
  void update_map(const OccupancyGrid& map, CellIndex first, CellIndex last);

  /// The caller's shared map has changed; see the last constructor.
  void map_changed();

  /// Takes in one scan of a lidar: obstacles that the map does not have, and moving ones. Once a
  /// scan was given, scans are due: the robot stops when they end (`safety.map_timeout`).
  /// @param position  Of the robot at the scan's time [m].
  void observe(const LidarScan& scan, const Eigen::Vector2d& position);

  /// Sends the robot to a goal, or to another one. A goal that is not finite, or whose heading is
  /// beyond 2 pi, is answered by the next cycles (LimitingFactor::InvalidGoal).
  void set_goal(const Goal& goal);

  /// Follows a path from another planner, in the frame of the map: what of it lies inside the
  /// map is covered by a corridor; where the robot does not fit along it, it finds its own way.
  /// An empty path is as `cancel`.
  void follow(Path path, const std::optional<double>& goal_heading = {});

  /// Forgets the goal: the robot brakes to a standstill.
  void cancel();

  /// Sets the twist that the robot really has: before the first cycle of one that moves already,
  /// and after it was held or moved by others.
  void reset(const Twist2& actual = {}) noexcept;

  /// Drives on with other settings towards the same goal; the next cycle makes a plan.
  /// @throws std::invalid_argument unless validate(settings) holds; then nothing changes.
  void set_settings(const Settings& settings);

  /// Runs one control cycle: takes over a plan if one is ready, makes one if one is needed, and
  /// drives. Never fails: the command is always finite, within the limits, and leaves a stop that
  /// was checked; status and limit say what holds the robot back.
  [[nodiscard]] NavigationStep update(const Measurements& measurements);

  /// Makes the plan that the robot needs now, as `update` would, but does not drive: for a robot
  /// that is paused and shows its plan. With `planning.background` it is begun, or taken over.
  /// @return whether another plan is followed from now on.
  bool plan_now(const Measurements& measurements);

  /// The message to the other robots after an update at `time` and `pose`.
  [[nodiscard]] SharedMotion share(std::uint32_t robot,
                                   double time,
                                   const Pose2& pose) const noexcept;

  [[nodiscard]] const Settings& settings() const noexcept;
  [[nodiscard]] const Plan& plan() const noexcept;  ///< that is followed; may be unusable

  /// Whether the plan is one for the present goal; not so between a new goal and its plan.
  [[nodiscard]] bool plan_is_current() const noexcept;

  /// Whether the last cycle has begun to follow another plan.
  [[nodiscard]] bool follows_new_plan() const noexcept;

  /// Whether a plan was made, or asked of the thread, in the last cycle.
  [[nodiscard]] bool planned() const noexcept;

  /// Moving obstacles that the own lidar tracks; empty without scans.
  [[nodiscard]] MovingObstacles tracked() const noexcept;

  /// Obstacles as they are known now: the map's and those of scans. Null without a map.
  [[nodiscard]] const BitGrid* obstacles() const noexcept;

  /// Waits until the plan that is being made in the background is made, for tests and simulations
  /// that run faster than time. The next cycle takes it over.
  void wait_for_plan() const noexcept;

  /// Lends a clock [s] by which synchronous plans are timed; `planning_seconds` is what the last
  /// one took, and 0 in cycles without one.
  void lend_clock(std::function<double()> clock);
  [[nodiscard]] double planning_seconds() const noexcept;

  /// For those who watch the navigator closely; not part of the stable interface.
  [[nodiscard]] const Navigator& navigator() const noexcept;
  [[nodiscard]] const NavigationInput& input() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace fairway
