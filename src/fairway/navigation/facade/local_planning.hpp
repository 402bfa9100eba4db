// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

#include "fairway/corridor/fewest_rectangles.hpp"
#include "fairway/navigation/facade/opening_search.hpp"
#include "fairway/navigation/settings.hpp"
#include "fairway/planning/background_worker.hpp"
#include "fairway/planning/path_plan.hpp"

namespace fairway {

/// Request for a plan on a local map.
struct LocalRequest {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  Goal goal;
  std::optional<GivenPath> along{};  ///< a path to follow; the goal is then its end
  double margin = 0.0;               ///< desired clearance beyond the robot's radius [m]
  bool narrow = false;        ///< whether only a shorter path with less clearance is of interest
  bool find_opening = false;  ///< whether to search an opening where there is no path
  TriedOpenings tried{};      ///< openings that were examined before
};

/// A plan, and the place that it leads to: the goal, or the free place nearest to it.
struct LocalPlan {
  Plan plan;
  Goal goal;
  LocalRequest request;
  std::optional<Opening> opening{};  ///< where a path would most probably open; only on request
  Plan to_opening{};                 ///< to the opening's viewpoint, turned towards it
};

/// Plans on the local map of a robot without a map, in the control cycle or in a thread.
///
/// The corridor covers the beginning of the path, slightly more than a horizon can reach. Without a
/// thread, a plan that takes long searches is paused, and the next cycle continues it.
class LocalPlanning {
 public:
  /// @param settings  Settings with the margins of a local map.
  /// @param seen      Cells known to be occupied.
  LocalPlanning(const Settings& settings, const BitGrid& seen);

  /// Records that the local map has changed inside a window since the last plan.
  void note_change(const CellWindow& changed) noexcept { changed_ = united(changed_, changed); }

  /// Updates the map after all of it has changed. Without a thread this takes the time of a cycle.
  void refresh(const BitGrid& seen);

  [[nodiscard]] bool busy() const noexcept { return !worker_.idle() || paused(); }

  /// Whether a thread works on a plan now.
  [[nodiscard]] bool runs() const noexcept { return !worker_.idle() && !worker_.finished(); }

  /// Continues a paused plan, and returns whether there was one. Call it once per cycle.
  bool resume();

  /// Makes a plan, or starts the thread that makes it. @pre not busy.
  void start(const BitGrid& seen, const LocalRequest& request);

  /// Returns the plan once it is made.
  [[nodiscard]] std::optional<LocalPlan> take();

  void wait() const noexcept { worker_.wait(); }

  /// Length of the part of a path that a corridor covers [m].
  [[nodiscard]] static double corridor_length(const Settings& settings) noexcept;

 private:
  [[nodiscard]] bool paused() const noexcept {
    return !settings_.planning.background && made_ && made_->plan.paused;
  }
  void make();
  void make_plan(const Plan* begun);
  [[nodiscard]] Goal reachable_goal(const Eigen::Vector2d& position,
                                    const Goal& goal) const noexcept;
  [[nodiscard]] Plan find_path(const Eigen::Vector2d& position,
                               const Goal& goal,
                               double margin,
                               const PlannerHooks& hooks = {});
  void find_opening();

  Settings settings_;
  PreparedMap map_;
  Planner planner_;
  FewestRectangles corridor_;
  OpeningSearch openings_;
  CellWindow changed_ = kNoCells;
  LocalRequest request_;
  std::optional<LocalPlan> made_;
  BackgroundWorker worker_;  // last member: its job ends before the others are destroyed
};

}  // namespace fairway
