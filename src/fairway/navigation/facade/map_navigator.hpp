// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "fairway/map/occupancy_grid.hpp"
#include "fairway/mpc/solution.hpp"
#include "fairway/navigation/navigation_step.hpp"
#include "fairway/navigation/settings.hpp"
#include "fairway/perception/lidar_scan.hpp"
#include "fairway/planning/plan.hpp"
#include "fairway/zones/zones.hpp"

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
/// The navigator makes the plans. It plans for a new goal; when a change of the map blocks the plan
/// or opens a shorter path; and when the robot has left its corridor or is stuck. While there is no
/// plan, it plans every `planning.retry_period`, so that it detects a door that opens again. If
/// `planning.background` is false, the cycle that needs a plan makes it and the result depends only
/// on the inputs. If it is true, a thread makes it and no cycle waits.
///
/// A cycle that neither makes nor takes over a plan does not allocate. Not thread-safe: make all
/// calls from one thread.
class MapNavigator {
 public:
  /// Makes a navigator without a map: the robot stays stopped (LimitingFactor::StaleMap) until
  /// `set_map`.
  /// @throws std::invalid_argument unless validate(settings) holds.
  explicit MapNavigator(const Settings& settings);

  /// Makes a navigator on `map`. @throws std::invalid_argument unless validate(settings) holds.
  MapNavigator(const Settings& settings, const OccupancyGrid& map);

  /// Makes a navigator that uses the caller's solver, which must outlive it; robots of one thread
  /// can share one. @throws std::invalid_argument unless validate(settings) holds.
  MapNavigator(const Settings& settings, ControlSolver& solver);

  /// Makes a navigator for many robots on one map. Map, planner and solver belong to the caller and
  /// must outlive the navigator; the caller signals changes of the map by `map_changed`. Plans are
  /// never made in a thread.
  /// @throws std::invalid_argument unless validate(settings) holds.
  MapNavigator(const Settings& settings,
               const PreparedMap& map,
               Planner& planner,
               ControlSolver& solver);

  MapNavigator(MapNavigator&&) noexcept;
  MapNavigator& operator=(MapNavigator&&) noexcept;
  ~MapNavigator();

  /// Replaces the map; the new one may have another frame.
  void set_map(const OccupancyGrid& map);

  /// Replaces the map by obstacles. @param obstacles  Obstacles in which unknown cells are already
  /// decided.
  void set_map(const BitGrid& obstacles);

  /// Updates the map inside a window of cells, corners included. Cells outside the window are not
  /// read, so the cost is that of the window.
  /// @throws std::invalid_argument unless `map` has the frame of the present map.
  void update_map(const OccupancyGrid& map, CellIndex first, CellIndex last);

  /// Signals that the caller's shared map has changed; see the last constructor.
  void map_changed();

  /// Processes one lidar scan: adds obstacles that the map does not have, and tracks moving ones.
  /// After the first scan, scans are required: the robot stops when they cease
  /// (`safety.map_timeout`).
  /// @param position  Position of the robot at the scan's time [m].
  /// @return whether it was taken in. One that is not finite or absurd is refused, and the robot
  ///     stops as without a scan (LimitingFactor::InvalidScan).
  bool observe(const LidarScan& scan, const Eigen::Vector2d& position);

  /// Sets the goal, or replaces it. A goal that is not finite, or whose heading is beyond 2 pi, is
  /// reported by the next cycles (LimitingFactor::InvalidGoal).
  void set_goal(const Goal& goal);

  /// Follows a path from another planner, in the frame of the map. A corridor covers the part
  /// inside the map. If the robot does not fit along it, the navigator searches its own path to the
  /// same end. An empty path acts as `cancel`.
  void follow(Path path, const std::optional<double>& goal_heading = {});

  /// Drops the goal: the robot brakes to a standstill.
  void cancel();

  /// Replaces the zones; an empty list removes them. They hold from the next cycle on: it makes a
  /// plan that obeys them, and every command is proven against them. A robot at a place that a zone
  /// forbids stays there (LimitingFactor::KeepOutZone or Strip) until it may drive again.
  /// @throws std::invalid_argument unless validate(zones) holds, and for a navigator on a map of
  ///         the caller, who then sets the zones of the map (PreparedMap::set_zones).
  void set_zones(const Zones& zones);

  /// Stops the robot along its corridor and keeps it there, until `resume`. Goal and plan are kept.
  void hold() noexcept;
  void resume() noexcept;
  [[nodiscard]] bool on_hold() const noexcept;

  /// Sets the actual twist of the robot. Call it before the first cycle of a moving robot, and
  /// after the robot was held or moved by other means.
  void reset(const Twist2& actual = {}) noexcept;

  /// Sets the command that was really sent in the last cycle, where a later check has changed it:
  /// a SafetyMonitor, for example. A base with a delay still executes the commands before it, which
  /// `reset` would forget.
  void replace_last(const Twist2& sent) noexcept;

  /// Changes the settings and keeps the goal; the next cycle makes a plan. What was sent to the
  /// base is kept too.
  /// @throws std::invalid_argument unless validate(settings) holds; then nothing changes.
  void set_settings(const Settings& settings);

  /// Runs one control cycle: takes over a plan if one is ready, makes one if needed, and drives.
  ///
  /// Never fails: the command is always finite, within the limits, and followed by a stop that was
  /// checked. `status` and `limit` explain what limits the robot.
  [[nodiscard]] NavigationStep update(const Measurements& measurements);

  /// Makes the plan that the robot needs now, without driving: for a paused robot that displays its
  /// plan. With `planning.background` the plan is started or taken over.
  /// @return whether the robot follows another plan from now on.
  bool plan_now(const Measurements& measurements);

  /// Returns the message to the other robots after an update at `time` and `pose`.
  [[nodiscard]] SharedMotion share(std::uint32_t robot,
                                   double time,
                                   const Pose2& pose) const noexcept;

  /// Returns the settings in use.
  [[nodiscard]] const Settings& settings() const noexcept;
  [[nodiscard]] const Plan& plan() const noexcept;  ///< the plan being followed; may be unusable

  /// Returns whether the plan is for the present goal; false between a new goal and its plan.
  [[nodiscard]] bool plan_is_current() const noexcept;

  /// Returns why there is no path, in one sentence with numbers and what could be changed. Empty
  /// while there is one, and unless `planning.background` is true: without a thread, call `explain`
  /// outside of the control cycle. A new cause for the same goal may take eight attempts to
  /// appear.
  [[nodiscard]] const std::string& explanation() const noexcept;

  /// Explains the step of the last cycle, with numbers and the place of what the robot waits for.
  /// Call it before the next cycle, while the measurements given to `update` are valid, and outside
  /// of a control loop: it allocates.
  /// @param speed  At which the robot moves [m/s].
  [[nodiscard]] StepExplanation explain(const NavigationStep& step, double speed) const;

  /// Returns whether the last cycle started to follow another plan.
  [[nodiscard]] bool follows_new_plan() const noexcept;

  /// Returns whether a plan was made, or requested from the thread, in the last cycle.
  [[nodiscard]] bool planned() const noexcept;

  /// Moving obstacles that the robot's own lidar tracks; empty without scans.
  [[nodiscard]] MovingObstacles tracked() const noexcept;

  /// Obstacles of the map and of scans, as known now; null without a map.
  [[nodiscard]] const BitGrid* obstacles() const noexcept;

  /// Waits until the background plan, if any, is made; the next cycle takes it over. Tests and
  /// simulations that run faster than real time need this.
  void wait_for_plan() const noexcept;

  /// Sets a clock [s] by which synchronous plans are timed. `planning_seconds` is the duration of
  /// the plan of the last cycle, and 0 if it made none.
  void lend_clock(std::function<double()> clock);
  [[nodiscard]] double planning_seconds() const noexcept;

  /// Internals for tests and diagnostics; not part of the stable interface.
  [[nodiscard]] const Navigator& navigator() const noexcept;
  [[nodiscard]] const NavigationInput& input() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace fairway
