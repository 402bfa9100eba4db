// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

#include "fairway/corridor/fewest_rectangles.hpp"
#include "fairway/navigation/settings.hpp"
#include "fairway/planning/background_worker.hpp"
#include "fairway/planning/path_plan.hpp"

namespace fairway {

/// What a plan on a local map is made for.
struct LocalRequest {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  Goal goal;
  std::optional<GivenPath> along{};  ///< a path to follow; then the goal is its end
  double margin = 0.0;               ///< clearance beyond the robot's radius, or less [m]
  bool narrow = false;               ///< whether only a shorter way through less clearance counts
};

/// A plan, and the place that it leads to: the goal, or the free place nearest to it.
struct LocalPlan {
  Plan plan;
  Goal goal;
  LocalRequest request;
};

/// Makes plans on the map that a robot without a map has seen, in the cycle or in a thread.
///
/// The corridor covers the beginning of the path, a little more than a horizon can reach.
class LocalPlanning {
 public:
  /// @param settings  With the margins of a local map.
  /// @param seen      What is known to be occupied.
  LocalPlanning(const Settings& settings, const BitGrid& seen);

  /// Notes that what is seen has changed inside a window since the last plan.
  void note_change(const CellWindow& changed) noexcept { changed_ = united(changed_, changed); }

  /// Brings the map up to date where all of it has changed; without a thread that is a cycle's
  /// work.
  void refresh(const BitGrid& seen);

  [[nodiscard]] bool busy() const noexcept { return !worker_.idle(); }

  /// Makes a plan, or has it made. @pre not busy.
  void start(const BitGrid& seen, const LocalRequest& request);

  /// The plan, once it is made.
  [[nodiscard]] std::optional<LocalPlan> take();

  void wait() const noexcept { worker_.wait(); }

  /// How much of a path a corridor covers [m].
  [[nodiscard]] static double corridor_length(const Settings& settings) noexcept;

 private:
  void make();
  [[nodiscard]] Goal reachable_goal(const Eigen::Vector2d& position,
                                    const Goal& goal) const noexcept;
  [[nodiscard]] Plan find_way(const Eigen::Vector2d& position, const Goal& goal, double margin);

  Settings settings_;
  PreparedMap map_;
  Planner planner_;
  FewestRectangles corridor_;
  CellWindow changed_ = kNoCells;
  LocalRequest request_;
  std::optional<LocalPlan> made_;
  BackgroundWorker worker_;  // last: its end is waited for before the others go
};

}  // namespace fairway
