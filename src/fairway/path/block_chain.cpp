// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/block_chain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/path/search_grid.hpp"

namespace fairway {

namespace {

constexpr float kUnconnected = std::numeric_limits<float>::infinity();
constexpr std::int32_t kNone = -1;

}  // namespace

bool BlockChain::find(const TravelCost& costs,
                      std::span<const CellIndex> blocks,
                      std::span<const Terminal> starts,
                      std::span<const Terminal> goals) {
  constexpr int kAttempts = 6;
  candidates_.clear();
  layers_.clear();
  forbidden_.clear();
  step_ = GridSearch::kStep * SearchGrid::unit_for(costs);
  add_ends(costs, blocks.front(), starts);
  // The first and the last block have the terminals.
  for (std::size_t i = 1; i + 1 < blocks.size(); ++i)
    add_block(costs, blocks[i]);
  add_ends(costs, blocks.back(), goals);
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    connect();
    if (!choose()) return false;
    if (all_lines_fit(costs)) return true;
  }
  return false;
}

// Adds the terminals of a block, with the cost between each and the true start or goal.
void BlockChain::add_ends(const TravelCost& costs,
                          CellIndex block,
                          std::span<const Terminal> ends) {
  layers_.push_back(candidates_.size());
  for (const Terminal& end : ends) {
    if (BlockGrid::block_of(end.node) != block) continue;
    const auto distance = static_cast<float>(costs.distances().at(end.node));
    candidates_.push_back({.x = static_cast<float>(end.node.x) + 0.5F,
                           .y = static_cast<float>(end.node.y) + 0.5F,
                           .cost = costs.at_cell(end.node, distance),
                           .at_end = static_cast<float>(end.cost / step_)});
  }
}

// Adds the cell with the least cost of each quarter; of equal ones the one nearest to the middle of
// the block.
void BlockChain::add_block(const TravelCost& costs, CellIndex block) {
  constexpr int kHalf = BlockGrid::kSide / 2;
  const GridFrame& frame = costs.frame();
  const float least = costs.least_distance();
  const float* const cells = costs.distances().cells().data();
  layers_.push_back(candidates_.size());
  for (int quarter = 0; quarter < 4; ++quarter) {
    const bool right = quarter % 2 == 1;
    const bool upper = quarter / 2 == 1;
    Candidate best{.cost = kUnconnected};
    for (int i = 0; i < kHalf * kHalf; ++i) {
      // Outwards from the middle.
      const int dx = i % kHalf;
      const int dy = i / kHalf;
      const CellIndex cell{.x = BlockGrid::kSide * block.x + (right ? kHalf + dx : kHalf - 1 - dx),
                           .y = BlockGrid::kSide * block.y + (upper ? kHalf + dy : kHalf - 1 - dy)};
      if (!frame.contains(cell)) continue;
      const float distance = cells[static_cast<std::ptrdiff_t>(cell.y) * frame.width + cell.x];
      if (distance < least) continue;
      const float cost = costs.at_cell(cell, distance);
      if (cost >= best.cost) continue;
      best.cost = cost;
      best.x = static_cast<float>(cell.x) + 0.5F;
      best.y = static_cast<float>(cell.y) + 0.5F;
    }
    if (best.cost < kUnconnected) candidates_.push_back(best);
  }
}

// Finds the cheapest predecessor of every candidate, layer by layer.
void BlockChain::connect() noexcept {
  for (std::size_t j = 0; j < layers_[1]; ++j)
    candidates_[j].so_far = candidates_[j].at_end;
  for (std::size_t layer = 1; layer < layers_.size(); ++layer) {
    const std::size_t end = layer + 1 < layers_.size() ? layers_[layer + 1] : candidates_.size();
    for (std::size_t j = layers_[layer]; j < end; ++j) {
      Candidate& here = candidates_[j];
      here.so_far = kUnconnected;
      here.before = kNone;
      for (std::size_t i = layers_[layer - 1]; i < layers_[layer]; ++i) {
        const Candidate& before = candidates_[i];
        const float dx = here.x - before.x;
        const float dy = here.y - before.y;
        const float cost =
            before.so_far + 0.5F * (before.cost + here.cost) * std::sqrt(dx * dx + dy * dy);
        if (cost >= here.so_far || (here.has_forbidden && is_forbidden(i, j))) continue;
        here.so_far = cost;
        here.before = static_cast<std::int32_t>(i);
      }
    }
  }
}

bool BlockChain::is_forbidden(std::size_t from, std::size_t to) const noexcept {
  return std::any_of(forbidden_.begin(), forbidden_.end(),
                     [&](const Line& line) { return line.from == from && line.to == to; });
}

// Chooses the cheapest goal and its predecessors. Returns false if no goal is connected.
bool BlockChain::choose() {
  std::int32_t at = kNone;
  float least = kUnconnected;
  for (std::size_t j = layers_.back(); j < candidates_.size(); ++j) {
    const float cost = candidates_[j].so_far + candidates_[j].at_end;
    if (cost >= least) continue;
    least = cost;
    at = static_cast<std::int32_t>(j);
  }
  chosen_.clear();
  for (; at != kNone; at = candidates_[chosen_.back()].before)
    chosen_.push_back(static_cast<std::size_t>(at));
  std::reverse(chosen_.begin(), chosen_.end());
  return !chosen_.empty();
}

// Collects the points and their cost, and forbids lines on which the robot does not fit.
bool BlockChain::all_lines_fit(const TravelCost& costs) {
  const auto end_cost = [&](std::size_t i) { return static_cast<double>(candidates_[i].at_end); };
  points_.clear();
  cost_ = end_cost(chosen_.front()) + end_cost(chosen_.back());
  bool fit = true;
  for (std::size_t k = 0; k < chosen_.size(); ++k) {
    Candidate& here = candidates_[chosen_[k]];
    const Eigen::Vector2d point(static_cast<double>(here.x), static_cast<double>(here.y));
    if (k > 0) {
      if (point == points_.back()) continue;
      const TravelCost::Line line = costs.line(points_.back(), point);
      cost_ += line.cost;
      if (!line.surely_free && !costs.fits(points_.back(), point)) {
        forbidden_.push_back({.from = chosen_[k - 1], .to = chosen_[k]});
        here.has_forbidden = true;
        fit = false;
      }
    }
    points_.push_back(point);
  }
  return fit;
}

}  // namespace fairway
