// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/search_grid.hpp"

#include <algorithm>
#include <cmath>

namespace fairway {

namespace {

constexpr int kMaxUnit = 32;
constexpr float kNoRoom = std::numeric_limits<float>::infinity();

}  // namespace

int SearchGrid::unit_for(const TravelCost& costs) noexcept {
  return std::clamp(static_cast<int>(kCost / costs.dearest()), 1, kMaxUnit);
}

void SearchGrid::resize(const TravelCost& costs, int spacing) {
  costs_ = &costs;
  width_ = (costs.frame().width + spacing - 1) / spacing;
  height_ = (costs.frame().height + spacing - 1) / spacing;
  unit_ = unit_for(costs);
  // Neighbours are `spacing` cells apart and a distance changes by no more than that; 1 for
  // rounding. See GridSearch::run for the condition.
  const double slope =
      static_cast<double>(costs.rise()) * unit_ * spacing * costs.frame().resolution + 1.0;
  gentle_ = !costs.diagonals_need_checks() && 58.0 * slope < 48.0 * unit_;
  if (nodes_.size() != size()) nodes_.assign(size(), 0);
}

void BlockGrid::begin(const TravelCost& costs) {
  resize(costs, 2);
  full_.resize(size());
  roomiest_.resize(static_cast<std::size_t>(2 * width()));
  tightest_.resize(roomiest_.size());
  first_row_ = 0;
  last_row_ = -1;
}

void BlockGrid::extend_rows(int first, int last, std::uint32_t* so_far) {
  first = std::max(first, -1);
  last = std::min(last, height());
  const auto know = [&](int y) {
    open_row(y);
    std::fill_n(so_far + index({.x = -1, .y = y}), stride(), kUnreached);
  };
  if (first_row_ > last_row_) {
    first_row_ = first;
    last_row_ = first - 1;
    fill_row(first - 1);
    fill_row(first);
  }
  while (first_row_ > first) {
    fill_row(--first_row_ - 1);
    know(first_row_);
  }
  while (last_row_ < last) {
    fill_row(++last_row_ + 1);
    know(last_row_);
  }
}

void BlockGrid::fill_row(int y) {
  if (y < -1 || y > height()) return;
  std::uint8_t* const nodes = nodes_.data() + index({.x = 0, .y = y});
  std::uint8_t* const full = full_.data() + index({.x = 0, .y = y});
  if (y < 0 || y >= height()) {
    std::fill_n(nodes - 1, stride(), std::uint8_t{0});
    std::fill_n(full - 1, stride(), std::uint8_t{0});
    return;
  }
  const int cells = costs_->frame().width;
  const float* const low =
      costs_->distances().cells().data() + static_cast<std::ptrdiff_t>(2 * y) * cells;
  // Cells beyond the upper and right edge of a map with odd sides have no room.
  const bool both_rows = 2 * y + 1 < costs_->frame().height;
  const float* const high = both_rows ? low + cells : low;
  float* const roomiest = roomiest_.data();
  float* const tightest = tightest_.data();
  for (int x = 0; x < cells; ++x) {
    roomiest[x] = low[x] > high[x] ? low[x] : high[x];
    tightest[x] = low[x] < high[x] ? low[x] : high[x];
  }
  if (cells % 2 != 0) roomiest[cells] = tightest[cells] = -1.0F;
  const TravelCost costs = *costs_;
  const float least = both_rows ? costs.least_distance() : kNoRoom;
  const float allowed = costs.least_distance();
  const auto scale = static_cast<float>(unit());
  const int blocks = width();
  for (int x = 0; x < blocks; ++x) {
    const float room = std::max(roomiest[2 * x], roomiest[2 * x + 1]);
    const int cost = static_cast<int>(costs.at_distance(room) * scale + 0.5F);
    nodes[x] = static_cast<std::uint8_t>(room >= allowed ? cost : 0);
  }
  for (int x = 0; x < blocks; ++x)
    full[x] = std::min(tightest[2 * x], tightest[2 * x + 1]) >= least ? 1 : 0;
  nodes[-1] = nodes[blocks] = 0;
  full[-1] = full[blocks] = 0;
}

void BlockGrid::open_row(int y) {
  if (!gentle_ || y < 0 || y >= height()) return;
  std::uint8_t* const nodes = nodes_.data() + index({.x = 0, .y = y});
  const std::uint8_t* const here = full_.data() + index({.x = 0, .y = y});
  const std::uint8_t* const below = here - stride();
  const std::uint8_t* const above = here + stride();
  const int blocks = width();
  for (int x = 0; x < blocks; ++x) {
    const int all = below[x - 1] & below[x] & below[x + 1] & here[x - 1] & here[x] & here[x + 1] &
                    above[x - 1] & above[x] & above[x + 1];
    nodes[x] = static_cast<std::uint8_t>(nodes[x] | all * kOpen);
  }
}

bool BlockGrid::linked(CellIndex node, unsigned direction) const noexcept {
  const int step_x = kStepX[direction];
  const int step_y = kStepY[direction];
  const auto is_full = [&](int x, int y) {
    return full_[static_cast<std::size_t>(index({.x = x, .y = y}))] != 0;
  };
  const bool checks = costs_->diagonals_need_checks();
  if (is_full(node.x, node.y) && is_full(node.x + step_x, node.y + step_y) &&
      (direction % 2 == 0 || !checks)) {
    return true;
  }
  const auto allowed = [&](int x, int y) { return costs_->is_allowed({.x = x, .y = y}); };
  // The node's cell that is furthest along the direction, and the one beside it if there are two.
  const int x = 2 * node.x + (step_x > 0 ? 1 : 0);
  const int y = 2 * node.y + (step_y > 0 ? 1 : 0);
  if (direction % 2 != 0) {
    return allowed(x, y) && allowed(x + step_x, y + step_y) &&
           costs_->diagonal_is_free({.x = x, .y = y}, step_x, step_y);
  }
  const int side_x = step_x == 0 ? 1 : 0;
  const int side_y = step_y == 0 ? 1 : 0;
  const bool from = allowed(x, y);
  const bool from_side = allowed(x + side_x, y + side_y);
  const bool to = allowed(x + step_x, y + step_y);
  const bool to_side = allowed(x + step_x + side_x, y + step_y + side_y);
  if ((from && to) || (from_side && to_side)) return true;
  if (from && to_side)
    return costs_->diagonal_is_free({.x = x, .y = y}, step_x + side_x, step_y + side_y);
  return from_side && to &&
         costs_->diagonal_is_free({.x = x + side_x, .y = y + side_y}, step_x - side_x,
                                  step_y - side_y);
}

void CellGrid::begin(const TravelCost& costs) {
  clear(costs);
  add_cells({.x = 0, .y = 0}, {.x = width() - 1, .y = height() - 1});
  mark_open();
}

void CellGrid::begin(const TravelCost& costs, std::span<const CellIndex> blocks) {
  clear(costs);
  for (const CellIndex& block : blocks) {
    add_cells({.x = 2 * (block.x - kReach), .y = 2 * (block.y - kReach)},
              {.x = 2 * (block.x + kReach) + 1, .y = 2 * (block.y + kReach) + 1});
  }
  mark_open();
}

void CellGrid::clear(const TravelCost& costs) {
  // The size may change: then all bytes are new, and 0.
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
      nodes_[static_cast<std::size_t>(i)] = byte_at(row[x]);
      indices_.push_back(i);
    }
  }
}

void CellGrid::mark_open() {
  if (!gentle_) return;
  for (const int i : indices_) {
    const std::uint8_t* n = nodes_.data() + i;
    bool all = true;
    for (std::size_t d = 0; d < 8; ++d)
      all = all && n[kStepY[d] * stride() + kStepX[d]] != 0;
    if (all) nodes_[static_cast<std::size_t>(i)] |= kOpen;
  }
}

void CellGrid::reset(std::uint32_t* so_far) {
  prepared_ = true;
  for (const int i : indices_)
    so_far[i] = kUnreached;
}

bool CellGrid::linked(CellIndex node, unsigned direction) const noexcept {
  return direction % 2 == 0 || costs_->diagonal_is_free(node, kStepX[direction], kStepY[direction]);
}

}  // namespace fairway
