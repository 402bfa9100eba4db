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

/// State of a MapNavigator: the map, the task, and the policy that determines when to plan.
struct MapNavigator::State {
  State(const Settings& settings,
        ControlSolver* solver,
        const PreparedMap* shared_map,
        Planner* shared_planner);

  void set_settings(const Settings& given);
  void set_task(NavigationTask given);
  void set_zones(const Zones& given);
  [[nodiscard]] bool observe(const LidarScan& scan, const Eigen::Vector2d& position);

  /// Records that the map has changed inside a window. @param moved  Whether its frame has changed.
  void change(const CellWindow& window, bool moved = false);

  [[nodiscard]] NavigationStep update(const Measurements& measurements);

  /// Takes over a plan that is ready, and makes one if one is needed.
  /// @param at_once  Whether to ignore the retry period.
  void plan_if_needed(const Measurements& measurements, bool at_once);
  [[nodiscard]] const BitGrid* obstacles() const noexcept;

  Settings settings;
  std::unique_ptr<Navigator> navigator;
  std::unique_ptr<MapPlanning> planning;
  std::optional<BitGrid> map;
  std::shared_ptr<const ZoneMap> zones;  // of the map; null without
  bool hold = false;
  std::optional<Perception> perception;  // since the first scan
  TaskStatus task;
  NavigationInput input;  // input of the last cycle
  bool plan_is_current = false;
  bool follows_new_plan = false;
  bool planned = false;  // whether the last cycle made a plan
  std::function<double()> clock;

 private:
  void make_navigator();
  void use_zones(const Zones& given);
  void overlay_scans();
  [[nodiscard]] bool pose_is_known(const Measurements& measurements) const noexcept;
  [[nodiscard]] bool needs_plan(const Measurements& measurements, bool at_once);
  [[nodiscard]] bool has_clearance(const Eigen::Vector2d& position) const noexcept;
  void check_plan();
  void start_plan(const Measurements& measurements);
  void take_plan();
  [[nodiscard]] bool is_clearly_shorter(const Path& path) const noexcept;
  void follow(Plan plan);
  void set_input(const Measurements& measurements);
  [[nodiscard]] NavigationStep judged(const NavigationStep& step);

  ControlSolver* solver_;  // null: the navigator's own solver
  const PreparedMap* shared_map_;
  Planner* shared_planner_;
  BitGrid seen_;                   // obstacles of the map and of scans
  CellWindow scanned_ = kNoCells;  // cells of the map under the window of the scans
  std::vector<MovingObstacle> moving_;
  bool scan_refused_ = false;  // the last one
  double plan_time_ = -std::numeric_limits<double>::infinity();
  int task_number_ = 0;
  int asked_number_ = 0;         // task for which the last plan was requested
  bool task_is_new_ = false;     // no plan was requested for the task yet
  bool map_moved_ = false;       // since the last check of the plan
  bool map_changed_ = false;     // since the last check of the plan
  bool zones_changed_ = false;   // since the last plan was requested
  bool scans_changed_ = false;   // since the last check of the plan
  bool blocked_ = false;         // the plan is blocked
  bool blocked_by_map_ = false;  // by the map, and not only by scans, which may be wrong
  bool may_be_better_ = false;   // the map has changed since the last plan
  bool asked_ = false;           // the navigator requested a plan
  bool tight_start_ = false;     // the plan begins where the covering disc does not fit
};

}  // namespace fairway
