// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/map/bit_grid.hpp"
#include "fairway/planning/planner.hpp"

namespace fairway {

/// A path from another planner, and the heading required at its end, if any.
struct GivenPath {
  Path path;
  std::optional<double> goal_heading{};
};

/// The part of a given path that lies ahead of a robot and inside the map.
struct PathAhead {
  Path path;             ///< from the robot's position on; a single point if nothing is left
  bool complete = true;  ///< whether it reaches the end of the given path
};

/// Returns the part of a path that lies ahead of the robot and inside the map. It begins after the
/// waypoint nearest to the robot, and ends where the path leaves the map or comes within `margin`
/// [m] of its edge. @pre the path has a waypoint.
[[nodiscard]] PathAhead path_ahead(const Path& path,
                                   const Eigen::Vector2d& position,
                                   const GridFrame& map,
                                   double margin);

/// Plans along a path from another planner.
///
/// The plan is a corridor over the part of the path ahead of the robot and inside the map. If the
/// robot's disc does not fit along it, the planner searches another path to the same end.
/// `Plan::whole` is true if the plan reaches the end of the given path.
/// @pre the path has a waypoint.
[[nodiscard]] Plan plan_along(Planner& planner,
                              const PreparedMap& map,
                              const Eigen::Vector2d& start,
                              const GivenPath& given,
                              const PlannerSettings& settings);

}  // namespace fairway
