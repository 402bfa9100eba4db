// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fairway/map/grid_frame.hpp"

namespace fairway {

/// What is known about a cell.
enum class CellState : std::uint8_t { Free, Occupied, Unknown };

/// The static world: one state per cell.
///
/// Cells outside the grid count as occupied. BitGrid decides how unknown cells count.
class OccupancyGrid {
 public:
  /// @throws std::invalid_argument unless width and height are 1 to kMaxSide, the resolution is
  ///         finite and positive, and the origin is finite.
  explicit OccupancyGrid(const GridFrame& frame, CellState fill = CellState::Free);

  [[nodiscard]] const GridFrame& frame() const noexcept { return frame_; }

  /// Returns the state of a cell; Occupied outside the grid.
  [[nodiscard]] CellState at(CellIndex cell) const noexcept {
    return frame_.contains(cell) ? cells_[index(cell)] : CellState::Occupied;
  }

  /// Changes the state of a cell. @pre the cell lies in the grid.
  void set(CellIndex cell, CellState state) noexcept;

  /// All cells, row by row from the lowest, `frame().width` per row.
  [[nodiscard]] std::span<const CellState> cells() const noexcept { return cells_; }

  /// Longest side of a grid [cells]; it keeps every coordinate and product far from overflow.
  static constexpr int kMaxSide = 32768;

 private:
  [[nodiscard]] std::size_t index(CellIndex cell) const noexcept {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(frame_.width) +
           static_cast<std::size_t>(cell.x);
  }

  GridFrame frame_;
  std::vector<CellState> cells_;
};

}  // namespace fairway
