// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace fairway {

/// The second pass of the distance transform for one row, by trial of all columns that can matter.
///
/// Cells are processed in parts of 64 and many at once; the columns around a part are tried from
/// the nearest outwards until none can be nearer than what is found. Squared distances are in (half
/// cells)^2 and have 16 bits, so the search ends kMostColumns columns away.
class DistanceRow {
 public:
  static constexpr int kPart = 64;         ///< cells that are processed together
  static constexpr int kMostColumns = 61;  ///< furthest column that is tried

  /// Loads the steps along each column to its nearest obstacle, as far as cells `first` to `last`
  /// need them; steps above `most` count as `most`. Outside the row everything is blocked.
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

}  // namespace fairway
