// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/map/bit_grid.hpp"
#include "fairway/planning/planner.hpp"

namespace fairway {

/// A path from another planner, and the heading at its end, if one is wanted.
struct GivenPath {
  Path path;
  std::optional<double> goal_heading{};
};

/// What of a given path lies ahead of a robot and inside the map.
struct PathAhead {
  Path path;             ///< from the robot's position on; a single point when nothing is left
  bool complete = true;  ///< whether it reaches the end of the given path
};

/// Cuts a path before the robot (at the waypoint nearest to it) and where it leaves the map or
/// comes within `margin` [m] of its edge. @pre the path has a waypoint.
[[nodiscard]] PathAhead path_ahead(const Path& path,
                                   const Eigen::Vector2d& position,
                                   const GridFrame& map,
                                   double margin);

/// A plan along a path from another planner: a corridor over what of it lies ahead and inside
/// the map. Where the robot's disc does not fit along it, a way of its own to the same end.
///
/// `Plan::whole` tells whether the plan reaches the end of the given path.
/// @pre the path has a waypoint.
[[nodiscard]] Plan plan_along(Planner& planner,
                              const PreparedMap& map,
                              const Eigen::Vector2d& start,
                              const GivenPath& given,
                              const PlannerSettings& settings);

}  // namespace fairway
