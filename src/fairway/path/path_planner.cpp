// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/path_planner.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/base/contract.hpp"
#include "fairway/geometry/pose2.hpp"
#include "fairway/map/free_space.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

Vector2d center(CellIndex cell) { return {cell.x + 0.5, cell.y + 0.5}; }

bool on_map(const GridFrame& frame, const Vector2d& point) {
  return is_finite(point) && frame.contains(frame.cell_at(point));
}

}  // namespace

PathResult PathPlanner::find(const BitGrid& obstacles,
                             const DistanceField& distances,
                             const Vector2d& start,
                             const Vector2d& goal,
                             double robot_radius,
                             const PathSettings& settings) {
  // This form also rejects NaN.
  if (!(robot_radius >= 0.0 && settings.margin >= 0.0) ||
      !std::isfinite(robot_radius + settings.margin)) {
    return {.status = PathStatus::InvalidInput, .path = {}};
  }
  const GridFrame& frame = obstacles.frame();
  if (!on_map(frame, start)) return {.status = PathStatus::StartOutsideMap, .path = {}};
  if (!on_map(frame, goal)) return {.status = PathStatus::GoalOutsideMap, .path = {}};
  if (!is_free(obstacles, start, start, robot_radius))
    return {.status = PathStatus::StartBlocked, .path = {}};
  if (!is_free(obstacles, goal, goal, robot_radius))
    return {.status = PathStatus::GoalBlocked, .path = {}};

  const TravelCost costs(obstacles, distances, robot_radius + settings.margin, settings);
  start_.point = frame.to_grid(start);
  goal_.point = frame.to_grid(goal);
  join_grid(costs, robot_radius, start_);
  join_grid(costs, robot_radius, goal_);
  PathResult result;
  if (search(costs, result)) {
    result.status = PathStatus::Found;
    result.path = straight_path(costs, settings.any_angle);
    result.path.waypoints.front() = start;
    result.path.waypoints.back() = goal;
  } else if (is_free(obstacles, start, goal, costs.required())) {
    // The clearance between two walls may suffice on a line, but not at the centre of any cell.
    result.status = PathStatus::Found;
    result.cost = costs.line(start_.point, goal_.point).cost * frame.resolution;
    result.path.waypoints = {start, goal};
  }
  return result;
}

// Finds the cells around an end that the robot can reach in a straight line. If the end is too
// close to an obstacle for the margin, the cells may be further away, and the line to them keeps
// only the radius.
void PathPlanner::join_grid(const TravelCost& costs, double robot_radius, End& end) {
  end.cells.clear();
  const GridFrame& frame = costs.frame();
  const Vector2d world = frame.to_world(end.point);
  end.tight = !is_free(costs.obstacles(), world, world, costs.required());
  if (!end.tight) {
    for (int ring = 0; ring <= 2 && (ring < 2 || end.cells.empty()); ++ring)
      add_ring(costs, costs.required(), ring, end);
  }
  if (end.cells.empty()) {
    // To leave a gap between two posts straight ahead takes sqrt(required^2 - radius^2) until the
    // margin is kept; twice that distance also leads out of most corners.
    end.tight = true;
    const double required = costs.required();
    const double exit_distance =
        std::sqrt(std::max(0.0, required * required - robot_radius * robot_radius));
    const int last =
        2 + static_cast<int>(std::min(40.0, std::ceil(2.0 * exit_distance / frame.resolution)));
    int more = 2;  // further rings after the first one with a cell: they may have better cells
    for (int ring = 0; ring <= last && more > 0; ++ring) {
      if (add_ring(costs, robot_radius, ring, end) || !end.cells.empty()) --more;
    }
  }
  end.terminals.clear();
  end.blocks.clear();
  const int step = GridSearch::kStep * SearchGrid::unit_for(costs);
  for (const CellIndex cell : end.cells) {
    const double cost = costs.line(end.point, center(cell)).cost * step;
    const auto rounded = [](double v) { return static_cast<std::uint32_t>(std::lround(v)); };
    end.terminals.push_back({.node = cell, .cost = rounded(cost)});
    end.blocks.push_back(
        {.node = BlockGrid::block_of(cell), .cost = rounded(cost / BlockGrid::kSide)});
  }
}

bool PathPlanner::add_ring(const TravelCost& costs, double clearance, int ring, End& end) {
  const GridFrame& frame = costs.frame();
  const CellIndex middle{.x = static_cast<int>(std::floor(end.point.x())),
                         .y = static_cast<int>(std::floor(end.point.y()))};
  const std::size_t before = end.cells.size();
  for (int dy = -ring; dy <= ring; ++dy) {
    const int step = std::abs(dy) == ring ? 1 : std::max(1, 2 * ring);
    for (int dx = -ring; dx <= ring; dx += step) {
      const CellIndex cell{.x = middle.x + dx, .y = middle.y + dy};
      if (costs.is_allowed(cell) &&
          is_free(costs.obstacles(), frame.to_world(end.point), frame.center(cell), clearance)) {
        end.cells.push_back(cell);
      }
    }
  }
  return end.cells.size() > before;
}

bool PathPlanner::search(const TravelCost& costs, PathResult& result) {
  blocks_.begin(costs);
  bool found = search_.find(blocks_, start_.blocks, goal_.blocks);
  result.expanded = search_.expanded();
  if (!found) return false;
  coarse_path_.assign(search_.nodes().begin(), search_.nodes().end());
  cells_.begin(costs, coarse_path_);
  found = search_.find(cells_, start_.terminals, goal_.terminals);
  result.expanded += search_.expanded();
  if (!found) {
    // The blocks treat their cells as connected, which may be wrong. Search all cells.
    cells_.begin(costs);
    found = search_.find(cells_, start_.terminals, goal_.terminals);
    result.expanded += search_.expanded();
  }
  result.cost = search_.cost() * costs.frame().resolution / (GridSearch::kStep * cells_.unit());
  return found;
}

Path PathPlanner::straight_path(const TravelCost& costs, bool any_angle) {
  const GridFrame& frame = costs.frame();
  points_.clear();
  if (!start_.tight) points_.push_back(start_.point);
  for (const CellIndex cell : search_.nodes())
    points_.push_back(center(cell));
  if (!goal_.tight) points_.push_back(goal_.point);
  if (any_angle) straightening_.apply(costs, points_);
  Path path;
  path.waypoints.reserve(points_.size() + 2);
  if (start_.tight) path.waypoints.push_back(frame.to_world(start_.point));
  for (const Vector2d& point : points_)
    path.waypoints.push_back(frame.to_world(point));
  if (goal_.tight) path.waypoints.push_back(frame.to_world(goal_.point));
  return path;
}

}  // namespace fairway
