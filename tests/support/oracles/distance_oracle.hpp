// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "fairway/map/bit_grid.hpp"

namespace fairway::test {

/// Distance from a cell's centre to the nearest blocked cell and to the outside [m], by testing
/// every cell.
inline double distance_to_blocked(const BitGrid& obstacles, CellIndex cell) {
  const GridFrame& frame = obstacles.frame();
  double best =
      0.5 + std::min({cell.x, cell.y, frame.width - 1 - cell.x, frame.height - 1 - cell.y});
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      if (!obstacles.blocked({x, y})) continue;
      const double dx = std::max(0.0, std::abs(x - cell.x) - 0.5);
      const double dy = std::max(0.0, std::abs(y - cell.y) - 0.5);
      best = std::min(best, std::hypot(dx, dy));
    }
  }
  return best * frame.resolution;
}

}  // namespace fairway::test
