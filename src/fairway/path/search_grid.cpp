// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/search_grid.hpp"

#include <algorithm>
#include <cmath>

namespace fairway {

namespace {

constexpr int kMaxUnit = 32;
constexpr float kLargeDistance = std::numeric_limits<float>::infinity();
constexpr std::uint16_t kFull = 0xFFFF;

}  // namespace

bool SearchGrid::is_gentle(int index) const noexcept {
  const std::uint8_t* below = nodes_.data() + index - stride();
  int least = kCost;
  int most = 0;
  for (int row = 0; row < 3; ++row, below += stride()) {
    for (int x = -1; x <= 1; ++x) {
      const int cost = below[x] & kCost;
      least = std::min(least, cost);
      most = std::max(most, cost);
    }
  }
  return 58 * most < 106 * least;
}

int SearchGrid::unit_for(const TravelCost& costs) noexcept {
  return std::clamp(static_cast<int>(kCost / costs.greatest_cost()), 1, kMaxUnit);
}

void SearchGrid::resize(const TravelCost& costs, int spacing) {
  costs_ = &costs;
  width_ = (costs.frame().width + spacing - 1) / spacing;
  height_ = (costs.frame().height + spacing - 1) / spacing;
  unit_ = unit_for(costs);
  if (nodes_.size() != size()) nodes_.assign(size(), 0);
}

bool BlockGrid::begin(const TravelCost& costs) {
  const BitGrid& map = costs.obstacles();
  const bool same = map.zones() == nullptr && map_.zones() == nullptr && map == map_ &&
                    costs.distances().reach() == reach_ && costs.scale() == scale_;
  resize(costs, kSide);
  if (same) return true;
  restart();
  map_ = map;
  reach_ = costs.distances().reach();
  scale_ = costs.scale();
  masks_.resize(size());
  column_distances_.resize(static_cast<std::size_t>(kSide * width()));
  tightest_.resize(column_distances_.size());
  first_computed_ = 0;
  last_computed_ = -1;
  return false;
}

void BlockGrid::extend_rows(int first, int last, std::uint32_t* so_far) {
  first = std::max(first, -1);
  last = std::min(last, height());
  const auto forget = [&](int y) {
    std::fill_n(so_far + index({.x = -1, .y = y}), stride(), kUnreached);
  };
  compute_rows(first, last);
  if (first_row_ > last_row_) {
    first_row_ = first;
    last_row_ = first - 1;
  }
  while (first_row_ > first)
    forget(--first_row_);
  while (last_row_ < last)
    forget(++last_row_);
}

// Computes rows `first` to `last`, and all rows between them and those computed before.
void BlockGrid::compute_rows(int first, int last) {
  if (first_computed_ > last_computed_) {
    first_computed_ = first;
    last_computed_ = first - 1;
    fill_row(first - 1);
    fill_row(first);
  }
  while (first_computed_ > first) {
    fill_row(--first_computed_ - 1);
    open_row(first_computed_);
  }
  while (last_computed_ < last) {
    fill_row(++last_computed_ + 1);
    open_row(last_computed_);
  }
}

void BlockGrid::fill_row(int y) {
  if (y < -1 || y > height()) return;
  std::uint8_t* const nodes = nodes_.data() + index({.x = 0, .y = y});
  std::uint16_t* const masks = masks_.data() + index({.x = 0, .y = y});
  std::fill_n(nodes - 1, stride(), std::uint8_t{0});
  std::fill_n(masks - 1, stride(), std::uint16_t{0});
  if (y < 0 || y >= height()) return;
  const GridFrame& frame = costs_->frame();
  // Cells beyond the upper and the right edge of the map have no clearance.
  const int rows = std::min(kSide, frame.height - kSide * y);
  std::fill(column_distances_.begin(), column_distances_.end(), -1.0F);
  std::fill(tightest_.begin(), tightest_.end(), rows < kSide ? -1.0F : kLargeDistance);
  std::fill(tightest_.begin() + frame.width, tightest_.end(), -1.0F);
  const float* distances =
      costs_->distances().cells().data() + static_cast<std::ptrdiff_t>(kSide * y) * frame.width;
  float* const greatest = column_distances_.data();
  float* const tightest = tightest_.data();
  for (int row = 0; row < rows; ++row, distances += frame.width) {
    for (int x = 0; x < frame.width; ++x) {
      greatest[x] = std::max(greatest[x], distances[x]);
      tightest[x] = std::min(tightest[x], distances[x]);
    }
  }
  const float least = costs_->least_distance();
  for (int x = 0; x < width(); ++x) {
    const float* d = greatest + kSide * x;
    const float* tight = tightest + kSide * x;
    const float most = std::max(std::max(d[0], d[1]), std::max(d[2], d[3]));
    if (most < least) continue;
    nodes[x] = byte_at(most);
    const bool full = std::min(std::min(tight[0], tight[1]), std::min(tight[2], tight[3])) >= least;
    masks[x] = full ? kFull : allowed_cells({.x = x, .y = y});
  }
}

std::uint16_t BlockGrid::allowed_cells(CellIndex node) const noexcept {
  const GridFrame& frame = costs_->frame();
  const float least = costs_->least_distance();
  const int columns = std::min(kSide, frame.width - kSide * node.x);
  const int rows = std::min(kSide, frame.height - kSide * node.y);
  const float* distances = costs_->distances().cells().data() +
                           static_cast<std::ptrdiff_t>(kSide * node.y) * frame.width +
                           kSide * node.x;
  unsigned mask = 0;
  for (int y = 0; y < rows; ++y, distances += frame.width) {
    for (int x = 0; x < columns; ++x)
      mask |= (distances[x] >= least ? 1U : 0U) << (kSide * y + x);
  }
  return static_cast<std::uint16_t>(mask);
}

void BlockGrid::open_row(int y) {
  if (y < 0 || y >= height()) return;
  for (int x = 0; x < width(); ++x) {
    const int i = index({.x = x, .y = y});
    const std::uint16_t* here = masks_.data() + i;
    if (*here != kFull) continue;
    const std::uint16_t* below = here - stride();
    const std::uint16_t* above = here + stride();
    const int all =
        below[-1] & below[0] & below[1] & here[-1] & here[1] & above[-1] & above[0] & above[1];
    if (all == kFull && is_gentle(i)) nodes_[static_cast<std::size_t>(i)] |= kOpen;
  }
}

bool BlockGrid::linked(CellIndex node, unsigned direction) const noexcept {
  const int i = index(node);
  const unsigned from = masks_[static_cast<std::size_t>(i)];
  const unsigned to =
      masks_[static_cast<std::size_t>(i + kStepY[direction] * stride() + kStepX[direction])];
  if ((from & to) == kFull) return true;
  // Cells that touch across a side: those in the same row or column, or offset by one.
  constexpr unsigned kColumn = 0x1111;
  constexpr unsigned kRow = 0xF;
  const auto touch = [](unsigned a, unsigned b, unsigned shift) {
    return ((a | a << shift | a >> shift) & b) != 0;
  };
  switch (direction) {
    case 0:
      return touch(from >> 3U & kColumn, to & kColumn, 4);
    case 1:
      return (from >> 15U & to & 1U) != 0;
    case 2:
      return touch(from >> 12U, to & kRow, 1);
    case 3:
      return (from >> 12U & to >> 3U & 1U) != 0;
    case 4:
      return touch(to >> 3U & kColumn, from & kColumn, 4);
    case 5:
      return (to >> 15U & from & 1U) != 0;
    case 6:
      return touch(to >> 12U, from & kRow, 1);
    default:
      return (to >> 12U & from >> 3U & 1U) != 0;
  }
}

void CellGrid::begin(const TravelCost& costs) {
  clear(costs);
  add_cells({.x = 0, .y = 0}, {.x = width() - 1, .y = height() - 1});
  mark_open();
}

void CellGrid::begin(const TravelCost& costs, std::span<const CellIndex> blocks) {
  clear(costs);
  for (const CellIndex& block : blocks) {
    constexpr int kSide = BlockGrid::kSide;
    add_cells({.x = kSide * block.x - kReach, .y = kSide * block.y - kReach},
              {.x = kSide * (block.x + 1) - 1 + kReach, .y = kSide * (block.y + 1) - 1 + kReach});
  }
  mark_open();
}

void CellGrid::clear(const TravelCost& costs) {
  // When the size changes, all bytes are new, and 0.
  const std::size_t before = nodes_.size();
  resize(costs, 1);
  if (nodes_.size() == before) {
    for (const int i : indices_)
      nodes_[static_cast<std::size_t>(i)] = 0;
  }
  indices_.clear();
  prepared_ = false;
}

void CellGrid::add_cells(CellIndex first, CellIndex last) {
  const float least = costs_->least_distance();
  const std::span<const float> distances = costs_->distances().cells();
  const int right = std::min(last.x, width() - 1);
  for (int y = std::max(0, first.y); y <= std::min(last.y, height() - 1); ++y) {
    const float* row = distances.data() + static_cast<std::ptrdiff_t>(y) * width();
    for (int x = std::max(0, first.x); x <= right; ++x) {
      const int i = index({.x = x, .y = y});
      if (row[x] < least || nodes_[static_cast<std::size_t>(i)] != 0) continue;
      nodes_[static_cast<std::size_t>(i)] = byte_of(costs_->at_cell({.x = x, .y = y}, row[x]));
      indices_.push_back(i);
    }
  }
}

void CellGrid::mark_open() {
  if (costs_->diagonals_need_checks() || costs_->steps_need_checks()) return;
  for (const int i : indices_) {
    if (is_gentle(i)) nodes_[static_cast<std::size_t>(i)] |= kOpen;
  }
}

void CellGrid::reset(std::uint32_t* so_far) {
  prepared_ = true;
  for (const int i : indices_)
    so_far[i] = kUnreached;
}

bool CellGrid::linked(CellIndex node, unsigned direction) const noexcept {
  const int dx = kStepX[direction];
  const int dy = kStepY[direction];
  if (direction % 2 != 0 && !costs_->diagonal_is_free(node, dx, dy)) return false;
  return !costs_->steps_need_checks() ||
         costs_->step_fits(node, {.x = node.x + dx, .y = node.y + dy});
}

}  // namespace fairway
