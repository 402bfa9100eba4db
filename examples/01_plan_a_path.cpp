// SPDX-License-Identifier: Apache-2.0
// Finds a path for a disc robot around a wall, and requests one that does not exist.
#include <cstdio>

#include "fairway/fairway.hpp"

int main() {
  fairway::OccupancyGrid grid({.width = 120, .height = 80, .resolution = 0.1, .origin = {}});
  for (int y = 0; y < 60; ++y)
    grid.set({60, y}, fairway::CellState::Occupied);

  const fairway::PreparedMap map(grid);
  const fairway::PlannerSettings settings{.radius = 0.3};
  fairway::Planner planner;
  const auto found = planner.plan(map, {1, 1}, {.position = {11, 1}}, settings);
  std::printf("%s: %zu waypoints, %.2f m\n", to_text(found.path_status),
              found.path.waypoints.size(), found.path.length());

  const auto none = planner.plan(map, {1, 1}, {.position = {6.05, 3}}, settings);
  std::printf("into the wall: %s\n", to_text(none.path_status));
  return found.usable() && !none.usable() ? 0 : 1;
}
