// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "fairway/navigation/facade/map_navigator.hpp"
#include "fairway/navigation/facade/map_planning.hpp"
#include "fairway/navigation/facade/task_status.hpp"
#include "fairway/navigation/navigator.hpp"
#include "fairway/perception/perception.hpp"

namespace fairway {

/// The inside of a MapNavigator: the map, the task, and the one policy of when to plan.
struct MapNavigator::State {
  State(const Settings& settings,
        ControlSolver* solver,
        const PreparedMap* shared_map,
        Planner* shared_planner);

  void set_settings(const Settings& given);
  void set_task(NavigationTask given);
  void observe(const LidarScan& scan, const Eigen::Vector2d& position);

  /// The map has changed inside a window. @param moved  It lies elsewhere now.
  void change(const CellWindow& window, bool moved = false);

  [[nodiscard]] NavigationStep update(const Measurements& measurements);

  /// Takes over a plan that is ready, and makes one if one is needed.
  /// @param at_once  Do not wait for the retry period.
  void plan_if_needed(const Measurements& measurements, bool at_once);
  [[nodiscard]] const BitGrid* obstacles() const noexcept;

  Settings settings;
  std::unique_ptr<Navigator> navigator;
  std::unique_ptr<MapPlanning> planning;
  std::optional<BitGrid> map;
  std::optional<Perception> perception;  // once a scan was given
  TaskStatus task;
  NavigationInput input;  // of the last cycle
  bool plan_is_current = false;
  bool follows_new_plan = false;
  bool planned = false;  // in the last cycle
  std::function<double()> clock;

 private:
  void make_parts();
  void overlay_scans();
  [[nodiscard]] bool pose_is_known(const Measurements& measurements) const noexcept;
  [[nodiscard]] bool needs_plan(double time, bool at_once);
  void look_at_changes();
  void start_plan(const Measurements& measurements);
  void take_plan();
  [[nodiscard]] bool is_clearly_shorter(const Path& path) const noexcept;
  void follow(Plan plan);
  void set_input(const Measurements& measurements);
  [[nodiscard]] NavigationStep judged(const NavigationStep& step);

  ControlSolver* solver_;  // null: its own
  const PreparedMap* shared_map_;
  Planner* shared_planner_;
  BitGrid seen_;                   // the map and what scans have shown
  CellWindow scanned_ = kNoCells;  // cells of the map under the window of the scans
  std::vector<MovingObstacle> moving_;
  Twist2 sent_;
  double plan_time_ = -std::numeric_limits<double>::infinity();
  int task_number_ = 0;
  int asked_number_ = 0;         // the task of the plan that was asked for last
  bool task_is_new_ = false;     // no plan was asked for since
  bool map_moved_ = false;       // since the plan was looked at
  bool map_changed_ = false;     // since the plan was looked at
  bool scans_changed_ = false;   // since the plan was looked at
  bool blocked_ = false;         // the plan, somewhere
  bool blocked_by_map_ = false;  // not only by what scans have shown, which may be wrong
  bool may_be_better_ = false;   // the map has changed elsewhere since the last plan
  bool asked_ = false;           // by the navigator
};

}  // namespace fairway
