// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/path_plan.hpp"

#include <limits>
#include <utility>

#include "fairway/corridor/corridor_builder.hpp"

namespace fairway {

namespace {

std::size_t nearest_waypoint(const Path& path, const Eigen::Vector2d& position) {
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < path.waypoints.size(); ++i) {
    const double distance = (path.waypoints[i] - position).squaredNorm();
    if (distance < least) {
      least = distance;
      nearest = i;
    }
  }
  return nearest;
}

}  // namespace

PathAhead path_ahead(const Path& path,
                     const Eigen::Vector2d& position,
                     const GridFrame& map,
                     double margin) {
  const auto inside = [&](const Eigen::Vector2d& point) {
    const Eigen::Vector2d at = map.to_grid(point) * map.resolution;
    return at.x() > margin && at.x() < map.width * map.resolution - margin && at.y() > margin &&
           at.y() < map.height * map.resolution - margin;
  };
  Path ahead{.waypoints = {position}};
  for (std::size_t i = nearest_waypoint(path, position) + 1;
       i < path.waypoints.size() && inside(path.waypoints[i]); ++i) {
    ahead.waypoints.push_back(path.waypoints[i]);
  }
  if (ahead.waypoints.size() == 1 && inside(path.waypoints.back())) {
    ahead.waypoints.push_back(path.waypoints.back());
  }
  const bool complete = ahead.waypoints.back() == path.waypoints.back();
  return {.path = std::move(ahead), .complete = complete};
}

Plan plan_along(Planner& planner,
                const PreparedMap& map,
                const Eigen::Vector2d& start,
                const GivenPath& given,
                const PlannerSettings& settings) {
  // Waypoints within a radius of the edge are left out, because the corridor must end inside the
  // map.
  const GridFrame& frame = map.obstacles.frame();
  PathAhead ahead = path_ahead(given.path, start, frame, settings.radius + frame.resolution);
  const Goal goal{.position = ahead.path.waypoints.back(),
                  .heading = ahead.complete ? given.goal_heading : std::nullopt};
  CorridorResult covered =
      build_corridor(map.obstacles, ahead.path, settings.radius, settings.corridor);
  if (covered.status == CorridorStatus::Built) {
    return {.path_status = PathStatus::Found,
            .corridor_status = CorridorStatus::Built,
            .path = std::move(ahead.path),
            .corridor = std::move(covered.corridor),
            .goal = goal,
            .whole = ahead.complete};
  }
  Plan own = planner.plan(map, start, goal, settings);
  own.whole = own.whole && ahead.complete;
  return own;
}

}  // namespace fairway
