// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "fairway/geometry/robot_model.hpp"
#include "fairway/map/occupancy_grid.hpp"
#include "fairway/navigation/navigation_step.hpp"
#include "fairway/navigation/settings.hpp"
#include "fairway/path/path.hpp"
#include "fairway/perception/lidar_scan.hpp"
#include "fairway/planning/plan.hpp"
#include "fairway/zones/zones.hpp"

namespace fairway {

struct PreparedMap;

/// Drives a robot of any outline on any base to a goal on a map. It is the counterpart of
/// MapNavigator for robots whose disc does not fit: long platforms, cars, tricycles, mecanum and
/// swerve bases.
///
///     fairway::BodyNavigator navigator(settings, robot, map);
///     navigator.set_goal({{9.0, 1.0}});
///     while (driving) send(navigator.update({.time = now(), .pose = pose()}));
///
/// The navigator plans a drive that is proven free for the true body, and follows it. Before every
/// command it proves that the base can stop on its drive without contact. Moving obstacles make the
/// robot slower; if one stays in its path, it plans another drive around that. A drive to a new
/// goal, or one for another map, continues from the present motion. Where there is none that can,
/// the robot stops first.
///
/// Limits and outline come from the robot model; of Settings, the groups navigation, safety,
/// prediction, planning and map apply. If `planning.background` is false the cycle that needs a
/// plan makes it. A cycle that makes no plan does not allocate. Not thread-safe.
class BodyNavigator {
 public:
  /// Makes a navigator without a map: the robot stays stopped until `set_map` or `observe`.
  /// @throws std::invalid_argument unless settings and robot are valid.
  BodyNavigator(const Settings& settings, const RobotModel& robot);

  /// Makes a navigator on `map`. @throws std::invalid_argument as above.
  BodyNavigator(const Settings& settings, const RobotModel& robot, const OccupancyGrid& map);

  /// Makes a navigator on the caller's map, which must outlive it; the caller signals changes by
  /// `map_changed`.
  BodyNavigator(const Settings& settings, const RobotModel& robot, const PreparedMap& map);

  BodyNavigator(BodyNavigator&&) noexcept;
  BodyNavigator& operator=(BodyNavigator&&) noexcept;
  ~BodyNavigator();

  /// Replaces the map; the new one may have another frame.
  void set_map(const OccupancyGrid& map);

  /// Signals that the caller's shared map has changed; see the last constructor.
  void map_changed();

  /// Replaces the map by one in its packed form.
  void set_map(const BitGrid& map);

  /// Replaces the zones; an empty list removes them. Keep-outs and strips hold for the true
  /// outline, or for the reference point. They hold from the next cycle on: a drive that breaks
  /// them is given up, and every command is proven against them.
  /// @throws std::invalid_argument unless validate(zones) holds, and for a navigator on a map of
  ///         the caller, who then sets the zones of the map (PreparedMap::set_zones).
  void set_zones(const Zones& zones);

  /// Processes one scan; several may come between two cycles. On a map, what is seen is added to
  /// it. Without a map the robot drives on its scans: it plans through unknown space, and can
  /// always stop inside what it has seen.
  /// @param position  Position of the reference point at the scan's time [m].
  /// @return whether it was taken in, as MapNavigator::observe.
  bool observe(const LidarScan& scan, const Eigen::Vector2d& position);

  /// Sets the goal, or replaces it. Without a heading, one in which the robot fits is selected.
  void set_goal(const Goal& goal);

  /// Follows a path from another planner, in the frame of the map, to its end. Without a bound on
  /// the deviation the robot stays near the path, and drives around what blocks it. Within a bound
  /// it stops where the path is blocked. A path that the base cannot drive is reported by the next
  /// cycles (LimitingFactor::InvalidGoal) and by `explanation`. An empty path acts as `cancel`.
  void follow(const PosePath& path);

  /// The same for a path without headings.
  void follow(const Path& path, const std::optional<double>& goal_heading = {});

  /// Returns where the robot is on the path that it follows, by the last cycle; none without.
  [[nodiscard]] std::optional<PathPlace> place_on_path() const noexcept;

  /// Why there is no drive, or none to the end of the path; empty where there is one.
  [[nodiscard]] const std::string& explanation() const noexcept;

  /// Drops the goal: the robot brakes to a standstill.
  void cancel() noexcept;

  /// Sets the actual motion of the base, for one that was moved by other means. The steered wheel
  /// of a car or tricycle is at `steering` [rad].
  void reset(const PlanarTwist& actual = {}, double steering = 0.0) noexcept;

  /// Sets the motion that was really sent in the last cycle, where a later check has changed it, as
  /// MapNavigator::replace_last. The drive is kept.
  void replace_last(const PlanarTwist& sent, double steering = 0.0) noexcept;

  /// Changes the settings from the next cycle on. Goal or path, the drive, zones and a plan that is
  /// being made are kept; nothing waits. Scans are forgotten if settings of perception change.
  /// @throws std::invalid_argument unless validate(settings) holds; then nothing changes.
  void set_settings(const Settings& settings);

  /// Runs one control cycle. Never fails: the command is finite and within the limits of the base,
  /// and `lateral` and `steering` of the step complete it.
  [[nodiscard]] NavigationStep update(const Measurements& measurements);

  /// Returns the message to the other robots: the motion of the last cycle, the stop after it, the
  /// planned motion, each with the true outline. Call it after each cycle.
  [[nodiscard]] SharedMotion share(std::uint32_t robot,
                                   double time,
                                   const Pose2& pose) const noexcept;

  /// Makes the plan that the robot needs now without driving. @return whether it follows another
  /// plan from now on.
  bool plan_now(const Measurements& measurements);

  [[nodiscard]] const Settings& settings() const noexcept;
  [[nodiscard]] const RobotModel& robot() const noexcept;

  /// The path of the reference point; its corridor is empty.
  [[nodiscard]] const Plan& plan() const noexcept;
  [[nodiscard]] bool plan_is_current() const noexcept;
  /// Poses of the present drive, from its begin to its end, with the true headings.
  /// @param apart  Greatest distance between two [m], where the robot turns 0.1 rad; > 0.
  [[nodiscard]] std::vector<Pose2> planned_poses(double apart) const;
  [[nodiscard]] bool follows_new_plan() const noexcept;
  [[nodiscard]] bool planned() const noexcept;

  /// Moving obstacles that the lidar tracks.
  [[nodiscard]] MovingObstacles tracked() const noexcept;

  /// The obstacles that plans are made on; null while nothing is known.
  [[nodiscard]] const BitGrid* obstacles() const noexcept;

  /// Waits until the background plan, if any, is made; the next cycle takes it over.
  void wait_for_plan() const noexcept;

  /// Sets a clock [s] by which synchronous plans are timed.
  void lend_clock(std::function<double()> clock);
  [[nodiscard]] double planning_seconds() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace fairway
