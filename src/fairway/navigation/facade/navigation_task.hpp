// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "fairway/geometry/pose2.hpp"
#include "fairway/planning/path_plan.hpp"

namespace fairway {

/// The task of a navigator: reach a goal, or follow a path to its end.
struct NavigationTask {
  Goal goal;
  std::optional<GivenPath> along{};  ///< a path to follow; then the goal is its end
  bool valid = true;                 ///< plausible places, with a heading in radians
};

/// Returns whether the goal is finite. A heading beyond 2 pi is rejected as given in degrees.
[[nodiscard]] inline bool is_valid(const Goal& goal) noexcept {
  constexpr double kMostHeading = 2.0 * std::numbers::pi;
  return is_plausible(goal.position) &&
         !(goal.heading && !(std::abs(*goal.heading) <= kMostHeading));
}

[[nodiscard]] inline NavigationTask task_of(const Goal& goal) {
  return {.goal = goal, .along = {}, .valid = is_valid(goal)};
}

/// Makes the task to follow `path`. @pre the path has a waypoint.
[[nodiscard]] inline NavigationTask task_of(Path path, const std::optional<double>& goal_heading) {
  const Goal end{.position = path.waypoints.back(), .heading = goal_heading};
  bool valid = is_valid(end);
  for (const Eigen::Vector2d& point : path.waypoints)
    valid = valid && is_plausible(point);
  return {.goal = end,
          .along = GivenPath{.path = std::move(path), .goal_heading = goal_heading},
          .valid = valid};
}

}  // namespace fairway
