// SPDX-License-Identifier: Apache-2.0
// GCC warns that the calling convention for wide registers changes with AVX. They are inlined.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"
#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <span>

#include "fairway/base/simd.hpp"
#include "fairway/map/distance_field.hpp"

namespace fairway {

namespace {

constexpr int kPart = DistanceRow::kPart;

using Squares128 [[gnu::vector_size(16)]] = std::int16_t;
using Squares256 [[gnu::vector_size(32)]] = std::int16_t;
using Steps128 [[gnu::vector_size(16)]] = std::uint16_t;
using Steps256 [[gnu::vector_size(32)]] = std::uint16_t;

// Lane i has bit i.
constexpr std::array<std::uint16_t, 16> kLaneBits = [] {
  std::array<std::uint16_t, 16> bits{};
  for (std::size_t lane = 0; lane < bits.size(); ++lane)
    bits[lane] = static_cast<std::uint16_t>(1U << lane);
  return bits;
}();

// Spreads the low bits of `word` over the lanes: lane i is not 0 if bit i is set.
template <typename Pack>
FAIRWAY_LANES void spread_bits(std::uint64_t word, Pack& lanes) noexcept {
  std::memcpy(&lanes, kLaneBits.data(), sizeof lanes);
  lanes &= Pack{} + static_cast<std::uint16_t>(word);
}

// Advances the step counts of 64 columns by one row: 0 in blocked cells, one more than in row
// `previous` in others, and at most `most`. With kBounded the value in `steps` is a bound, too.
template <typename Pack, bool kBounded>
FAIRWAY_LANES void step_columns(std::uint64_t blocked,
                                const std::uint16_t* previous,
                                std::uint16_t most,
                                std::uint16_t* steps) noexcept {
  constexpr std::size_t kWidth = sizeof(Pack) / sizeof(std::uint16_t);
  for (std::size_t i = 0; i < 64; i += kWidth) {
    Pack next;
    std::memcpy(&next, previous + i, sizeof next);
    next += 1;
    const Pack limit = Pack{} + most;
    next = next < limit ? next : limit;
    if constexpr (kBounded) {
      Pack bound;
      std::memcpy(&bound, steps + i, sizeof bound);
      next = next < bound ? next : bound;
    }
    Pack bits;
    spread_bits(blocked >> i, bits);
    next &= bits == 0;
    std::memcpy(steps + i, &next, sizeof next);
  }
}

template <typename Pack>
FAIRWAY_LANES void step_row(std::span<const std::uint64_t> words,
                            const std::uint16_t* previous,
                            std::uint16_t most,
                            bool bounded,
                            std::uint16_t* steps) noexcept {
  for (const std::uint64_t word : words) {
    if (bounded) {
      step_columns<Pack, true>(word, previous, most, steps);
    } else {
      step_columns<Pack, false>(word, previous, most, steps);
    }
    previous += 64;
    steps += 64;
  }
}

// Sets lanes of `changes` where a column is blocked and had steps, or the reverse.
template <typename Pack>
FAIRWAY_LANES bool mark_changed_lanes(std::span<const std::uint64_t> words,
                                      const std::uint16_t* steps,
                                      std::uint16_t* changes) noexcept {
  constexpr std::size_t kWidth = sizeof(Pack) / sizeof(std::uint16_t);
  Pack any{};
  for (const std::uint64_t word : words) {
    for (std::size_t i = 0; i < 64; i += kWidth) {
      Pack step;
      Pack lanes;
      std::memcpy(&step, steps + i, sizeof step);
      std::memcpy(&lanes, changes + i, sizeof lanes);
      Pack bits;
      spread_bits(word >> i, bits);
      Pack differs{};
      differs |= (step == 0) ^ (bits != 0);
      any |= differs;
      lanes |= differs;
      std::memcpy(changes + i, &lanes, sizeof lanes);
    }
    steps += 64;
    changes += 64;
  }
  std::array<std::uint64_t, sizeof(Pack) / sizeof(std::uint64_t)> found;
  std::memcpy(found.data(), &any, sizeof any);
  return std::any_of(found.begin(), found.end(), [](std::uint64_t lanes) { return lanes != 0; });
}

// Writes the squares of 64 steps, which are limited to `most`, and returns the least of them.
template <typename Steps, typename Squares>
FAIRWAY_LANES std::int16_t square_steps(const std::uint16_t* steps,
                                        int most,
                                        std::int16_t* squares) noexcept {
  constexpr std::size_t kWidth = sizeof(Squares) / sizeof(std::int16_t);
  const Steps limit = Steps{} + static_cast<std::uint16_t>(most);
  Squares least = Squares{} + std::numeric_limits<std::int16_t>::max();
  for (std::size_t i = 0; i < kPart; i += kWidth) {
    Steps step;
    std::memcpy(&step, steps + i, sizeof step);
    step = step < limit ? step : limit;
    Squares straight;
    std::memcpy(&straight, &step, sizeof step);
    straight = 2 * straight - 1;
    const Squares square = straight > 0 ? straight * straight : Squares{};
    least = least < square ? least : square;
    std::memcpy(squares + i, &square, sizeof square);
  }
  std::int16_t result = least[0];
  for (std::size_t lane = 1; lane < kWidth; ++lane)
    result = std::min(result, least[lane]);
  return result;
}

// Tries the columns around 64 cells, of which `middle` is the first, and writes the least squares.
// Columns further than `most` are not tried. No column square around is below `least`. Returns the
// greatest of the squares.
template <typename Pack>
FAIRWAY_LANES std::int16_t try_columns(const std::int16_t* middle,
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
    Pack furthest = best[0];
    for (std::size_t i = 1; i < kPacks; ++i)
      furthest = furthest > best[i] ? furthest : best[i];
    const Pack further = furthest > next;
    std::array<std::uint64_t, sizeof(Pack) / sizeof(std::uint64_t)> any;
    std::memcpy(any.data(), &further, sizeof any);
    std::uint64_t found = 0;
    for (const std::uint64_t lanes : any)
      found |= lanes;
    if (found == 0) break;
    for (int k = first; k < first + kOften; ++k) {
      const auto across = static_cast<std::int16_t>((2 * k - 1) * (2 * k - 1));
      for (std::size_t i = 0; i < kPacks; ++i) {
        Pack left;
        Pack right;
        std::memcpy(&left, middle + kWidth * i - k, sizeof left);
        std::memcpy(&right, middle + kWidth * i + k, sizeof right);
        const Pack slanted = (left < right ? left : right) + across;
        const Pack now = best[i];
        best[i] = now < slanted ? now : slanted;
      }
    }
  }
  std::memcpy(squares, best.data(), sizeof best);
  Pack greatest = best[0];
  for (std::size_t i = 1; i < kPacks; ++i)
    greatest = greatest > best[i] ? greatest : best[i];
  std::int16_t result = greatest[0];
  for (std::size_t lane = 1; lane < kWidth; ++lane)
    result = std::max(result, greatest[lane]);
  return result;
}

#ifdef FAIRWAY_HAS_LANES256
[[gnu::target("avx2")]] void step_row_256(std::span<const std::uint64_t> words,
                                          const std::uint16_t* previous,
                                          std::uint16_t most,
                                          bool bounded,
                                          std::uint16_t* steps) noexcept {
  step_row<Steps256>(words, previous, most, bounded, steps);
}

[[gnu::target("avx2")]] std::int16_t square_steps_256(const std::uint16_t* steps,
                                                      int most,
                                                      std::int16_t* squares) noexcept {
  return square_steps<Steps256, Squares256>(steps, most, squares);
}

[[gnu::target("avx2")]] std::int16_t try_columns_256(const std::int16_t* middle,
                                                     int most,
                                                     std::int16_t least,
                                                     std::int16_t* squares) noexcept {
  return try_columns<Squares256>(middle, most, least, squares);
}

[[gnu::target("avx2")]] bool mark_changed_lanes_256(std::span<const std::uint64_t> words,
                                                    const std::uint16_t* steps,
                                                    std::uint16_t* changes) noexcept {
  return mark_changed_lanes<Steps256>(words, steps, changes);
}

bool has_lanes_256() noexcept { return __builtin_cpu_supports("avx2") != 0; }
#endif

std::int16_t square_steps_fast(const std::uint16_t* steps,
                               int most,
                               std::int16_t* squares) noexcept {
#ifdef FAIRWAY_HAS_LANES256
  if (has_lanes_256()) return square_steps_256(steps, most, squares);
#endif
  return square_steps<Steps128, Squares128>(steps, most, squares);
}

std::int16_t try_columns_fast(const std::int16_t* middle,
                              int most,
                              std::int16_t least,
                              std::int16_t* squares) noexcept {
#ifdef FAIRWAY_HAS_LANES256
  if (has_lanes_256()) return try_columns_256(middle, most, least, squares);
#endif
  return try_columns<Squares128>(middle, most, least, squares);
}

}  // namespace

void DistanceRow::step(std::span<const std::uint64_t> words,
                       const std::uint16_t* previous,
                       std::uint16_t most,
                       bool bounded,
                       std::uint16_t* steps) noexcept {
#ifdef FAIRWAY_HAS_LANES256
  if (has_lanes_256()) {
    step_row_256(words, previous, most, bounded, steps);
    return;
  }
#endif
  step_row<Steps128>(words, previous, most, bounded, steps);
}

bool DistanceRow::mark_changes(std::span<const std::uint64_t> words,
                               const std::uint16_t* steps,
                               std::uint16_t* changes) noexcept {
#ifdef FAIRWAY_HAS_LANES256
  if (has_lanes_256()) return mark_changed_lanes_256(words, steps, changes);
#endif
  return mark_changed_lanes<Steps128>(words, steps, changes);
}

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
  for (int part = std::max(0, first / kPart - 1); part <= std::min(parts - 1, last / kPart + 1);
       ++part) {
    std::int16_t* const squares = squares_.data() + kPart * (part + 1);
    std::int16_t least = square_steps_fast(steps + kPart * part, most, squares);
    const int count = std::min(kPart, width - kPart * part);
    if (count < kPart) {
      std::fill(squares + count, squares + kPart, std::int16_t{0});
      least = 0;
    }
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
  return try_columns_fast(squares_.data() + p * kPart, most_ - 1, least, squares) < far_;
}

}  // namespace fairway
#pragma GCC diagnostic pop
