// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "fairway/map/bit_grid.hpp"

namespace fairway {

/// For every cell the exact Euclidean distance from its centre to the nearest blocked cell, as a
/// closed square, and to the outside of the grid. 0 in blocked cells.
class DistanceField {
 public:
  DistanceField() = default;  ///< no cells
  explicit DistanceField(const BitGrid& obstacles);

  /// Recomputes for new obstacles; reuses its memory when the size is unchanged.
  void update(const BitGrid& obstacles);

  [[nodiscard]] const GridFrame& frame() const noexcept { return frame_; }

  /// Distance at a cell's centre [m]; 0 outside the grid.
  [[nodiscard]] double at(CellIndex cell) const noexcept {
    return frame_.contains(cell)
               ? static_cast<double>(cells_[static_cast<std::size_t>(cell.y) *
                                                static_cast<std::size_t>(frame_.width) +
                                            static_cast<std::size_t>(cell.x)])
               : 0.0;
  }

  /// All distances [m], row by row from the lowest.
  [[nodiscard]] std::span<const float> cells() const noexcept { return cells_; }

 private:
  GridFrame frame_;
  std::vector<float> cells_;
};

/// The cells whose centre is at most `radius` [m] from a blocked cell, and the blocked cells: where
/// the centre of a disc robot cannot be.
[[nodiscard]] BitGrid inflate(const DistanceField& distances, double radius);

}  // namespace fairway
