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

/// Returns the smallest window that contains both; an empty window contains nothing.
[[nodiscard]] CellWindow united(const CellWindow& a, const CellWindow& b) noexcept;

/// The empty window.
inline constexpr CellWindow kNoCells{.first = {.x = 0, .y = 0}, .last = {.x = -1, .y = -1}};

/// Returns the window of all cells of a grid.
[[nodiscard]] inline CellWindow all_cells(const GridFrame& frame) noexcept {
  return {.first = {.x = 0, .y = 0}, .last = {.x = frame.width - 1, .y = frame.height - 1}};
}

/// Returns whether a window has no cells.
[[nodiscard]] inline bool is_empty(const CellWindow& window) noexcept {
  return window.first.x > window.last.x || window.first.y > window.last.y;
}

}  // namespace fairway
