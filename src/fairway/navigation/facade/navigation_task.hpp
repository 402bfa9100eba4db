// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "fairway/geometry/pose2.hpp"
#include "fairway/planning/path_plan.hpp"

namespace fairway {

/// What a navigator is to do: reach a goal, or follow a path to its end.
struct NavigationTask {
  Goal goal;
  std::optional<GivenPath> along{};  ///< a path to follow; then the goal is its end
  bool valid = true;                 ///< finite, with a heading in radians
};

/// Headings beyond two turns are taken for degrees.
[[nodiscard]] inline bool is_valid(const Goal& goal) noexcept {
  constexpr double kMostHeading = 2.0 * std::numbers::pi;
  return is_finite(goal.position) && !(goal.heading && !(std::abs(*goal.heading) <= kMostHeading));
}

[[nodiscard]] inline NavigationTask task_of(const Goal& goal) {
  return {.goal = goal, .along = {}, .valid = is_valid(goal)};
}

/// @pre the path has a waypoint.
[[nodiscard]] inline NavigationTask task_of(Path path, const std::optional<double>& goal_heading) {
  const Goal end{.position = path.waypoints.back(), .heading = goal_heading};
  bool valid = is_valid(end);
  for (const Eigen::Vector2d& point : path.waypoints)
    valid = valid && is_finite(point);
  return {.goal = end,
          .along = GivenPath{.path = std::move(path), .goal_heading = goal_heading},
          .valid = valid};
}

}  // namespace fairway
