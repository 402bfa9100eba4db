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

  PreparedMap() = default;  ///< everything blocked
  explicit PreparedMap(BitGrid bits) : obstacles(std::move(bits)), distances(obstacles) {}
  explicit PreparedMap(const OccupancyGrid& grid, UnknownCells unknown = UnknownCells::Occupied)
      : PreparedMap(BitGrid(grid, unknown)) {}

  /// Becomes the map of `bits`, which differ from its own obstacles only inside `changed`, or lie
  /// elsewhere: then all of it is prepared again. Reuses its memory.
  void update(const BitGrid& bits, const CellWindow& changed);
};

/// The smallest window that holds both; an empty one holds nothing.
[[nodiscard]] CellWindow united(const CellWindow& a, const CellWindow& b) noexcept;

/// The window without cells.
inline constexpr CellWindow kNoCells{.first = {.x = 0, .y = 0}, .last = {.x = -1, .y = -1}};

/// The window of all cells of a grid.
[[nodiscard]] inline CellWindow all_cells(const GridFrame& frame) noexcept {
  return {.first = {.x = 0, .y = 0}, .last = {.x = frame.width - 1, .y = frame.height - 1}};
}

[[nodiscard]] inline bool is_empty(const CellWindow& window) noexcept {
  return window.first.x > window.last.x || window.first.y > window.last.y;
}

}  // namespace fairway
