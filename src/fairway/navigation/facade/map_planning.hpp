// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "fairway/navigation/settings.hpp"
#include "fairway/planning/background_worker.hpp"
#include "fairway/planning/path_plan.hpp"

namespace fairway {

/// What a plan is made for.
struct PlanRequest {
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
  Goal goal;
  std::optional<GivenPath> along{};  ///< a path to follow; then the goal is its end
};

/// Makes the plans of one robot on a map that changes, in the cycle that asks or in a thread.
///
/// It keeps a prepared copy of the map and brings it up to date by the windows that changed.
class MapPlanning {
 public:
  explicit MapPlanning(const Settings& settings);

  /// Plans on a map and with a planner of the caller, for many robots on one map; never in a
  /// thread. Both must outlive this.
  MapPlanning(const Settings& settings, const PreparedMap& map, Planner& planner);

  /// Notes that the obstacles differ from those of the last plan inside `changed`, too.
  void note_change(const CellWindow& changed) noexcept { changed_ = united(changed_, changed); }

  [[nodiscard]] bool busy() const noexcept { return !worker_.idle(); }

  /// Makes a plan, or has it made. @pre not busy.
  void start(const BitGrid& obstacles, PlanRequest request);

  /// The plan, once it is made.
  [[nodiscard]] std::optional<Plan> take();

  /// Waits until the plan that is being made is made.
  void wait() const noexcept { worker_.wait(); }

  void lend_clock(std::function<double()> clock) { clock_ = std::move(clock); }
  [[nodiscard]] double seconds() const noexcept { return seconds_; }  ///< the last plan took [s]

 private:
  void make();

  PlannerSettings settings_;
  bool background_;
  const PreparedMap* map_;
  Planner* planner_;
  std::unique_ptr<PreparedMap> own_map_;
  std::unique_ptr<Planner> own_planner_;
  CellWindow changed_ = kNoCells;
  PlanRequest request_;       // the worker's while it runs, like everything above but changed_
  std::optional<Plan> made_;  // the worker's while it runs
  std::function<double()> clock_;
  double seconds_ = 0.0;
  BackgroundWorker worker_;  // last: its end is waited for before the others go
};

}  // namespace fairway
