// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/path_obstruction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "fairway/map/free_space.hpp"
#include "fairway/path/search_grid.hpp"
#include "fairway/planning/obstruction_text.hpp"
#include "fairway/planning/zone_obstruction.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

// Searches the route over cells whose least clearance is the greatest. Cells with sufficient
// clearance count as equal, so that the first route over them is taken.
class WidestRoute {
 public:
  WidestRoute(const DistanceField& distances, double enough)
      : distances_(distances),
        width_(distances.frame().width),
        height_(distances.frame().height),
        scale_((kLevels - 1) / enough),
        parents_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), kUnseen) {}

  // Returns the cells from `start` to `goal`, at least one. @pre both lie in the grid.
  std::vector<CellIndex> find(CellIndex start, CellIndex goal) {
    parents_[index(start)] = kStart;
    push(start);
    while (top_ >= 0) {
      std::vector<CellIndex>& queue = queues_[static_cast<std::size_t>(top_)];
      std::size_t& next = next_[static_cast<std::size_t>(top_)];
      if (next == queue.size()) {
        queue.clear();
        next = 0;
        --top_;
        continue;
      }
      const CellIndex cell = queue[next++];
      if (cell == goal) return trace(goal);
      for (std::uint8_t direction = 0; direction < 8; ++direction)
        visit(cell, direction);
    }
    return {};
  }

 private:
  static constexpr int kLevels = 512;  // of clearance; level 0: blocked cells
  static constexpr std::uint8_t kUnseen = 255;
  static constexpr std::uint8_t kStart = 254;

  [[nodiscard]] std::size_t index(CellIndex cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(cell.x);
  }

  void visit(CellIndex from, std::uint8_t direction) {
    const CellIndex cell{.x = from.x + kStepX.at(direction), .y = from.y + kStepY.at(direction)};
    if (cell.x < 0 || cell.y < 0 || cell.x >= width_ || cell.y >= height_) return;
    if (parents_[index(cell)] != kUnseen) return;
    // A diagonal step between two blocked cells, or past one, is narrower than at its ends.
    const bool diagonal = direction % 2 == 1;
    if (diagonal && (distances_.at({.x = from.x, .y = cell.y}) <= 0.0 ||
                     distances_.at({.x = cell.x, .y = from.y}) <= 0.0)) {
      return;
    }
    parents_[index(cell)] = direction;
    push(cell);
  }

  void push(CellIndex cell) {
    const double clearance = distances_.at(cell);
    const int level =
        clearance > 0.0 ? std::clamp(static_cast<int>(clearance * scale_), 1, kLevels - 1) : 0;
    queues_[static_cast<std::size_t>(level)].push_back(cell);
    top_ = std::max(top_, level);
  }

  [[nodiscard]] std::vector<CellIndex> trace(CellIndex goal) const {
    std::vector<CellIndex> route{goal};
    for (std::uint8_t direction = parents_[index(goal)]; direction != kStart;
         direction = parents_[index(route.back())]) {
      const CellIndex cell = route.back();
      route.push_back({.x = cell.x - kStepX.at(direction), .y = cell.y - kStepY.at(direction)});
    }
    std::reverse(route.begin(), route.end());
    return route;
  }

  const DistanceField& distances_;
  int width_;
  int height_;
  double scale_;
  std::vector<std::uint8_t> parents_;  // direction of the step into each cell
  std::array<std::vector<CellIndex>, kLevels> queues_;
  std::array<std::size_t, kLevels> next_{};
  int top_ = -1;
};

// Returns the point near `point` with the greatest clearance across a gap, along the line to the
// nearest obstacle. The centre of a cell is up to half a cell beside the middle of the gap.
Vector2d middle_of_gap(const BitGrid& obstacles, const Vector2d& point) {
  const double cell = obstacles.frame().resolution;
  const double limit = distance_to_blocked(obstacles, point, 100.0) + 2.0 * cell;
  const auto clearance = [&](const Vector2d& p) {
    return distance_to_blocked(obstacles, p, limit);
  };
  constexpr int kDirections = 64;
  Vector2d across = Vector2d::UnitX();
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kDirections;
    const Vector2d direction(std::cos(angle), std::sin(angle));
    const double there = clearance(point + 0.25 * cell * direction);
    if (there < least) {
      least = there;
      across = direction;
    }
  }
  constexpr int kSteps = 40;  // from one cell before to one cell behind
  Vector2d best = point;
  for (int i = -kSteps; i <= kSteps; ++i) {
    const Vector2d candidate = point + (cell * i / kSteps) * across;
    if (clearance(candidate) > clearance(best)) best = candidate;
  }
  return best;
}

PathObstruction narrowest(const PreparedMap& map,
                          const std::vector<CellIndex>& route,
                          double needed) {
  const GridFrame& frame = map.obstacles.frame();
  // The ends were tested exactly; the centres of their cells are less exact.
  const bool has_inside = route.size() > 2;
  const auto tightest = std::min_element(
      route.begin() + has_inside, route.end() - has_inside,
      [&](CellIndex a, CellIndex b) { return map.distances.at(a) < map.distances.at(b); });
  if (map.distances.at(*tightest) <= 0.0) {
    return {.kind = PathObstruction::Kind::ClosedRoute,
            .position = frame.center(*tightest),
            .found = 0.0,
            .needed = needed};
  }
  const Vector2d middle = middle_of_gap(map.obstacles, frame.center(*tightest));
  return {.kind = PathObstruction::Kind::NarrowGap,
          .position = middle,
          .found = 2.0 * distance_to_blocked(map.obstacles, middle, needed),
          .needed = needed};
}

std::string outside(const char* what, const Vector2d& point, const GridFrame& frame) {
  return joined_text({"the ", what, " ", place_text(point), " is outside the map, which is ",
                      fixed_text(frame.width * frame.resolution, 2), " m x ",
                      fixed_text(frame.height * frame.resolution, 2), " m from ",
                      place_text(frame.origin.position)});
}

std::string too_near(const char* end, const PathObstruction& o) {
  return joined_text({"the robot does not fit at the ", end, " ", place_text(o.position),
                      ": it is ", length_text(o.found), " from an obstacle and the robot needs ",
                      length_text(o.needed), " (robot.radius)"});
}

// Returns the point at an arc length of the path [m]; its end beyond the length.
Vector2d place_along(const Path& path, double length) {
  for (std::size_t i = 1; i < path.waypoints.size(); ++i) {
    const Vector2d line = path.waypoints[i] - path.waypoints[i - 1];
    const double along = line_length(line);
    if (length < along) return path.waypoints[i - 1] + length / along * line;
    length -= along;
  }
  return path.waypoints.empty() ? Vector2d(Vector2d::Zero()) : path.waypoints.back();
}

std::string sentence(const PathObstruction& o) {
  switch (o.kind) {
    case PathObstruction::Kind::StartClearance:
      return too_near("start", o);
    case PathObstruction::Kind::GoalClearance:
      return too_near("goal", o);
    case PathObstruction::Kind::NarrowGap:
      return joined_text({"there is no path wide enough: the narrowest gap on the best route, at ",
                          place_text(o.position), ", is ", length_text(o.found),
                          " wide and the robot needs ", length_text(o.needed),
                          " (twice robot.radius plus the least path.margin)"});
    case PathObstruction::Kind::ClosedRoute:
      return joined_text(
          {"there is no path: obstacles or unknown cells close every route; the best one "
           "is closed at ",
           place_text(o.position)});
  }
  return {};
}

}  // namespace

std::optional<PathObstruction> find_obstruction(const PreparedMap& map,
                                                const Vector2d& start,
                                                const Plan& plan,
                                                double radius) {
  const Vector2d& goal = plan.goal.position;
  const auto clearance = [&](const Vector2d& point) {
    return distance_to_blocked(map.obstacles, point, radius + 1.0);
  };
  switch (plan.path_status) {
    case PathStatus::StartBlocked:
      return PathObstruction{.kind = PathObstruction::Kind::StartClearance,
                             .position = start,
                             .found = clearance(start),
                             .needed = radius};
    case PathStatus::GoalBlocked:
      return PathObstruction{.kind = PathObstruction::Kind::GoalClearance,
                             .position = goal,
                             .found = clearance(goal),
                             .needed = radius};
    case PathStatus::NoConnection:
      break;
    case PathStatus::Found:
    case PathStatus::StartOutsideMap:
    case PathStatus::GoalOutsideMap:
    case PathStatus::InvalidInput:
      return std::nullopt;
  }
  const GridFrame& frame = map.obstacles.frame();
  const double needed = radius + plan.margin;
  WidestRoute search(map.distances, std::max(needed, frame.resolution));
  const std::vector<CellIndex> route = search.find(frame.cell_at(start), frame.cell_at(goal));
  return narrowest(map, route, 2.0 * needed);
}

std::string explain(const PreparedMap& map,
                    const Vector2d& start,
                    const Plan& plan,
                    double radius) {
  if (plan.usable()) return {};
  if (plan.path_status == PathStatus::StartOutsideMap && is_finite(start))
    return outside("start", start, map.obstacles.frame());
  if (plan.path_status == PathStatus::GoalOutsideMap && is_finite(plan.goal.position))
    return outside("goal", plan.goal.position, map.obstacles.frame());
  if (plan.path_status == PathStatus::Found) {
    const Vector2d place = place_along(plan.path, plan.stuck_at);
    constexpr double kFurthest = 10.0;  // [m]
    return joined_text({to_text(plan.corridor_status), ", after ", length_text(plan.stuck_at),
                        " of the path, at ", place_text(place), ", ",
                        length_text(distance_to_blocked(map.obstacles, place, kFurthest)),
                        " from the nearest obstacle; try smaller values of "
                        "corridor.min_overlap_area or robot.radius"});
  }
  if (std::optional<std::string> zones = explain_zones(map, start, plan, radius))
    return *std::move(zones);
  const std::optional<PathObstruction> obstruction = find_obstruction(map, start, plan, radius);
  return obstruction ? sentence(*obstruction) : plan.reason();
}

}  // namespace fairway
