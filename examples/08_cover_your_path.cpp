// SPDX-License-Identifier: Apache-2.0
// Corridors alone: rectangles along a path of your own, kept up to date when the map changes.
#include <cstdio>

#include "fairway/fairway.hpp"

int main() {
  fairway::OccupancyGrid grid({.width = 240, .height = 160, .resolution = 0.05, .origin = {}});
  for (int y = 0; y < 80; ++y)
    grid.set({120, y}, fairway::CellState::Occupied);
  fairway::BitGrid obstacles(grid);

  const fairway::Path path{.waypoints = {{1, 1}, {4, 5}, {8, 5}, {11, 1}}};
  const double robot_radius = 0.3;  // [m]
  fairway::CorridorBuilder builder;
  const fairway::CorridorResult* result =
      &builder.build(obstacles, path, robot_radius, fairway::CorridorSettings{});
  std::printf("%s: %zu rectangles\n", to_text(result->status), result->corridor.rectangles.size());
  for (const fairway::OrientedRectangle& r : result->corridor.rectangles)
    std::printf("  seed (%.2f, %.2f), turned by %.2f rad, %.1f m^2\n", r.seed.x(), r.seed.y(),
                r.orientation, r.area());

  // A pallet appears beside the path; only the cells of this block may have changed.
  const fairway::CellWindow changed{.first = {100, 112}, .last = {108, 120}};
  for (int y = changed.first.y; y <= changed.last.y; ++y) {
    for (int x = changed.first.x; x <= changed.last.x; ++x)
      grid.set({x, y}, fairway::CellState::Occupied);
  }
  obstacles = fairway::BitGrid(grid);
  result = &builder.update(obstacles, changed);
  std::printf("%s after the change: %zu rectangles\n", to_text(result->status),
              result->corridor.rectangles.size());
  return result->status == fairway::CorridorStatus::Built ? 0 : 1;
}
