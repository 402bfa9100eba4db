// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "fairway/map/bit_grid.hpp"

namespace fairway {

/// A block of cells, both corners included; empty when `first` exceeds `last` in either coordinate.
struct CellWindow {
  CellIndex first;
  CellIndex last;
};

/// Grows `window` to hold `cell` too. An empty window must have its `first` at or beyond, and its
/// `last` at or before, every cell that it may get.
inline void include(CellWindow& window, CellIndex cell) noexcept {
  window.first = {.x = std::min(window.first.x, cell.x), .y = std::min(window.first.y, cell.y)};
  window.last = {.x = std::max(window.last.x, cell.x), .y = std::max(window.last.y, cell.y)};
}

/// For every cell the exact Euclidean distance from its centre to the nearest blocked cell, as a
/// closed square, and to the outside of the grid. 0 in blocked cells.
///
/// "Exact" up to the rounding to float: at most 1.5e-7 of the distance.
class DistanceField {
 public:
  DistanceField() = default;  ///< no cells
  explicit DistanceField(const BitGrid& obstacles);

  /// Distances above `reach` [m] are of no interest, and given as `reach`: both kinds of update
  /// become several times cheaper. From the next full update on; infinite, as at first, for all.
  /// @pre above 0, and infinite or at most kMostReach cells.
  void set_reach(double reach) noexcept { reach_ = reach; }
  static constexpr int kMostReach = 60;

  /// Recomputes for new obstacles; reuses its memory when the size is unchanged. O(cells).
  void update(const BitGrid& obstacles);

  /// Recomputes after a change of obstacles inside `changed` only; gives the same bits as a full
  /// update, and does not allocate after the first window of this size. A window over the edge of
  /// the grid is cut. O(height * window width + cells of the rows where something changed).
  /// @pre the obstacles have the same frame as at the last update and differ from those only
  ///      inside the window.
  void update(const BitGrid& obstacles, const CellWindow& changed);

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
  void update_row(int y, int first, int last);
  void update_run(const std::uint16_t* steps, int first, int end, float* distances);
  void update_near(int y, int first, int last);

  // A parabola on the lower envelope of a run of free cells: the squared distance through one edge
  // between two columns, best of all edges from cell `start` on.
  struct Parabola {
    int edge;
    int start;
    std::int64_t height;  // squared distance at the edge itself, in (half cells)^2
  };

  GridFrame frame_;
  double reach_ = std::numeric_limits<double>::infinity();  // [m]
  int near_ = 0;  // the same in whole cells, not below it; 0: all
  std::vector<float> cells_;
  // Steps along the column to the nearest blocked cell or the outside. Rows are padded to whole
  // words; the first and the last are the outside.
  std::size_t stride_ = 0;
  std::vector<std::uint16_t> column_steps_;
  std::vector<std::uint16_t> window_steps_;
  std::vector<Parabola> envelope_;
  std::vector<std::uint8_t> starts_;        // of one row: 1 where the next parabola takes over
  std::vector<float> squares_;              // of one row, [(half cells)^2]
  std::vector<double> eighths_;             // 1 / (8 n)
  std::vector<std::int16_t> near_squares_;  // of one row with its surroundings, [(half cells)^2]
};

/// The cells whose centre is at most `radius` [m] from a blocked cell, and the blocked cells: where
/// the centre of a disc robot cannot be. Errs towards "blocked" by kFreeSpaceSkin (free_space.hpp),
/// so that wherever a cell stays free a disc of that radius is free at its centre.
/// @pre radius is not negative, not NaN and below 10 m (then the skin covers the field's rounding).
[[nodiscard]] BitGrid inflate(const DistanceField& distances, double radius);

}  // namespace fairway
