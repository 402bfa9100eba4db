// SPDX-License-Identifier: Apache-2.0
// Finds a path for a disc robot around a wall, and asks for one that does not exist.
#include <cstdio>

#include "fairway/planning/planner.hpp"

int main() {
  fairway::OccupancyGrid grid({.width = 120, .height = 80, .resolution = 0.1, .origin = {}});
  for (int y = 0; y < 60; ++y)
    grid.set({60, y}, fairway::CellState::Occupied);

  const fairway::PreparedMap map(grid);
  fairway::PathPlanner planner;
  const auto found = planner.find(map.obstacles, map.distances, {1, 1}, {11, 1}, 0.3, {});
  std::printf("%s: %zu waypoints, %.2f m\n", to_text(found.status), found.path.waypoints.size(),
              found.path.length());

  const auto none = planner.find(map.obstacles, map.distances, {1, 1}, {6.05, 3}, 0.3, {});
  std::printf("into the wall: %s\n", to_text(none.status));
  return found.status == fairway::PathStatus::Found ? 0 : 1;
}
