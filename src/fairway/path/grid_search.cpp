// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/grid_search.hpp"

#include <algorithm>

namespace fairway {

namespace {

constexpr std::uint32_t kDiagonalExtra = 82 - GridSearch::kStep;

constexpr std::uint32_t pack(int x, int y) {
  return static_cast<std::uint32_t>(y) << 16U | static_cast<std::uint32_t>(x);
}
constexpr CellIndex unpack(std::uint32_t packed) {
  return {.x = static_cast<int>(packed & 0xFFFFU), .y = static_cast<int>(packed >> 16U)};
}

// Estimates the remaining cost: the octile distance to the bounding box of the goals at the lowest
// cost per step. The estimate is consistent: it changes by at most the cost of a step.
struct Estimate {
  CellIndex min;
  CellIndex max;
  std::uint32_t unit;

  Estimate(std::span<const Terminal> goals, int lowest_cost)
      : min(goals[0].node),
        max(goals[0].node),
        unit(static_cast<std::uint32_t>(lowest_cost)) {
    for (const Terminal& goal : goals) {
      min = {.x = std::min(min.x, goal.node.x), .y = std::min(min.y, goal.node.y)};
      max = {.x = std::max(max.x, goal.node.x), .y = std::max(max.y, goal.node.y)};
    }
  }

  [[nodiscard]] std::uint32_t operator()(int x, int y) const noexcept {
    const auto dx = static_cast<std::uint32_t>(std::max({min.x - x, x - max.x, 0}));
    const auto dy = static_cast<std::uint32_t>(std::max({min.y - y, y - max.y, 0}));
    return unit * (GridSearch::kStep * std::max(dx, dy) + kDiagonalExtra * std::min(dx, dy));
  }
};

}  // namespace

bool GridSearch::find(BlockGrid& grid,
                      std::span<const Terminal> starts,
                      std::span<const Terminal> goals) {
  return find_on(grid, starts, goals, false);
}

bool GridSearch::find(CellGrid& grid,
                      std::span<const Terminal> starts,
                      std::span<const Terminal> goals) {
  return find_on(grid, starts, goals, false);
}

bool GridSearch::find_further(BlockGrid& grid,
                              std::span<const Terminal> starts,
                              std::span<const Terminal> goals) {
  return find_on(grid, starts, goals, true);
}

template <typename Grid>
bool GridSearch::find_on(Grid& grid,
                         std::span<const Terminal> starts,
                         std::span<const Terminal> goals,
                         bool further) {
  best_ = kUnreached;
  expanded_ = 0;
  nodes_.clear();
  const bool again =
      further && std::equal(starts.begin(), starts.end(), starts_.begin(), starts_.end());
  if (!again) {
    starts_.clear();
    for (std::vector<std::uint32_t>& bucket : buckets_)
      bucket.clear();
    queued_ = 0;
    grid.restart();
  }
  if (starts.empty() || goals.empty()) return false;
  const auto size =
      static_cast<std::size_t>(grid.stride()) * (static_cast<std::size_t>(grid.height()) + 2);
  if (so_far_.size() < size) {
    so_far_.resize(size);
    arrivals_.resize(size);
  }
  for (const auto& terminals : {starts, goals}) {
    for (const Terminal& terminal : terminals)
      grid.prepare_rows(terminal.node.y - 1, terminal.node.y + 1, so_far_.data());
  }
  if (again) {
    enqueue_again(grid, goals);
  } else {
    starts_.assign(starts.begin(), starts.end());
    enqueue_starts(grid, goals);
  }
  run(grid, goals);
  if (best_ == kUnreached) return false;
  collect_nodes(grid, cheapest_goal(grid, goals).node);
  return true;
}

template <typename Grid>
void GridSearch::enqueue_starts(const Grid& grid, std::span<const Terminal> goals) {
  const Estimate estimate(goals, grid.unit());
  lowest_ = kUnreached;
  for (const Terminal& start : starts_)
    lowest_ = std::min(lowest_, start.cost + estimate(start.node.x, start.node.y));
  for (const Terminal& start : starts_) {
    const auto i = static_cast<std::size_t>(grid.index(start.node));
    if (grid.nodes()[i] == 0 || start.cost >= so_far_[i]) continue;
    so_far_[i] = start.cost;
    arrivals_[i] = kStart;
    enqueue(start.node, start.cost + estimate(start.node.x, start.node.y));
  }
}

// Orders the nodes that the last search left in the queue by the estimates for other goals.
template <typename Grid>
void GridSearch::enqueue_again(const Grid& grid, std::span<const Terminal> goals) {
  const Estimate estimate(goals, grid.unit());
  open_.clear();
  for (std::vector<std::uint32_t>& bucket : buckets_) {
    for (const std::uint32_t packed : bucket) {
      const auto i = static_cast<std::size_t>(grid.index(unpack(packed)));
      if ((arrivals_[i] & kClosed) == 0) open_.push_back(packed);
    }
    bucket.clear();
  }
  queued_ = 0;
  const auto total = [&](CellIndex node) {
    return so_far_[static_cast<std::size_t>(grid.index(node))] + estimate(node.x, node.y);
  };
  lowest_ = kUnreached;
  for (const std::uint32_t packed : open_)
    lowest_ = std::min(lowest_, total(unpack(packed)));
  for (const std::uint32_t packed : open_)
    enqueue(unpack(packed), total(unpack(packed)));
}

// Nodes may be spread further than the ring is long; those are put in again when their turn comes.
void GridSearch::enqueue(CellIndex node, std::uint32_t total) {
  const std::uint32_t bucket =
      std::min(total >> kBucketShift, (lowest_ >> kBucketShift) + kBuckets - 1);
  buckets_[bucket % kBuckets].push_back(pack(node.x, node.y));
  ++queued_;
}

// Returns whether the goals lie in a small pocket that the search has not reached. Most failed
// searches fail for this reason; the test finds it before the rest of the map is searched.
template <typename Grid>
bool GridSearch::is_pocket(Grid& grid, std::span<const Terminal> goals) {
  constexpr std::size_t kBudget = 2048;
  flood_.clear();
  bool reached = false;
  const auto visit = [&](CellIndex node) {
    const auto i = static_cast<std::size_t>(grid.index(node));
    if (grid.nodes()[i] == 0 || so_far_[i] == kFlooded) return;
    reached = reached || so_far_[i] != kUnreached;
    if (reached) return;
    so_far_[i] = kFlooded;
    flood_.push_back(pack(node.x, node.y));
  };
  for (const Terminal& goal : goals)
    visit(goal.node);
  for (std::size_t i = 0; i < std::min(flood_.size(), kBudget) && !reached; ++i) {
    const CellIndex node = unpack(flood_[i]);
    grid.prepare_rows(node.y - 1, node.y + 1, so_far_.data());
    for (unsigned d = 0; d < 8; ++d) {
      const CellIndex next{.x = node.x + kStepX[d], .y = node.y + kStepY[d]};
      // From the neighbour to here: zones may allow one direction only.
      if (grid.nodes()[grid.index(next)] != 0 && grid.linked(next, (d + 4) % 8)) visit(next);
    }
  }
  for (const std::uint32_t packed : flood_)
    so_far_[static_cast<std::size_t>(grid.index(unpack(packed)))] = kUnreached;
  return flood_.size() <= kBudget && !reached;
}

// At an open node x, the search skips steps that cannot be on a cheapest path. Let p be the node
// before x and c the cost of a node; straight steps cost 29 (c + c'), diagonal ones 41 (c + c'),
// and all nine costs are between m and M with 58 M < 106 m. The skipped steps are:
// - back to p and to the neighbours of p on its side of x: p reaches them directly for less;
// - after a straight step, to the sides: p reaches those nodes n diagonally, and 41 (c_p + c_n) <
//   29 (c_p + 2 c_x + c_n), since 24 M < 58 m;
// - after a diagonal step, to the sides: over the node y beside p and n the cost is less, since 29
//   (c_p + 2 c_y + c_n) < 41 (c_p + 2 c_x + c_n) when 58 M < 106 m. Each skipped step is strictly
//   more expensive, so no tie is decided here and the cost found is the least on the grid.
template <typename Grid>
void GridSearch::run(Grid& grid, std::span<const Terminal> goals) {
  // Local copies, because a store to a byte may alias every member.
  const Estimate estimate(goals, grid.unit());
  const std::uint8_t* const nodes = grid.nodes();
  std::uint32_t* const so_far = so_far_.data();
  std::uint8_t* const arrivals = arrivals_.data();
  const int stride = grid.stride();
  std::array<int, 8> offsets{};
  for (std::size_t d = 0; d < 8; ++d)
    offsets[d] = kStepY[d] * stride + kStepX[d];
  constexpr int kPocketAfter = 1000;  // expansions that cost about as much as the test
  std::size_t queued = queued_;
  int expanded = 0;
  // Goals that an earlier search reached.
  std::uint32_t best = cheapest_goal(grid, goals).cost;
  for (std::uint32_t turn = lowest_ >> kBucketShift; queued > 0; ++turn) {
    // Every node whose estimate equals the best cost is expanded, too: see collect_nodes.
    if (turn << kBucketShift > best || turn << kBucketShift >= kTooFar) break;
    std::vector<std::uint32_t>& bucket = buckets_[turn % kBuckets];
    while (!bucket.empty()) {
      const CellIndex node = unpack(bucket.back());
      bucket.pop_back();
      --queued;
      const int index = (node.y + 1) * stride + node.x + 1;
      const unsigned arrival = arrivals[index];
      if ((arrival & kClosed) != 0) continue;
      const std::uint32_t here = so_far[index];
      const std::uint32_t left = estimate(node.x, node.y);
      if (const std::uint32_t due = (here + left) >> kBucketShift; due > turn) {
        buckets_[std::min(due, turn + kBuckets - 1) % kBuckets].push_back(pack(node.x, node.y));
        ++queued;
        continue;
      }
      if (expanded == kPocketAfter && best == kUnreached && is_pocket(grid, goals)) {
        bucket.push_back(pack(node.x, node.y));
        queued_ = queued + 1;
        expanded_ = expanded;
        return;
      }
      arrivals[index] = static_cast<std::uint8_t>(arrival | kClosed);
      ++expanded;
      if (left == 0) {
        for (const Terminal& goal : goals) {
          if (goal.node == node) best = std::min(best, here + goal.cost);
        }
      }
      grid.prepare_rows(node.y - 1, node.y + 1, so_far);
      const std::uint32_t cost_here = nodes[index] & SearchGrid::kCost;
      const bool open = (nodes[index] & SearchGrid::kOpen) != 0;
      const auto relax = [&](unsigned direction) {
        const int next = index + offsets[direction];
        const std::uint32_t byte = nodes[next];
        const std::uint32_t cost =
            here + kHalfStep[direction] * (cost_here + (byte & SearchGrid::kCost));
        if (cost >= so_far[next] || byte == 0) return;
        if (!open && !grid.linked(node, direction)) return;
        so_far[next] = cost;
        arrivals[next] = static_cast<std::uint8_t>(direction);
        const int x = node.x + kStepX[direction];
        const int y = node.y + kStepY[direction];
        buckets_[(cost + estimate(x, y)) >> kBucketShift & (kBuckets - 1)].push_back(pack(x, y));
        ++queued;
      };
      if (open && arrival != kStart) {
        relax(arrival);
        relax((arrival + 1) % 8);
        relax((arrival + 7) % 8);
      } else {
        for (unsigned d = 0; d < 8; ++d)
          relax(d);
      }
    }
  }
  queued_ = queued;
  best_ = best;
  expanded_ = expanded;
}

}  // namespace fairway
