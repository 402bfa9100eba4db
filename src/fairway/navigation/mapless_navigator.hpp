// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "fairway/corridor/fewest_rectangles.hpp"
#include "fairway/navigation/navigator.hpp"
#include "fairway/perception/perception.hpp"

namespace fairway {

/// Drives one robot to a goal without a map: on what its lidar has seen so far.
///
/// What nobody has seen may be planned through, but the stop check treats it as blocked, so the
/// robot is never faster than it can stop inside what it has seen. The corridor covers the
/// beginning of the path, a little more than a horizon can reach. Both are made anew when something
/// new stands in the corridor or on the path, when the corridor's end comes near, when the
/// navigator asks, and after a while without success; so a dead end is left as soon as it shows.
/// All poses are in one frame that need not be true far away: odometry will do.
class MaplessNavigator {
 public:
  /// @param solver  Must outlive it.
  /// @param position  Where the robot is at first [m].
  MaplessNavigator(const Settings& settings,
                   ControlSolver& solver,
                   std::size_t max_beams,
                   const Eigen::Vector2d& position);

  void set_goal(const Goal& goal);

  /// Forgets the goal: the robot brakes to a stand. Without a goal it stands, too.
  void cancel();

  /// As Navigator::reset.
  void reset(const Twist2& actual) noexcept { navigator_.reset(actual); }

  /// Takes in one scan; several may come between two cycles.
  /// @param position  Where the robot was at the scan's time [m].
  void observe(const LidarScan& scan, const Eigen::Vector2d& position) noexcept;

  /// One control cycle: plans if there is need, then navigates.
  [[nodiscard]] NavigationStep update(double time, const Pose2& pose) {
    return update(time, pose, time);
  }

  /// The same with a pose that was true at `pose_time` [s]; on one that is too old the robot stops.
  [[nodiscard]] NavigationStep update(double time, const Pose2& pose, double pose_time);

  [[nodiscard]] const Perception& perception() const noexcept { return perception_; }
  [[nodiscard]] const Navigator& navigator() const noexcept { return navigator_; }
  [[nodiscard]] bool planned() const noexcept { return planned_; }  ///< in the last cycle

  /// Whether the last cycle has begun to follow another plan.
  [[nodiscard]] bool follows_new_plan() const noexcept { return follows_new_plan_; }

  /// What the navigator was told in the last cycle; valid until the next call of a function that is
  /// not const.
  [[nodiscard]] const NavigationInput& input() const noexcept { return input_; }

 private:
  [[nodiscard]] bool wants_plan(double time) const noexcept;
  void refresh_map() noexcept;
  [[nodiscard]] bool corridor_is_free(double length) const noexcept;
  [[nodiscard]] bool path_is_free() const noexcept;
  [[nodiscard]] Goal reachable_goal(const Eigen::Vector2d& position) const noexcept;
  [[nodiscard]] Plan find_way(const Eigen::Vector2d& position, const Goal& goal, double margin);
  void plan(double time, const Pose2& pose);

  Settings settings_;
  Perception perception_;
  Navigator navigator_;
  Planner planner_;
  FewestRectangles corridor_;
  PreparedMap map_;
  Goal goal_;
  CellWindow changed_;  // since the map was refreshed
  bool rolled_ = true;  // likewise
  bool asked_for_plan_ = true;
  bool leads_to_goal_ = false;  // the present corridor
  bool has_goal_ = false;
  bool planned_ = false;
  bool look_for_narrow_ = false;  // in the next plan: the present one goes a long way round
  bool follows_new_plan_ = false;
  NavigationInput input_;
  double plan_time_ = 0.0;
  double last_margin_ = std::numeric_limits<double>::infinity();  // of the last usable plan
  double way_length_ = std::numeric_limits<double>::infinity();   // likewise, of its path [m]
};

}  // namespace fairway
