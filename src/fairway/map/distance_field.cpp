// SPDX-License-Identifier: Apache-2.0
#include "fairway/map/distance_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fairway/base/contract.hpp"
#include "fairway/map/free_space.hpp"

// The transform has two passes (Meijster, Roerdink, Hesselink 2000). The first counts steps along
// every column; the second finds, along every row, the lower envelope of the parabolas given by the
// columns' distances. Most cells are near an obstacle; for them it is faster to try the columns
// around (DistanceRow). Envelopes remain for the runs of cells with one that is further away.
//
// The unit is half a cell, so that all numbers are integers. A closed square k > 0 columns away
// begins 2k - 1 half cells from a cell's centre, at its near edge. So for cell x and a column
// *edge* e (the line between columns e - 1 and e) the squared distance through that edge is
//     (2x + 1 - 2e)^2 + height(e),
// with height(e) = (2 min(steps) - 1)^2 over the two columns at the edge: parabolas over edges.

namespace fairway {

namespace {

// Counts steps to the nearest blocked cell of the column, or to the outside. It does so for the
// columns of some words and for rows `first` to `last`, up to `most`. `steps` points to row
// `first`; the rows before and after are already correct.
void measure_columns(const BitGrid& obstacles,
                     int first,
                     int last,
                     std::size_t first_word,
                     std::size_t word_count,
                     std::uint16_t most,
                     std::uint16_t* steps,
                     std::size_t stride) {
  std::uint16_t* row = steps;
  for (int y = first; y <= last; ++y, row += stride)
    DistanceRow::step(obstacles.row(y).subspan(first_word, word_count), row - stride, most, false,
                      row);
  for (int y = last; y >= first; --y) {
    row -= stride;
    DistanceRow::step(obstacles.row(y).subspan(first_word, word_count), row + stride, most, true,
                      row);
  }
}

// Returns the last row from `y` on, in direction `step`, that a change of columns before row y can
// affect. The change is in columns `first` to `last`. At that row every column has met an obstacle,
// or the map ends, or `most` rows have passed.
int last_concerned(const BitGrid& obstacles, int y, int step, int first, int last, int most) {
  const auto inside = [&](int row) { return row >= 0 && row < obstacles.frame().height; };
  int furthest = y - step;
  for (int word = first / 64; word <= last / 64; ++word) {
    std::uint64_t open = ~0ULL;
    if (word == first / 64) open &= ~0ULL << (first % 64);
    if (word == last / 64) open &= ~0ULL >> (63 - last % 64);
    int row = y - step;
    for (int count = 0; open != 0 && count < most && inside(row + step); ++count) {
      row += step;
      open &= ~obstacles.row(row)[static_cast<std::size_t>(word)];
    }
    furthest = step > 0 ? std::max(furthest, row) : std::min(furthest, row);
  }
  return furthest;
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
  for (int y = 0; y < frame_.height; ++y)
    DistanceRow::step(obstacles.row(y), steps_of(y - 1), most_steps(), false, steps_of(y));
  // The second pass follows row by row, while the steps of the row are in the cache.
  for (int y = frame_.height - 1; y >= 0; --y) {
    DistanceRow::step(obstacles.row(y), steps_of(y + 1), most_steps(), true, steps_of(y));
    update_row(y, 0, frame_.width - 1);
  }
}

// Returns the cells of a window whose obstacles are others than at the last update.
CellWindow DistanceField::changed_part(const BitGrid& obstacles, const CellWindow& window) {
  const auto first_word = static_cast<std::size_t>(window.first.x) / 64;
  const std::size_t words = static_cast<std::size_t>(window.last.x) / 64 - first_word + 1;
  window_steps_.assign(words * 64, 0);
  CellWindow part{.first = {window.last.x + 1, window.last.y + 1}, .last = {-1, -1}};
  for (int y = window.first.y; y <= window.last.y; ++y) {
    const bool differs =
        DistanceRow::mark_changes(obstacles.row(y).subspan(first_word, words),
                                  steps_of(y) + 64 * first_word, window_steps_.data());
    if (!differs) continue;
    part.first.y = std::min(part.first.y, y);
    part.last.y = y;
  }
  const auto changed = [](std::uint16_t lane) { return lane != 0; };
  const auto first = std::find_if(window_steps_.begin(), window_steps_.end(), changed);
  if (first == window_steps_.end()) return part;
  const auto last = std::find_if(window_steps_.rbegin(), window_steps_.rend(), changed);
  part.first.x =
      static_cast<int>(64 * first_word) + static_cast<int>(first - window_steps_.begin());
  part.last.x = static_cast<int>(64 * (first_word + words)) - 1 -
                static_cast<int>(last - window_steps_.rbegin());
  return part;
}

void DistanceField::update(const BitGrid& obstacles, const CellWindow& changed) {
  FAIRWAY_EXPECTS(obstacles.frame().width == frame_.width &&
                  obstacles.frame().height == frame_.height);
  CellWindow window = clipped(changed, frame_);
  if (is_empty(window)) return;
  window = changed_part(obstacles, window);
  if (is_empty(window)) return;
  const int first = window.first.x;
  const int last = window.last.x;
  const int most = near_ > 0 ? near_ : frame_.height;
  const int bottom = last_concerned(obstacles, window.first.y - 1, -1, first, last, most);
  const int top = last_concerned(obstacles, window.last.y + 1, 1, first, last, most);
  const auto first_word = static_cast<std::size_t>(first) / 64;
  const std::size_t words = static_cast<std::size_t>(last) / 64 - first_word + 1;
  const std::size_t lanes = words * 64;
  const auto rows = static_cast<std::size_t>(top - bottom + 1);
  window_steps_.resize(lanes * (rows + 2));
  std::copy_n(steps_of(bottom - 1) + 64 * first_word, lanes, window_steps_.begin());
  std::copy_n(steps_of(top + 1) + 64 * first_word, lanes,
              window_steps_.end() - static_cast<std::ptrdiff_t>(lanes));
  measure_columns(obstacles, bottom, top, first_word, words, most_steps(),
                  window_steps_.data() + lanes, lanes);
  const std::uint16_t* now = window_steps_.data() + lanes;
  for (int y = bottom; y <= top; ++y, now += lanes) {
    std::uint16_t* const before = steps_of(y) + 64 * first_word;
    if (std::equal(now, now + lanes, before)) continue;
    const auto changes = std::mismatch(now, now + lanes, before).first - now;
    std::ptrdiff_t last_change = static_cast<std::ptrdiff_t>(lanes) - 1;
    while (now[last_change] == before[last_change])
      --last_change;
    std::uint16_t lowest = std::numeric_limits<std::uint16_t>::max();
    for (std::ptrdiff_t i = changes; i <= last_change; ++i) {
      const std::uint16_t steps = std::min(now[i], before[i]);
      lowest = std::min(lowest, now[i] != before[i] ? steps : lowest);
    }
    std::copy(now, now + lanes, before);
    const auto left = static_cast<int>(64 * first_word);
    update_around(y, left + static_cast<int>(changes), left + static_cast<int>(last_change),
                  lowest);
  }
}

// Updates row y after a change of the steps of columns `first` to `last`, of which none had or has
// fewer than `lowest`. A column k cells away concerns a cell only if it is at most as far as the
// obstacle known so far; and towards either side that distance grows by at most one cell per cell.
void DistanceField::update_around(int y, int first, int last, int lowest) {
  const float* const distances =
      cells_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(frame_.width);
  constexpr double kRounding = 1e-5;
  const double half = 0.5 * frame_.resolution * (1.0 - kRounding);
  const auto concerned = [&](int x, int k) {
    return static_cast<double>(distances[x]) >= (2 * k - 1) * half;
  };
  int left = first;
  while (left > 0 && concerned(left - 1, first - left + 1))
    --left;
  int right = std::min(last, frame_.width - 1);
  while (right + 1 < frame_.width && concerned(right + 1, right + 1 - last))
    ++right;
  // The changed obstacles are not in this row, but some rows away.
  const double across = std::max(2 * lowest - 1, 0) * half;
  const auto reached = [&](int x) {
    const double along = std::max({2 * (first - x) - 1, 2 * (x - last) - 1, 0}) * half;
    const auto distance = static_cast<double>(distances[x]);
    return distance * distance >= along * along + across * across;
  };
  while (left <= right && !reached(left))
    ++left;
  while (left <= right && !reached(right))
    --right;
  if (left <= right) update_row(y, left, right);
}

void DistanceField::update_row(int y, int first, int last) {
  constexpr int kPart = DistanceRow::kPart;
  constexpr float kUnknown = -1.0F;
  const std::uint16_t* const steps = steps_of(y);
  float* const distances =
      cells_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(frame_.width);
  row_.load(steps, frame_.width, near_ > 0 ? near_ : DistanceRow::kMostColumns, first, last);
  const auto scale = static_cast<float>(0.5 * frame_.resolution);
  const auto reach = static_cast<float>(reach_);
  bool complete = true;
  // Half of the distance to the columns that are tried: there envelopes are faster.
  const auto hopeless =
      static_cast<std::int16_t>(near_ > 0 ? row_.far_square() : row_.far_square() / 4);
  std::array<std::int16_t, kPart> squares;
  for (int part = first / kPart; part <= last / kPart; ++part) {
    const bool near = row_.find_squares(part, hopeless, squares.data());
    const int from = std::max(first, kPart * part);
    const int to = std::min(last, kPart * part + kPart - 1);
    const std::int16_t* const square = squares.data() - kPart * part;
    for (int x = from; x <= to; ++x)
      distances[x] = std::min(scale * std::sqrt(static_cast<float>(square[x])), reach);
    if (near || near_ > 0) continue;
    complete = false;
    for (int x = from; x <= to; ++x) {
      if (square[x] >= row_.far_square()) distances[x] = kUnknown;
    }
  }
  for (int x = first; !complete && x <= last; ++x) {
    if (distances[x] >= 0.0F) continue;
    // A blocked cell shields the cells beyond it, so each run of free cells is computed on its own.
    int begin = x;
    while (begin > 0 && steps[begin - 1] != 0)
      --begin;
    while (x < frame_.width && steps[x] != 0)
      ++x;
    update_run(steps, begin, x, distances);
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

}  // namespace fairway
