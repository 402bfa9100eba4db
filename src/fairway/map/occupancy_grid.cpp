// SPDX-License-Identifier: Apache-2.0
#include "fairway/map/occupancy_grid.hpp"

#include <cmath>
#include <stdexcept>

#include "fairway/base/contract.hpp"

namespace fairway {

namespace {

GridFrame checked(const GridFrame& frame) {
  const auto side_ok = [](int n) { return n >= 1 && n <= OccupancyGrid::kMaxSide; };
  if (!side_ok(frame.width) || !side_ok(frame.height)) {
    throw std::invalid_argument("OccupancyGrid: expected sides of 1 to 32768 cells");
  }
  if (!std::isfinite(frame.resolution) || frame.resolution <= 0.0) {
    throw std::invalid_argument("OccupancyGrid: expected a positive resolution");
  }
  if (!is_finite(frame.origin))
    throw std::invalid_argument("OccupancyGrid: expected a finite origin");
  return frame;
}

}  // namespace

OccupancyGrid::OccupancyGrid(const GridFrame& frame, CellState fill)
    : frame_(checked(frame)),
      cells_(static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height), fill) {
}

void OccupancyGrid::set(CellIndex cell, CellState state) noexcept {
  FAIRWAY_EXPECTS(frame_.contains(cell));
  cells_[index(cell)] = state;
}

}  // namespace fairway
