// SPDX-License-Identifier: Apache-2.0
// The path of a search, after it has ended.
#include <algorithm>

#include "fairway/path/grid_search.hpp"

namespace fairway {

// Returns the cheapest goal that was expanded, with the cost of the path to it; of equal ones the
// first.
Terminal GridSearch::cheapest_goal(const SearchGrid& grid,
                                   std::span<const Terminal> goals) const noexcept {
  Terminal cheapest{.node = {}, .cost = kUnreached};
  for (const Terminal& goal : goals) {
    const auto i = static_cast<std::size_t>(grid.index(goal.node));
    if (grid.nodes()[i] == 0 || so_far_[i] >= kTooFar || (arrivals_[i] & kClosed) == 0) continue;
    if (so_far_[i] + goal.cost >= cheapest.cost) continue;
    cheapest = {.node = goal.node, .cost = so_far_[i] + goal.cost};
  }
  return cheapest;
}

// Goes back from the goal along the arrivals.
void GridSearch::collect_nodes(const CellGrid& grid, CellIndex node) {
  while (true) {
    nodes_.push_back(node);
    const std::size_t arrival =
        arrivals_[static_cast<std::size_t>(grid.index(node))] & ~unsigned{kClosed};
    if (arrival == kStart) break;
    node = {.x = node.x - kStepX[arrival], .y = node.y - kStepY[arrival]};
  }
  std::reverse(nodes_.begin(), nodes_.end());
}

// Goes back from the goal along steps that cost exactly the difference between their nodes. The
// arrivals depend on which of two equally cheap paths was found first, and so on earlier searches.
// The costs do not, because all nodes of all cheapest paths have been expanded.
void GridSearch::collect_nodes(const BlockGrid& grid, CellIndex node) {
  // Turns first, so that straight and diagonal steps alternate: this is nearer to a straight line.
  constexpr std::array<unsigned, 8> kTurns{1, 7, 0, 2, 6, 3, 5, 4};
  const std::uint8_t* const nodes = grid.nodes();
  const auto is_start = [&] {
    const Terminal here{.node = node, .cost = so_far_[static_cast<std::size_t>(grid.index(node))]};
    return std::find(starts_.begin(), starts_.end(), here) != starts_.end();
  };
  unsigned last = 0;  // direction of the step that was collected last
  nodes_.push_back(node);
  while (!is_start()) {
    const int index = grid.index(node);
    const std::uint32_t cost_here = nodes[index] & SearchGrid::kCost;
    const auto leads_here = [&](unsigned turn) {
      const unsigned direction = (last + turn) % 8;
      const CellIndex before{.x = node.x - kStepX[direction], .y = node.y - kStepY[direction]};
      const auto i = static_cast<std::size_t>(grid.index(before));
      const std::uint32_t step =
          kHalfStep[direction] * ((nodes[i] & SearchGrid::kCost) + cost_here);
      return nodes[i] != 0 && so_far_[i] < kTooFar &&
             so_far_[i] + step == so_far_[static_cast<std::size_t>(index)] &&
             grid.linked(before, direction);
    };
    const auto* const turn = std::find_if(kTurns.begin(), kTurns.end(), leads_here);
    if (turn == kTurns.end()) break;  // never: every node reached has a node before it
    last = (last + *turn) % 8;
    node = {.x = node.x - kStepX[last], .y = node.y - kStepY[last]};
    nodes_.push_back(node);
  }
  std::reverse(nodes_.begin(), nodes_.end());
}

}  // namespace fairway
