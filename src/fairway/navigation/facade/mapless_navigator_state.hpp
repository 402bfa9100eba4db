// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "fairway/navigation/facade/local_planning.hpp"
#include "fairway/navigation/facade/lost_path_behaviour.hpp"
#include "fairway/navigation/facade/mapless_navigator.hpp"
#include "fairway/navigation/facade/task_status.hpp"
#include "fairway/navigation/navigator.hpp"
#include "fairway/perception/perception.hpp"

namespace fairway {

/// State of a MaplessNavigator: the local map, the task, and the policy that determines when to
/// plan.
struct MaplessNavigator::State {
  State(const Settings& given, ControlSolver* solver, const Eigen::Vector2d& position);

  /// Takes over motion, task and plans that are being made from the state with older settings.
  void continue_from(State& older);

  void set_task(NavigationTask given);
  void set_zones(const Zones& given);
  [[nodiscard]] bool observe(const LidarScan& scan, const Eigen::Vector2d& position);
  [[nodiscard]] NavigationStep update(const Measurements& measurements);
  [[nodiscard]] NavigationStep replay(const NavigationInput& recorded, std::optional<Plan> plan);

  Settings settings;
  ControlSolver* solver;  // null: the navigator's own solver
  Settings wider;         // settings with the margins of a local map
  Perception perception;
  Navigator navigator;
  std::unique_ptr<LocalPlanning> planning;
  TaskStatus task;
  NavigationInput input;
  bool planned = false;           // whether the last cycle made a plan
  bool follows_new_plan = false;  // whether the last cycle took over a plan
  bool plan_is_current = false;
  Twist2 sent;
  Zones zones;
  bool hold = false;

 private:
  [[nodiscard]] bool needs_plan(double time, const Eigen::Vector2d& position) const noexcept;
  [[nodiscard]] bool has_clearance(const Eigen::Vector2d& position) const noexcept;
  [[nodiscard]] bool path_is_free() const noexcept;
  [[nodiscard]] bool plan_fits_map() const noexcept;
  [[nodiscard]] NavigationStep cycle(const Measurements& measurements);
  void start_plan(double time, const Pose2& pose);
  void take_plan();
  [[nodiscard]] NavigationStep drive(const Measurements& measurements, bool planning_now);
  [[nodiscard]] NavigationStep judged(const NavigationStep& step);
  void use(Plan plan, bool leads_to_goal);
  void no_path(LocalPlan& made);
  void act_without_path(const Measurements& measurements);
  [[nodiscard]] Plan turn_plan(const Pose2& pose, double heading) const;
  [[nodiscard]] bool turns() const noexcept;

  std::vector<MovingObstacle> moving_;
  std::vector<std::unique_ptr<LocalPlanning>> ending_;  // of older settings, until they are idle
  bool scan_refused_ = false;                           // the last one
  int task_number_ = 0;
  int asked_number_ = 0;  // task for which the last plan was requested
  bool rolled_ = true;    // whether the window has moved since the map was refreshed
  bool asked_for_plan_ = true;
  bool tight_start_ = false;    // whether the plan begins where the covering disc does not fit
  bool leads_to_goal_ = false;  // whether the present corridor does
  bool search_narrow_ = false;  // for the next plan: the present one is a long detour
  LostPathBehaviour lost_;
  TriedOpenings tried_;
  bool search_opening_ = false;  // with the next plan, if there is no path
  bool plan_done_ = false;       // whether the plan being followed has been completed
  bool turn_refused_ = false;    // whether the last command of a turn could not be proven
  int scans_ = 0;                // number of scans so far
  double blind_angle_ = 0.0;     // part of a full turn that the last scan did not cover [rad]
  double plan_time_ = 0.0;
  // Margin of the last usable plan [m].
  double last_margin_ = std::numeric_limits<double>::infinity();
  double path_length_ = std::numeric_limits<double>::infinity();  // length of its path [m]
};

}  // namespace fairway
