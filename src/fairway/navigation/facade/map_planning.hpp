// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "fairway/navigation/settings.hpp"
#include "fairway/planning/background_worker.hpp"
#include "fairway/planning/path_plan.hpp"

namespace fairway {

/// Request for a plan.
struct PlanRequest {
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
  Goal goal;
  std::optional<GivenPath> along{};  ///< a path to follow; the goal is then its end
};

/// Makes the plans of one robot on a changing map, in the control cycle or in a thread.
///
/// It keeps a prepared copy of the map and updates it inside the windows that changed.
class MapPlanning {
 public:
  explicit MapPlanning(const Settings& settings);

  /// Uses a map and a planner of the caller, for many robots on one map, and never a thread. Both
  /// must outlive this object.
  MapPlanning(const Settings& settings, const PreparedMap& map, Planner& planner);

  /// Records that the obstacles also differ from those of the last plan inside `changed`.
  void note_change(const CellWindow& changed) noexcept { changed_ = united(changed_, changed); }

  /// Makes the next plans with other settings. One that is being made keeps its own.
  void set_settings(const Settings& settings);

  [[nodiscard]] bool busy() const noexcept { return !worker_.idle(); }

  /// Makes a plan, or starts the thread that makes it. @pre not busy.
  void start(const BitGrid& obstacles, PlanRequest request);

  /// Returns the plan once it is made.
  [[nodiscard]] std::optional<Plan> take();

  /// Why there is no path, in one sentence with numbers (`explain`); empty after a usable plan. It
  /// is made in the thread only: it takes time that a control cycle does not have.
  [[nodiscard]] const std::string& explanation() const noexcept { return explanation_; }

  /// Records that the next plans are for another task, which has no explanation yet.
  void begin_task() noexcept;

  /// Waits until the plan being made is finished.
  void wait() const noexcept { worker_.wait(); }

  void lend_clock(std::function<double()> clock) { clock_ = std::move(clock); }
  /// Duration of the last plan [s].
  [[nodiscard]] double seconds() const noexcept { return seconds_; }

 private:
  void make();
  void make_explanation();

  PlannerSettings wanted_;  // of the next plan
  bool background_;         // for the next plan
  PlannerSettings settings_;
  const PreparedMap* map_;
  Planner* planner_;
  std::unique_ptr<PreparedMap> own_map_;
  std::unique_ptr<Planner> own_planner_;
  CellWindow changed_ = kNoCells;
  // The worker's while it runs, like settings_, maps and planners above.
  PlanRequest request_;
  std::optional<Plan> made_;  // the worker's while it runs
  std::string explained_;     // the worker's while it runs
  int failures_ = 0;          // plans in a row that were not usable; the worker's while it runs
  std::string explanation_;
  bool task_is_new_ = false;  // no plan for it was started
  std::function<double()> clock_;
  double seconds_ = 0.0;
  BackgroundWorker worker_;  // last member: its job ends before the others are destroyed
};

}  // namespace fairway
