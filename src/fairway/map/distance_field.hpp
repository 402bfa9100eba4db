// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "fairway/map/bit_grid.hpp"

namespace fairway {

/// The two passes of the distance transform for one row, many cells at once.
///
/// The second pass tries all columns that can matter.
/// Cells are processed in parts of 64, many at once. The columns around a part are tried from the
/// nearest outwards, until none can be nearer than the best so far. Squared distances are in (half
/// cells)^2 and have 16 bits, so the search ends kMostColumns columns away.
class DistanceRow {
 public:
  static constexpr int kPart = 64;         ///< cells that are processed together
  static constexpr int kMostColumns = 61;  ///< furthest column that is tried

  /// Advances the first pass by one row: steps along each column to the last blocked cell. They are
  /// 0 in blocked cells, one more than in row `previous` in others, and at most `most`; with
  /// `bounded` also at most the present ones. 64 columns belong to each word of blocked cells.
  static void step(std::span<const std::uint64_t> words,
                   const std::uint16_t* previous,
                   std::uint16_t most,
                   bool bounded,
                   std::uint16_t* steps) noexcept;

  /// Sets the lanes in `changes` of the columns that are blocked and had steps, or the reverse.
  /// Returns whether there is one.
  static bool mark_changes(std::span<const std::uint64_t> words,
                           const std::uint16_t* steps,
                           std::uint16_t* changes) noexcept;

  /// Loads the steps along each column to its nearest obstacle. Cells `first` to `last` determine
  /// how far; steps above `most` count as `most`. Outside the row everything is blocked.
  /// @pre 1 <= most <= kMostColumns
  void load(const std::uint16_t* steps, int width, int most, int first, int last);

  /// Computes the squares of the cells of part `part`: 64 numbers. Squares from `far_square()` on
  /// are not known. Where no column around has a square below `hopeless`, none is known.
  /// @return Whether every square is known.
  bool find_squares(int part, std::int16_t hopeless, std::int16_t* squares) const;

  /// The square of a distance of `most` steps.
  [[nodiscard]] std::int16_t far_square() const noexcept { return far_; }

 private:
  int width_ = 0;
  int most_ = 1;
  std::int16_t far_ = 1;
  std::vector<std::int16_t> squares_;  // of the columns, with a part of zeros on both sides
  std::vector<std::int16_t> least_;    // least square of each part of squares_
};

/// The exact distance from the centre of every cell to the nearest obstacle.
///
/// Obstacles are the blocked cells, as closed squares, and the outside of the grid. The distance is
/// 0 in blocked cells. It is rounded to float, an error of at most 1.5e-7 of the distance.
class DistanceField {
 public:
  DistanceField() = default;  ///< makes a field without cells
  explicit DistanceField(const BitGrid& obstacles);

  /// Limits distances to `reach` [m]: greater ones are stored as `reach`. A finite reach makes both
  /// kinds of update cheaper in open spaces. It takes effect with the next full update; the default
  /// is infinite.
  /// @pre reach > 0, and either infinite or at most kMostReach cells.
  void set_reach(double reach) noexcept { reach_ = reach; }
  [[nodiscard]] double reach() const noexcept { return reach_; }
  static constexpr int kMostReach = DistanceRow::kMostColumns - 1;

  /// Recomputes the field for new obstacles in O(cells); reuses its memory if the size is
  /// unchanged.
  void update(const BitGrid& obstacles);

  /// Recomputes the field after a change of obstacles inside `changed` only.
  ///
  /// The result equals that of a full update to the bit. The window is clipped to the grid. Only
  /// rows up to the next obstacle above and below the window are looked at, and in them only the
  /// cells whose nearest obstacle the change can concern. Does not allocate after the first window
  /// of this size.
  /// @pre the obstacles have the same frame as at the last update, and differ from those only
  ///       inside the window.
  void update(const BitGrid& obstacles, const CellWindow& changed);

  /// Reduces the distance of one cell, until the next update that covers it.
  /// @pre `index` counts the cells row by row.
  void reduce(std::size_t index, float distance) noexcept {
    cells_[index] = std::min(cells_[index], distance);
  }

  [[nodiscard]] const GridFrame& frame() const noexcept { return frame_; }

  /// Distance at the centre of a cell [m]; 0 outside the grid.
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
  [[nodiscard]] CellWindow changed_part(const BitGrid& obstacles, const CellWindow& window);
  void update_around(int y, int first, int last, int lowest);
  void update_row(int y, int first, int last);
  void update_run(const std::uint16_t* steps, int first, int end, float* distances);
  // Steps above this are not counted; rows that differ only beyond it then compare as equal.
  [[nodiscard]] std::uint16_t most_steps() const noexcept {
    return near_ > 0 ? static_cast<std::uint16_t>(near_)
                     : std::numeric_limits<std::uint16_t>::max();
  }
  [[nodiscard]] std::uint16_t* steps_of(int y) noexcept {
    return column_steps_.data() + (static_cast<std::size_t>(y) + 1) * stride_;
  }

  // A parabola on the lower envelope of a run of free cells: the squared distance through one
  // column edge. From cell `start` on it is the lowest of all.
  struct Parabola {
    int edge;
    int start;
    std::int64_t height;  // squared distance at the edge itself, in (half cells)^2
  };

  GridFrame frame_;
  double reach_ = std::numeric_limits<double>::infinity();  // [m]
  int near_ = 0;  // reach_ in cells, rounded up; 0 for an infinite reach
  std::vector<float> cells_;
  // Steps along the column to the nearest blocked cell or the outside. Rows are padded to whole
  // words; the first and the last row are outside the grid.
  std::size_t stride_ = 0;
  std::vector<std::uint16_t> column_steps_;
  std::vector<std::uint16_t> window_steps_;
  std::vector<Parabola> envelope_;
  std::vector<std::uint8_t> starts_;  // of one row: 1 where the next parabola becomes the lowest
  std::vector<float> squares_;        // of one row, [(half cells)^2]
  std::vector<double> eighths_;       // 1 / (8 n)
  DistanceRow row_;
};

}  // namespace fairway
