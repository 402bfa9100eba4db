// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "fairway/map/grid_frame.hpp"

namespace fairway::test {

/// The fractions of the segment (grid coordinates) at which it enters and leaves a closed cell;
/// none if it misses the cell. Tests slabs, one cell at a time.
struct CellCrossing {
  double enter;
  double leave;
};

inline std::optional<CellCrossing> cross_cell(const Eigen::Vector2d& from,
                                              const Eigen::Vector2d& to,
                                              CellIndex cell) {
  const Eigen::Vector2d low(cell.x, cell.y);
  double enter = 0.0;
  double leave = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double way = to[axis] - from[axis];
    const double a = low[axis] - from[axis];
    const double b = low[axis] + 1.0 - from[axis];
    if (way == 0.0) {
      if (a > 0.0 || b < 0.0) return std::nullopt;
      continue;
    }
    enter = std::max(enter, std::min(a / way, b / way));
    leave = std::min(leave, std::max(a / way, b / way));
  }
  if (enter > leave) return std::nullopt;
  return CellCrossing{.enter = enter, .leave = leave};
}

}  // namespace fairway::test
