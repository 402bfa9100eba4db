// SPDX-License-Identifier: Apache-2.0
#include "fairway/map/bit_grid.hpp"

#include <algorithm>
#include <bit>

#include "fairway/base/contract.hpp"

namespace fairway {

BitGrid::BitGrid(const GridFrame& frame, bool blocked)
    : frame_(frame),
      words_per_row_((static_cast<std::size_t>(frame.width) + 63) / 64),
      words_(words_per_row_ * static_cast<std::size_t>(frame.height), blocked ? ~0ULL : 0ULL) {
  const int used = frame.width % 64;
  if (!blocked || used == 0) return;
  for (std::size_t y = 0; y < static_cast<std::size_t>(frame.height); ++y) {
    words_[(y + 1) * words_per_row_ - 1] = (1ULL << used) - 1;
  }
}

BitGrid::BitGrid(const OccupancyGrid& grid, UnknownCells unknown) : BitGrid(grid.frame(), false) {
  const bool unknown_blocks = unknown == UnknownCells::Occupied;
  const std::span<const CellState> cells = grid.cells();
  const auto width = static_cast<std::size_t>(frame_.width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(frame_.height); ++y) {
    const CellState* row_cells = cells.data() + y * width;
    for (std::size_t w = 0; w < words_per_row_; ++w) {
      const std::size_t count = std::min<std::size_t>(64, width - w * 64);
      std::uint64_t word = 0;
      for (std::size_t i = 0; i < count; ++i) {
        const CellState state = row_cells[w * 64 + i];
        const bool bit =
            state == CellState::Occupied || (unknown_blocks && state == CellState::Unknown);
        word |= static_cast<std::uint64_t>(bit) << i;
      }
      words_[y * words_per_row_ + w] = word;
    }
  }
}

void BitGrid::set(CellIndex cell, bool blocked) noexcept {
  FAIRWAY_EXPECTS(frame_.contains(cell));
  std::uint64_t& word = words_[static_cast<std::size_t>(cell.y) * words_per_row_ +
                               static_cast<std::size_t>(cell.x) / 64];
  const std::uint64_t bit = 1ULL << (cell.x % 64);
  word = blocked ? word | bit : word & ~bit;
}

int BitGrid::first_blocked(int y, int first, int last) const noexcept {
  if (first > last) return -1;
  const std::uint64_t* words = words_.data() + static_cast<std::size_t>(y) * words_per_row_;
  const int first_word = first / 64;
  const int last_word = last / 64;
  for (int w = first_word; w <= last_word; ++w) {
    std::uint64_t word = words[w];
    if (w == first_word) word &= ~0ULL << (first % 64);
    if (w == last_word) word &= ~0ULL >> (63 - last % 64);
    if (word != 0) return w * 64 + std::countr_zero(word);
  }
  return -1;
}

}  // namespace fairway
