// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/map/occupancy_grid.hpp"

namespace fairway::test {

inline void put_box(OccupancyGrid& map, double x0, double y0, double x1, double y1) {
  const CellIndex first = map.frame().cell_at({x0, y0});
  const CellIndex last = map.frame().cell_at({x1, y1});
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x)
      map.set({x, y}, CellState::Occupied);
  }
}

}  // namespace fairway::test
