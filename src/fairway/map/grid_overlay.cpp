// SPDX-License-Identifier: Apache-2.0
#include "fairway/map/grid_overlay.hpp"

#include <algorithm>
#include <cmath>

namespace fairway {

namespace {

// Returns the number of pieces per side into which a cell of `from` is divided. No piece is larger
// than a cell of `onto`.
int pieces_per_side(const BitGrid& from, const BitGrid& onto) noexcept {
  // Relative difference below which two resolutions count as equal.
  constexpr double kSameSize = 1e-6;
  constexpr double kMost = 1000.0;
  const double ratio = from.frame().resolution / onto.frame().resolution;
  return static_cast<int>(std::clamp(std::ceil(ratio - kSameSize), 1.0, kMost));
}

void add_cell(const GridFrame& from, CellIndex cell, int pieces, BitGrid& onto) noexcept {
  for (int j = 0; j < pieces; ++j) {
    for (int i = 0; i < pieces; ++i) {
      const Eigen::Vector2d center =
          from.to_world({cell.x + (i + 0.5) / pieces, cell.y + (j + 0.5) / pieces});
      const CellIndex at = onto.frame().cell_at(center);
      if (onto.frame().contains(at)) onto.set(at, true);
    }
  }
}

}  // namespace

void add_obstacles(const BitGrid& from, BitGrid& onto) noexcept {
  const GridFrame& frame = from.frame();
  const int pieces = pieces_per_side(from, onto);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = from.first_blocked(y, 0, frame.width - 1); x >= 0;
         x = from.first_blocked(y, x + 1, frame.width - 1)) {
      add_cell(frame, {.x = x, .y = y}, pieces, onto);
    }
  }
}

}  // namespace fairway
