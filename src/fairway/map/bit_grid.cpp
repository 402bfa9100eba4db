// SPDX-License-Identifier: Apache-2.0
#include "fairway/map/bit_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "fairway/base/contract.hpp"

namespace fairway {

namespace {

static_assert(static_cast<int>(CellState::Free) == 0 &&
              static_cast<int>(CellState::Occupied) == 1 &&
              static_cast<int>(CellState::Unknown) == 2);

// Packs up to 64 cells into a word; bit i is set if cell i is blocked. Eight cells are packed at a
// time: one multiplication gathers their low bits. Bit 8 i of the factor moves to bit 56 + i; no
// two terms share a bit, so there is no carry.
std::uint64_t packed(std::span<const CellState> cells, bool unknown_blocks) noexcept {
  std::uint64_t word = 0;
  std::size_t i = 0;
  if constexpr (std::endian::native == std::endian::little) {
    for (; i + 8 <= cells.size(); i += 8) {
      std::uint64_t eight = 0;
      std::memcpy(&eight, cells.data() + i, sizeof eight);
      if (unknown_blocks) eight |= eight >> 1U;
      word |= ((eight & 0x0101010101010101U) * 0x0102040810204080U >> 56U) << i;
    }
  }
  for (; i < cells.size(); ++i) {
    const bool blocked =
        cells[i] == CellState::Occupied || (unknown_blocks && cells[i] == CellState::Unknown);
    word |= static_cast<std::uint64_t>(blocked) << i;
  }
  return word;
}

const GridFrame& checked_frame(const GridFrame& frame) {
  const auto is_side = [](int n) { return n >= 0 && n <= OccupancyGrid::kMaxSide; };
  if (!is_side(frame.width) || !is_side(frame.height))
    throw std::invalid_argument("BitGrid: expected sides of 0 to 32768 cells");
  if (!std::isfinite(frame.resolution) || frame.resolution <= 0.0)
    throw std::invalid_argument("BitGrid: expected a positive resolution");
  if (!is_finite(frame.origin)) throw std::invalid_argument("BitGrid: expected a finite origin");
  return frame;
}

}  // namespace

BitGrid::BitGrid(const GridFrame& frame, bool blocked)
    : frame_(checked_frame(frame)),
      words_per_row_((static_cast<std::size_t>(frame.width) + 63) / 64),
      words_(words_per_row_ * static_cast<std::size_t>(frame.height), blocked ? ~0ULL : 0ULL) {
  const int used = frame.width % 64;
  for (std::size_t y = 0; blocked && used != 0 && y < static_cast<std::size_t>(frame.height); ++y)
    words_[(y + 1) * words_per_row_ - 1] = (1ULL << used) - 1;
  make_bands();
}

BitGrid::BitGrid(const OccupancyGrid& grid, UnknownCells unknown) { assign(grid, unknown); }

void BitGrid::assign(const OccupancyGrid& grid, UnknownCells unknown) {
  frame_ = grid.frame();
  words_per_row_ = (static_cast<std::size_t>(frame_.width) + 63) / 64;
  words_.resize(words_per_row_ * static_cast<std::size_t>(frame_.height));
  const bool unknown_blocks = unknown == UnknownCells::Occupied;
  const std::span<const CellState> cells = grid.cells();
  const auto width = static_cast<std::size_t>(frame_.width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(frame_.height); ++y) {
    const CellState* row_cells = cells.data() + y * width;
    for (std::size_t w = 0; w < words_per_row_; ++w) {
      const std::size_t count = std::min<std::size_t>(64, width - w * 64);
      words_[y * words_per_row_ + w] = packed({row_cells + w * 64, count}, unknown_blocks);
    }
  }
  make_bands();
}

void BitGrid::make_bands() {
  const auto height = static_cast<std::size_t>(frame_.height);
  bands_.assign((height + kBandRows - 1) / kBandRows * words_per_row_, 0);
  for (std::size_t y = 0; y < height; ++y) {
    const std::uint64_t* from = words_.data() + y * words_per_row_;
    std::uint64_t* to = bands_.data() + y / kBandRows * words_per_row_;
    for (std::size_t w = 0; w < words_per_row_; ++w)
      to[w] |= from[w];
  }
}

void BitGrid::set(CellIndex cell, bool blocked) noexcept {
  FAIRWAY_EXPECTS(frame_.contains(cell));
  const auto column = static_cast<std::size_t>(cell.x) / 64;
  const std::uint64_t bit = 1ULL << (cell.x % 64);
  std::uint64_t& word = words_[static_cast<std::size_t>(cell.y) * words_per_row_ + column];
  std::uint64_t& in_band =
      bands_[static_cast<std::size_t>(cell.y / kBandRows) * words_per_row_ + column];
  if (blocked) {
    word |= bit;
    in_band |= bit;
    return;
  }
  if ((word & bit) == 0) return;
  word &= ~bit;
  const int first = cell.y / kBandRows * kBandRows;
  const int end = std::min(first + kBandRows, frame_.height);
  std::uint64_t rows = 0;
  for (int y = first; y < end; ++y)
    rows |= words_[static_cast<std::size_t>(y) * words_per_row_ + column];
  in_band = rows;
}

void BitGrid::copy(const BitGrid& source, const CellWindow& window) noexcept {
  FAIRWAY_EXPECTS(source.frame_.width == frame_.width && source.frame_.height == frame_.height);
  FAIRWAY_EXPECTS(frame_.contains(window.first) && frame_.contains(window.last));
  const std::size_t first = word_of(window.first.x);
  const std::size_t last = word_of(window.last.x);
  for (int y = window.first.y; y <= window.last.y; ++y) {
    const std::size_t row = static_cast<std::size_t>(y) * words_per_row_;
    for (std::size_t w = first; w <= last; ++w) {
      std::uint64_t mask = ~0ULL;
      if (w == first) mask &= from(window.first.x);
      if (w == last) mask &= up_to(window.last.x);
      std::uint64_t& word = words_[row + w];
      word ^= (word ^ source.words_[row + w]) & mask;
    }
  }
  for (int b = window.first.y / kBandRows; b <= window.last.y / kBandRows; ++b) {
    for (std::size_t w = first; w <= last; ++w) {
      std::uint64_t rows = 0;
      for (int y = kBandRows * b; y < std::min(kBandRows * (b + 1), frame_.height); ++y)
        rows |= words_[static_cast<std::size_t>(y) * words_per_row_ + w];
      bands_[static_cast<std::size_t>(b) * words_per_row_ + w] = rows;
    }
  }
}

BitGrid BitGrid::part(const CellWindow& window) const {
  const CellWindow inside = clipped(window, frame_);
  if (is_empty(inside)) return {};
  GridFrame frame = frame_;
  frame.width = inside.last.x - inside.first.x + 1;
  frame.height = inside.last.y - inside.first.y + 1;
  frame.origin.position = frame_.to_world({inside.first.x + 0.0, inside.first.y + 0.0});
  BitGrid cells(frame, false);
  const std::size_t first = word_of(inside.first.x);
  const auto shift = static_cast<unsigned>(inside.first.x) % 64;
  const std::uint64_t used = up_to(frame.width - 1);
  for (int y = 0; y < frame.height; ++y) {
    const std::span<const std::uint64_t> source = row(inside.first.y + y);
    std::uint64_t* words = cells.words_.data() + static_cast<std::size_t>(y) * cells.words_per_row_;
    for (std::size_t w = 0; w < cells.words_per_row_; ++w) {
      words[w] = source[first + w] >> shift;
      if (shift != 0 && first + w + 1 < source.size())
        words[w] |= source[first + w + 1] << (64 - shift);
    }
    words[cells.words_per_row_ - 1] &= used;
  }
  cells.make_bands();
  return cells;
}

}  // namespace fairway
