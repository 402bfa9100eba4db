// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/path_planner.hpp"

#include <algorithm>
#include <array>
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

// Returns the point with the greatest clearance among some in the cell about `centre`, its sides
// included. It returns the centre itself where that is enough.
Vector2d best_in_cell(const TravelCost& costs, const Vector2d& centre) noexcept {
  constexpr std::array kOffsets = {0.0, 0.25, -0.25, 0.5, -0.5};  // [cells]
  if (costs.fits(centre, centre)) return centre;
  const GridFrame& frame = costs.frame();
  const double enough = costs.required() + frame.resolution;
  Vector2d best = centre;
  double most = -1.0;
  for (const double y : kOffsets) {
    for (const double x : kOffsets) {
      const Vector2d point = centre + Vector2d(x, y);
      const double clearance =
          distance_to_blocked(costs.obstacles(), frame.to_world(point), enough);
      if (clearance <= most) continue;
      most = clearance;
      best = point;
    }
  }
  return best;
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
  goal_.is_goal = true;
  const auto leads_straight = [&] {
    return is_free(obstacles, start, goal, costs.required()) &&
           !costs.goes_against_zone(start_.point, goal_.point);
  };
  join_grid(costs, robot_radius, start_);
  join_grid(costs, robot_radius, goal_);
  PathResult result;
  bool found = search(costs, settings.any_angle, result);
  if (!found && !leads_straight()) {
    found = search_between_centres(costs, settings, robot_radius, result);
  }
  if (found) {
    result.status = PathStatus::Found;
    result.path = straight_path(costs, settings.any_angle);
    result.path.waypoints.front() = start;
    result.path.waypoints.back() = goal;
  } else if (leads_straight()) {
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
    // A robot that leaves a gap between two posts keeps the margin after sqrt(required^2 -
    // radius^2). Twice that distance also leads out of most corners.
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
          is_free(costs.obstacles(), frame.to_world(end.point), frame.center(cell), clearance) &&
          may_join(costs, end, center(cell))) {
        end.cells.push_back(cell);
      }
    }
  }
  return end.cells.size() > before;
}

// Finds a chain of points between the ends. It may leave out cells if the path is `any_angle`.
bool PathPlanner::search(const TravelCost& costs, bool any_angle, PathResult& result) {
  result.expanded = 0;
  bool found = false;
  if (!costs.needs_fine_search()) {
    const bool known = blocks_.begin(costs);
    found = known ? block_search_.find_further(blocks_, start_.blocks, goal_.blocks)
                  : block_search_.find(blocks_, start_.blocks, goal_.blocks);
    result.expanded = block_search_.expanded();
    if (!found) return false;
    const std::span<const CellIndex> blocks = block_search_.nodes();
    if (any_angle && chain_is_good(costs, blocks)) {
      points_.assign(chain_.points().begin(), chain_.points().end());
      result.cost = chain_.cost() * costs.frame().resolution;
      return true;
    }
    cells_.begin(costs, blocks);
    found = search_.find(cells_, start_.terminals, goal_.terminals);
    result.expanded += search_.expanded();
  }
  if (!found) {
    // The blocks treat their cells as connected, which may be wrong. Search all cells.
    cells_.begin(costs);
    found = search_.find(cells_, start_.terminals, goal_.terminals);
    result.expanded += search_.expanded();
  }
  result.cost = search_.cost() * costs.frame().resolution / (GridSearch::kStep * cells_.unit());
  take_centres();
  return found;
}

// Finds a chain of points along the blocks. Returns whether it is as good as one of cells would be:
// where it costs more than the blocks promise, the passage is too narrow for a choice per block.
// Where all metres cost the same, shortest paths touch obstacles, and only cells are fine enough.
bool PathPlanner::chain_is_good(const TravelCost& costs, std::span<const CellIndex> blocks) {
  constexpr double kMostShare = 1.03;  // of the cost of the blocks
  constexpr double kRounding = 2.0;    // of both ends to blocks [cells]
  if (costs.rise() == 0.0F) return false;
  if (!chain_.find(costs, blocks, start_.terminals, goal_.terminals)) return false;
  const double promised = BlockGrid::kSide * block_search_.cost() /
                          static_cast<double>(GridSearch::kStep * blocks_.unit());
  return chain_.cost() <= kMostShare * promised + kRounding;
}

void PathPlanner::take_centres() {
  points_.clear();
  for (const CellIndex cell : search_.nodes())
    points_.push_back(center(cell));
}

// Whether one-way zones allow the line between an end and a point of the grid.
bool PathPlanner::may_join(const TravelCost& costs, const End& end, const Vector2d& point) {
  return !(end.is_goal ? costs.goes_against_zone(point, end.point)
                       : costs.goes_against_zone(end.point, point));
}

// Searches with so much less clearance that the cell beside the best point is allowed. It then
// moves every point to the best one in its cell, and keeps the path if all of it has the whole
// clearance.
bool PathPlanner::search_between_centres(const TravelCost& costs,
                                         const PathSettings& settings,
                                         double robot_radius,
                                         PathResult& result) {
  constexpr double kHalfDiagonal = 0.7072;  // [cells]
  const double less = std::max(0.0, costs.required() - kHalfDiagonal * costs.frame().resolution);
  const TravelCost loose(costs.obstacles(), costs.distances(), less, settings);
  join_grid(loose, std::min(robot_radius, less), start_);
  join_grid(loose, std::min(robot_radius, less), goal_);
  if (!search(loose, false, result)) return false;
  for (Vector2d& point : points_)
    point = best_in_cell(costs, point);
  const auto is_tight = [&](const Vector2d& point) { return !costs.fits(point, point); };
  start_.tight = is_tight(start_.point);
  goal_.tight = is_tight(goal_.point);
  return fits_along(costs, robot_radius);
}

// Whether the path keeps its clearance; from and to a tight end it keeps the radius only.
bool PathPlanner::fits_along(const TravelCost& costs, double robot_radius) const noexcept {
  const auto fits = [&](const End& end, const Vector2d& point) {
    if (!may_join(costs, end, point)) return false;
    if (!end.tight) {
      return end.is_goal ? costs.fits(point, end.point) : costs.fits(end.point, point);
    }
    const GridFrame& frame = costs.frame();
    return is_free(costs.obstacles(), frame.to_world(end.point), frame.to_world(point),
                   robot_radius);
  };
  for (std::size_t i = 1; i < points_.size(); ++i) {
    if (!costs.fits(points_[i - 1], points_[i])) return false;
  }
  return !points_.empty() && fits(start_, points_.front()) && fits(goal_, points_.back());
}

// Straightens the points that were found between the two ends.
Path PathPlanner::straight_path(const TravelCost& costs, bool any_angle) {
  const GridFrame& frame = costs.frame();
  if (!start_.tight) points_.insert(points_.begin(), start_.point);
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
