// SPDX-License-Identifier: Apache-2.0
// GCC warns that the calling convention for wide registers changes with AVX. They are inlined.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"
#include <algorithm>
#include <array>
#include <cstring>

#include "fairway/base/simd.hpp"
#include "fairway/map/distance_field.hpp"

namespace fairway {

namespace {

constexpr int kPart = DistanceRow::kPart;

using Squares128 [[gnu::vector_size(16)]] = std::int16_t;
using Squares256 [[gnu::vector_size(32)]] = std::int16_t;

// Tries the columns around 64 cells, of which `middle` is the first, and writes the least squares.
// Columns further than `most` are not tried. No column square around is below `least`.
template <typename Pack>
FAIRWAY_LANES void try_columns(const std::int16_t* middle,
                               int most,
                               std::int16_t least,
                               std::int16_t* squares) noexcept {
  constexpr std::size_t kWidth = sizeof(Pack) / sizeof(std::int16_t);
  constexpr std::size_t kPacks = kPart / kWidth;
  constexpr int kOften = 4;  // columns between two checks whether any cell can still improve
  std::array<Pack, kPacks> best;
  std::memcpy(best.data(), middle, sizeof best);
  for (int first = 1; first <= most; first += kOften) {
    // Whether some cell is further than the next column: the lanes of a comparison are 0 or -1.
    const auto next = static_cast<std::int16_t>(least + (2 * first - 1) * (2 * first - 1));
    Pack further = best[0] > next;
    for (std::size_t i = 1; i < kPacks; ++i)
      further |= best[i] > next;
    std::array<std::uint64_t, sizeof(Pack) / sizeof(std::uint64_t)> any;
    std::memcpy(any.data(), &further, sizeof any);
    if (std::all_of(any.begin(), any.end(), [](std::uint64_t lanes) { return lanes == 0; })) break;
    for (int k = first; k < first + kOften; ++k) {
      const auto across = static_cast<std::int16_t>((2 * k - 1) * (2 * k - 1));
      for (std::size_t i = 0; i < kPacks; ++i) {
        Pack left;
        Pack right;
        std::memcpy(&left, middle + kWidth * i - k, sizeof left);
        std::memcpy(&right, middle + kWidth * i + k, sizeof right);
        const Pack slanted = (left < right ? left : right) + across;
        best[i] = slanted < best[i] ? slanted : best[i];
      }
    }
  }
  std::memcpy(squares, best.data(), sizeof best);
}

#ifdef FAIRWAY_HAS_LANES256
[[gnu::target("avx2")]] void try_columns_256(const std::int16_t* middle,
                                             int most,
                                             std::int16_t least,
                                             std::int16_t* squares) noexcept {
  try_columns<Squares256>(middle, most, least, squares);
}
#endif

void try_columns_fast(const std::int16_t* middle,
                      int most,
                      std::int16_t least,
                      std::int16_t* squares) noexcept {
#ifdef FAIRWAY_HAS_LANES256
  if (__builtin_cpu_supports("avx2") != 0) {
    try_columns_256(middle, most, least, squares);
    return;
  }
#endif
  try_columns<Squares128>(middle, most, least, squares);
}

}  // namespace

void DistanceRow::load(const std::uint16_t* steps, int width, int most, int first, int last) {
  most_ = most;
  far_ = static_cast<std::int16_t>((2 * most - 1) * (2 * most - 1));
  const int parts = (width + kPart - 1) / kPart;
  const auto padded = static_cast<std::size_t>((parts + 2) * kPart);
  if (width_ != width) {
    width_ = width;
    squares_.assign(padded, 0);
    least_.assign(static_cast<std::size_t>(parts) + 2, 0);
  }
  const auto limit = static_cast<std::uint16_t>(most);
  for (int part = std::max(0, first / kPart - 1); part <= std::min(parts - 1, last / kPart + 1);
       ++part) {
    std::int16_t* const squares = squares_.data() + kPart * (part + 1);
    const std::uint16_t* const from = steps + kPart * part;
    const int count = std::min(kPart, width - kPart * part);
    for (int i = 0; i < count; ++i) {
      const int straight = std::max(2 * std::min(from[i], limit) - 1, 0);
      squares[i] = static_cast<std::int16_t>(straight * straight);
    }
    std::int16_t least = squares[0];
    for (int i = 1; i < kPart; ++i)
      least = std::min(least, squares[i]);
    least_[static_cast<std::size_t>(part) + 1] = least;
  }
}

bool DistanceRow::find_squares(int part, std::int16_t hopeless, std::int16_t* squares) const {
  const auto p = static_cast<std::size_t>(part) + 1;
  const std::int16_t least = std::min({least_[p - 1], least_[p], least_[p + 1]});
  if (least >= hopeless) {
    std::fill_n(squares, kPart, far_);
    return false;
  }
  try_columns_fast(squares_.data() + p * kPart, most_ - 1, least, squares);
  std::int16_t greatest = squares[0];
  for (int i = 1; i < kPart; ++i)
    greatest = std::max(greatest, squares[i]);
  return greatest < far_;
}

}  // namespace fairway
#pragma GCC diagnostic pop
