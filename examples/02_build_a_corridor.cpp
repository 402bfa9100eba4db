// SPDX-License-Identifier: Apache-2.0
// Covers a path with rectangles by two methods: the paper's, and the fewest.
#include <cstdio>

#include "fairway/corridor/corridor_builder.hpp"
#include "fairway/navigation/settings.hpp"
#include "fairway/planning/planner.hpp"

int main() {
  fairway::OccupancyGrid grid({.width = 400, .height = 300, .resolution = 0.05, .origin = {}});
  for (int i = 0; i < 150; ++i)
    grid.set({100 + i, 40 + i}, fairway::CellState::Occupied);

  const fairway::PreparedMap map(grid);
  fairway::Settings settings;
  for (const auto method : {fairway::CorridorMethod::Mdsrc, fairway::CorridorMethod::Fewest}) {
    settings.corridor.method = method;
    const fairway::Plan plan = fairway::Planner().plan(
        map, {2, 4}, {.position = {16, 3}, .heading = {}}, fairway::planner_settings(settings));
    if (!plan.usable()) {
      std::printf("no corridor: %s\n", plan.reason());
      return 1;
    }
    std::printf("%s: %zu rectangles, %.1f m^2 on average\n",
                method == fairway::CorridorMethod::Mdsrc ? "mdsrc " : "fewest",
                plan.corridor.rectangles.size(), plan.corridor.mean_area());
  }
  return 0;
}
