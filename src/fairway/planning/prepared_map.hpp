// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "fairway/map/bit_grid.hpp"
#include "fairway/map/distance_field.hpp"

namespace fairway {

/// A static map in the forms that planning reads.
struct PreparedMap {
  BitGrid obstacles;
  DistanceField distances;

  PreparedMap() = default;  ///< makes a map in which everything is blocked
  explicit PreparedMap(BitGrid bits) : obstacles(std::move(bits)), distances(obstacles) {}
  explicit PreparedMap(const OccupancyGrid& grid, UnknownCells unknown = UnknownCells::Occupied)
      : PreparedMap(BitGrid(grid, unknown)) {}

  /// Updates the map to `bits`, and reuses its memory. If `bits` has the same frame, it must differ
  /// from the obstacles only inside `changed`; otherwise the whole map is prepared again.
  void update(const BitGrid& bits, const CellWindow& changed);
};

}  // namespace fairway
