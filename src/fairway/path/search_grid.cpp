// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/search_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace fairway {

namespace {

constexpr int kMaxUnit = 32;
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
  return is_gentle(least, most);
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
  const auto columns = static_cast<std::size_t>(kSide * width());
  outside_.assign(columns, -1.0F);
  greatest_.assign(columns, -1.0F);
  tightest_.assign(columns, -1.0F);
  block_greatest_.resize(columns / kSide);
  block_tightest_.resize(columns / kSide);
  column_masks_.resize(static_cast<std::size_t>(stride()));
  column_least_.resize(static_cast<std::size_t>(stride()));
  column_most_.resize(static_cast<std::size_t>(stride()));
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

// Short loops over whole rows without branches, which the compiler turns into vector instructions.
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
  std::array<const float*, kSide> cells{};
  for (int row = 0; row < kSide; ++row) {
    cells[static_cast<std::size_t>(row)] =
        row < rows ? costs_->distances().cells().data() +
                         static_cast<std::ptrdiff_t>(kSide * y + row) * frame.width
                   : outside_.data();
  }
  float* const greatest = greatest_.data();
  float* const tightest = tightest_.data();
  for (int x = 0; x < frame.width; ++x) {
    const float a = cells[0][x];
    const float b = cells[1][x];
    const float c = cells[2][x];
    const float d = cells[3][x];
    greatest[x] = std::max(std::max(a, b), std::max(c, d));
    tightest[x] = std::min(std::min(a, b), std::min(c, d));
  }
  for (int x = 0; x < width(); ++x) {
    const float* d = greatest + kSide * x;
    block_greatest_[static_cast<std::size_t>(x)] =
        std::max(std::max(d[0], d[1]), std::max(d[2], d[3]));
  }
  for (int x = 0; x < width(); ++x) {
    const float* d = tightest + kSide * x;
    block_tightest_[static_cast<std::size_t>(x)] =
        std::min(std::min(d[0], d[1]), std::min(d[2], d[3]));
  }
  // Local copies, because a store to a byte may alias every member.
  const TravelCost costs = *costs_;
  const float least = costs.least_distance();
  const auto unit = static_cast<float>(this->unit());
  const float* const most = block_greatest_.data();
  const float* const tight = block_tightest_.data();
  const int count = width();
  for (int x = 0; x < count; ++x)
    nodes[x] = most[x] >= least ? to_byte(costs.at_distance(most[x]), unit) : std::uint8_t{0};
  for (int x = 0; x < count; ++x)
    masks[x] = tight[x] >= least ? kFull : std::uint16_t{0};
  for (int x = 0; x < count; ++x) {
    if (nodes[x] != 0 && masks[x] == 0) masks[x] = allowed_cells({.x = x, .y = y});
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
  const int first = index({.x = -1, .y = y});
  const int count = stride();
  std::uint8_t* const nodes = nodes_.data() + first;
  const std::uint16_t* const masks = masks_.data() + first;
  // Over the three rows, and then over three columns each.
  std::uint16_t* const all = column_masks_.data();
  std::uint8_t* const least = column_least_.data();
  std::uint8_t* const most = column_most_.data();
  for (int x = 0; x < count; ++x)
    all[x] = masks[x - count] & masks[x] & masks[x + count];
  for (int x = 0; x < count; ++x) {
    const std::uint8_t below = nodes[x - count] & kCost;
    const std::uint8_t here = nodes[x] & kCost;
    const std::uint8_t above = nodes[x + count] & kCost;
    least[x] = std::min(std::min(below, here), above);
    most[x] = std::max(std::max(below, here), above);
  }
  for (int x = 1; x + 1 < count; ++x) {
    if ((all[x - 1] & all[x] & all[x + 1]) != kFull) continue;
    if (is_gentle(std::min(std::min(least[x - 1], least[x]), least[x + 1]),
                  std::max(std::max(most[x - 1], most[x]), most[x + 1]))) {
      nodes[x] |= kOpen;
    }
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
