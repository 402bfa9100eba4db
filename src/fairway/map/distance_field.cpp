// SPDX-License-Identifier: Apache-2.0
#include "fairway/map/distance_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fairway/base/contract.hpp"
#include "fairway/map/free_space.hpp"

// The transform has two passes (Meijster, Roerdink, Hesselink 2000). The first counts steps along
// every column; the second finds, along every row, the lower envelope of the parabolas given by the
// columns' distances.
//
// The unit is half a cell, so that all numbers are integers. A closed square k > 0 columns away
// begins 2k - 1 half cells from a cell's centre, at its near edge. So for cell x and a column
// *edge* e (the line between columns e - 1 and e) the squared distance through that edge is
//     (2x + 1 - 2e)^2 + height(e),
// with height(e) = (2 min(steps) - 1)^2 over the two columns at the edge: parabolas over edges.

namespace fairway {

namespace {

constexpr std::size_t kLanes = 8;

// Lane masks for every pattern of 8 cells: all bits are set in the lanes of free cells.
constexpr auto kFreeLanes = [] {
  std::array<std::array<std::uint16_t, kLanes>, 256> masks{};
  for (std::size_t bits = 0; bits < 256; ++bits) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      masks[bits][lane] = (bits >> lane & 1U) != 0 ? 0 : 0xFFFF;
    }
  }
  return masks;
}();

// Advances the step counts by one row: 0 in blocked cells, one more than in row `previous` in
// others. With kBounded the value already in `steps` is an upper bound.
template <bool kBounded>
void step_columns(std::span<const std::uint64_t> words,
                  const std::uint16_t* previous,
                  std::uint16_t* steps) {
  for (const std::uint64_t word : words) {
    for (std::size_t byte = 0; byte < 8; ++byte) {
      const auto& free_lanes = kFreeLanes[word >> (8 * byte) & 0xFFU];
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const auto next = static_cast<std::uint16_t>((previous[lane] + 1) & free_lanes[lane]);
        steps[lane] = kBounded ? std::min(steps[lane], next) : next;
      }
      previous += kLanes;
      steps += kLanes;
    }
  }
}

// Limits step counts to `most`. Rows that differ only beyond that limit then compare as equal.
void shorten(std::vector<std::uint16_t>& steps, int most) {
  const auto limit = static_cast<std::uint16_t>(most);
  for (std::uint16_t& step : steps)
    step = std::min(step, limit);
}

// Returns the greatest value. std::max_element also finds its position, and so does not vectorise.
template <std::size_t kCount>
std::int16_t greatest(const std::array<std::int16_t, kCount>& values) {
  std::int16_t most = values[0];
  for (const std::int16_t value : values)
    most = std::max(most, value);
  return most;
}

// Counts steps to the nearest blocked cell of the column, or to the outside, for the columns of
// some words. `steps` points to row 0; the rows before the first and after the last are 0, for the
// outside.
void measure_columns(const BitGrid& obstacles,
                     std::size_t first_word,
                     std::size_t word_count,
                     std::uint16_t* steps,
                     std::size_t stride) {
  const int height = obstacles.frame().height;
  std::uint16_t* row = steps;
  for (int y = 0; y < height; ++y, row += stride)
    step_columns<false>(obstacles.row(y).subspan(first_word, word_count), row - stride, row);
  for (int y = height - 1; y >= 0; --y) {
    row -= stride;
    step_columns<true>(obstacles.row(y).subspan(first_word, word_count), row + stride, row);
  }
}

}  // namespace

DistanceField::DistanceField(const BitGrid& obstacles) { update(obstacles); }

void DistanceField::update(const BitGrid& obstacles) {
  frame_ = obstacles.frame();
  near_ = std::isinf(reach_) ? 0 : static_cast<int>(std::ceil(reach_ / frame_.resolution)) + 1;
  FAIRWAY_EXPECTS(near_ >= 0 && near_ <= kMostReach + 1);
  const auto width = static_cast<std::size_t>(frame_.width);
  const auto height = static_cast<std::size_t>(frame_.height);
  cells_.resize(width * height);
  if (cells_.empty()) return;
  stride_ = obstacles.row(0).size() * 64;
  column_steps_.resize(stride_ * (height + 2));
  std::fill_n(column_steps_.begin(), stride_, std::uint16_t{0});
  std::fill_n(column_steps_.end() - static_cast<std::ptrdiff_t>(stride_), stride_,
              std::uint16_t{0});
  envelope_.resize(width + 2);
  starts_.resize(width);
  squares_.resize(width);
  for (std::size_t n = std::max<std::size_t>(1, eighths_.size()); n < width + 2; ++n) {
    eighths_.resize(n + 1);
    eighths_[n] = 0.125 / static_cast<double>(n);
  }
  measure_columns(obstacles, 0, stride_ / 64, column_steps_.data() + stride_, stride_);
  if (near_ > 0) shorten(column_steps_, near_);
  for (int y = 0; y < frame_.height; ++y)
    update_row(y, 0, frame_.width - 1);
}

void DistanceField::update(const BitGrid& obstacles, const CellWindow& changed) {
  FAIRWAY_EXPECTS(obstacles.frame().width == frame_.width &&
                  obstacles.frame().height == frame_.height);
  const int first = std::max(0, changed.first.x);
  const int last = std::min(frame_.width - 1, changed.last.x);
  if (first > last || std::max(0, changed.first.y) > std::min(frame_.height - 1, changed.last.y))
    return;
  const auto first_word = static_cast<std::size_t>(first) / 64;
  const std::size_t words = static_cast<std::size_t>(last) / 64 - first_word + 1;
  const std::size_t lanes = words * 64;
  window_steps_.assign(lanes * (static_cast<std::size_t>(frame_.height) + 2), 0);
  measure_columns(obstacles, first_word, words, window_steps_.data() + lanes, lanes);
  if (near_ > 0) shorten(window_steps_, near_);
  for (int y = 0; y < frame_.height; ++y) {
    const std::uint16_t* now = window_steps_.data() + (static_cast<std::size_t>(y) + 1) * lanes;
    std::uint16_t* before =
        column_steps_.data() + (static_cast<std::size_t>(y) + 1) * stride_ + first_word * 64;
    if (std::equal(now, now + lanes, before)) continue;
    std::copy(now, now + lanes, before);
    update_row(y, first, last);
  }
}

void DistanceField::update_row(int y, int first, int last) {
  if (near_ > 0) {
    update_near(y, std::max(0, first - near_), std::min(frame_.width - 1, last + near_));
    return;
  }
  const std::uint16_t* steps = column_steps_.data() + (static_cast<std::size_t>(y) + 1) * stride_;
  float* distances =
      cells_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(frame_.width);
  // A blocked cell shields the cells beyond it: no obstacle behind it is nearer. A change therefore
  // affects only the runs of free cells that touch it, and each run is computed on its own.
  while (first > 0 && steps[first - 1] != 0)
    --first;
  last = std::min(last + 1, frame_.width - 1);
  for (int x = first; x <= last;) {
    if (steps[x] == 0) {
      distances[x++] = 0.0F;
      continue;
    }
    int end = x;
    while (end < frame_.width && steps[end] != 0)
      ++end;
    update_run(steps, x, end, distances);
    x = end;
  }
}

void DistanceField::update_run(const std::uint16_t* steps, int first, int end, float* distances) {
  Parabola* envelope = envelope_.data();
  // The blocked cells (or the outside) at both ends have height 0 at the edges of the run.
  Parabola last{.edge = first, .start = first, .height = 0};
  int count = 0;  // number of parabolas before `last`
  for (int edge = first + 1; edge <= end; ++edge) {
    const std::int64_t nearest = 2 * std::min(steps[edge - 1], steps[edge]) - 1;
    const std::int64_t height = edge == end ? 0 : nearest * nearest;
    // Drop every parabola that the new one undercuts from its start on:
    // (2 start + 1 - 2 edge)^2 + height <= (2 start + 1 - 2 last.edge)^2 + last.height.
    while (count > 0 && height - last.height <= 4 * static_cast<std::int64_t>(edge - last.edge) *
                                                    (2 * last.start + 1 - edge - last.edge)) {
      last = envelope[--count];
    }
    // The new parabola is lower to the right of the crossing. Where rounding moves the crossing
    // across an integer, both parabolas are equal there.
    const double crossing =
        0.5 * (edge + last.edge - 1) + static_cast<double>(height - last.height) *
                                           eighths_[static_cast<std::size_t>(edge - last.edge)];
    if (crossing >= end - 1) continue;
    envelope[count++] = last;
    last = {.edge = edge, .start = static_cast<int>(crossing) + 1, .height = height};
  }
  envelope[count++] = last;
  std::fill(starts_.begin() + first, starts_.begin() + end, std::uint8_t{0});
  for (int i = 1; i < count; ++i)
    starts_[static_cast<std::size_t>(envelope[i].start)] = 1;
  const Parabola* p = envelope;
  for (int x = first; x < end; ++x) {
    p += starts_[static_cast<std::size_t>(x)];  // starts are distinct
    const int straight = 2 * steps[x] - 1;
    const int across = 2 * (x - p->edge) + 1;
    const int slanted = across * across + static_cast<int>(p->height);
    squares_[static_cast<std::size_t>(x)] =
        static_cast<float>(std::min(straight * straight, slanted));
  }
  const auto scale = static_cast<float>(0.5 * frame_.resolution);
  for (int x = first; x < end; ++x)
    distances[x] = scale * std::sqrt(squares_[static_cast<std::size_t>(x)]);
}

// Updates cells `first` to `last` of a row under a finite reach. All columns within reach are
// tried, with the same arithmetic for many cells at once.
void DistanceField::update_near(int y, int first, int last) {
  const std::uint16_t* steps = column_steps_.data() + (static_cast<std::size_t>(y) + 1) * stride_;
  float* distances =
      cells_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(frame_.width);
  constexpr int kPart = 64;
  const int far = 2 * near_ - 1;
  const auto farthest = static_cast<std::int16_t>(far * far);
  std::array<std::int16_t, kPart> best{};
  near_squares_.resize(static_cast<std::size_t>(kPart + 2 * near_));
  for (int part = first; part <= last; part += kPart) {
    const int count = std::min(kPart, last - part + 1);
    std::int16_t least = farthest;
    for (int i = 0; i < kPart + 2 * near_; ++i) {
      const int x = part + i - near_;
      const bool inside = x >= 0 && x < frame_.width;
      const int straight = inside && steps[x] > 0 ? 2 * steps[x] - 1 : 0;
      const auto square = static_cast<std::int16_t>(straight * straight);
      near_squares_[static_cast<std::size_t>(i)] = square;
      least = std::min(least, square);
    }
    if (least >= farthest) {
      std::fill_n(distances + part, count, static_cast<float>(reach_));
      continue;
    }
    const std::int16_t* const middle = near_squares_.data() + near_;
    std::copy_n(middle, kPart, best.begin());
    constexpr int kOften = 4;  // columns between two checks whether any cell can still improve
    for (int k = 1; k <= near_; ++k) {
      const auto across = static_cast<std::int16_t>((2 * k - 1) * (2 * k - 1));
      if (k % kOften == 0 && least + across >= greatest(best)) break;
      const std::int16_t* const left = middle - k;
      const std::int16_t* const right = middle + k;
      for (int i = 0; i < kPart; ++i) {
        const auto slanted = static_cast<std::int16_t>(std::min(left[i], right[i]) + across);
        best[static_cast<std::size_t>(i)] = std::min(best[static_cast<std::size_t>(i)], slanted);
      }
    }
    const auto scale = static_cast<float>(0.5 * frame_.resolution);
    for (int i = 0; i < count; ++i) {
      const auto square = static_cast<float>(best[static_cast<std::size_t>(i)]);
      distances[part + i] = std::min(scale * std::sqrt(square), static_cast<float>(reach_));
    }
  }
}

}  // namespace fairway
