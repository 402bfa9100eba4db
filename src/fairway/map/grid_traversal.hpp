// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdlib>
#include <limits>

#include "fairway/map/grid_frame.hpp"

namespace fairway {

/// Visits every cell that the segment from `from` to `to` crosses, in that order, the cells of both
/// ends included; exact, nothing is sampled. Where the segment passes exactly through a corner, one
/// of the two side cells is visited too.
///
/// @param from, to  Grid coordinates [cells], each below 1e9 in size.
/// @param visit  Called as visit(cell, share): `share` in [0, 1] is the part of the segment before
///               the cell; returns whether to go on.
template <typename Visit>
void walk_cells(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Visit&& visit) {
  CellIndex cell{.x = static_cast<int>(std::floor(from.x())),
                 .y = static_cast<int>(std::floor(from.y()))};
  const Eigen::Vector2d way = to - from;
  const double infinity = std::numeric_limits<double>::infinity();
  const int step_x = way.x() < 0.0 ? -1 : 1;
  const int step_y = way.y() < 0.0 ? -1 : 1;
  int left_x = std::abs(static_cast<int>(std::floor(to.x())) - cell.x);
  int left_y = std::abs(static_cast<int>(std::floor(to.y())) - cell.y);
  const double share_x = left_x > 0 ? 1.0 / std::abs(way.x()) : infinity;
  const double share_y = left_y > 0 ? 1.0 / std::abs(way.y()) : infinity;
  const auto first = [](double start, int index, int step, double share) {
    return share * (step > 0 ? index + 1 - start : start - index);
  };
  // Share of the way at which the next column and the next row begin. The count of steps is known
  // beforehand, so that rounding can never lead past the last cell.
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
