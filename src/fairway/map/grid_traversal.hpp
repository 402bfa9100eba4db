// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdlib>
#include <limits>

#include "fairway/map/grid_frame.hpp"

namespace fairway {

/// Visits every cell that the segment from `from` to `to` crosses, in that order, both ends
/// included.
///
/// The traversal is exact; nothing is sampled. Where the segment passes exactly through a corner,
/// one of the two cells beside it is visited too.
///
/// @param from, to  Grid coordinates [cells], each below 1e9 in size.
/// @param visit  Called as visit(cell, share), where `share` in [0, 1] is the part of the segment
///               before the cell; returns whether to continue.
template <typename Visit>
void walk_cells(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Visit&& visit) {
  CellIndex cell{.x = static_cast<int>(std::floor(from.x())),
                 .y = static_cast<int>(std::floor(from.y()))};
  const Eigen::Vector2d segment = to - from;
  const double infinity = std::numeric_limits<double>::infinity();
  const int step_x = segment.x() < 0.0 ? -1 : 1;
  const int step_y = segment.y() < 0.0 ? -1 : 1;
  int left_x = std::abs(static_cast<int>(std::floor(to.x())) - cell.x);
  int left_y = std::abs(static_cast<int>(std::floor(to.y())) - cell.y);
  const double share_x = left_x > 0 ? 1.0 / std::abs(segment.x()) : infinity;
  const double share_y = left_y > 0 ? 1.0 / std::abs(segment.y()) : infinity;
  const auto first = [](double start, int index, int step, double share) {
    return share * (step > 0 ? index + 1 - start : start - index);
  };
  // Shares of the segment at which the next column and the next row begin. The number of steps is
  // computed beforehand, so that rounding never leads past the last cell.
  double next_x = left_x > 0 ? first(from.x(), cell.x, step_x, share_x) : infinity;
  double next_y = left_y > 0 ? first(from.y(), cell.y, step_y, share_y) : infinity;
  double share = 0.0;
  while (visit(cell, share) && left_x + left_y > 0) {
    if (next_x < next_y) {
      share = next_x;
      cell.x += step_x;
      next_x = --left_x > 0 ? next_x + share_x : infinity;
    } else {
      share = next_y;
      cell.y += step_y;
      next_y = --left_y > 0 ? next_y + share_y : infinity;
    }
  }
}

}  // namespace fairway
