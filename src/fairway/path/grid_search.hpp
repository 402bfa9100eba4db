// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "fairway/path/search_grid.hpp"

namespace fairway {

/// A node where a search may begin or end. Its cost is that between the node and the true start or
/// goal, in the search's own unit (see GridSearch::kStep).
struct Terminal {
  CellIndex node;
  std::uint32_t cost = 0;
};

/// A* over the linked neighbours of a grid; it reuses its memory from one grid to the next.
class GridSearch {
 public:
  /// Cost of a straight step between nodes of cost 1. A diagonal step costs 82; 82 / 58 is 0.03 %
  /// below sqrt 2. A step costs the mean of its two nodes.
  static constexpr int kStep = 58;

  /// Finds a cheapest path from any of `starts` to any of `goals`.
  ///
  /// Returns false if there is no path, or if the best one is too long. The limit is about a
  /// million straight steps at the lowest cost. Terminals that are not nodes are ignored.
  /// @pre `begin` of the grid was called; the terminals' costs are below 2^28.
  [[nodiscard]] bool find(BlockGrid& grid,
                          std::span<const Terminal> starts,
                          std::span<const Terminal> goals);
  [[nodiscard]] bool find(CellGrid& grid,
                          std::span<const Terminal> starts,
                          std::span<const Terminal> goals);

  /// The nodes of the path found, from start to goal.
  [[nodiscard]] std::span<const CellIndex> nodes() const noexcept { return nodes_; }
  /// Cost of the path found, those of its terminals included.
  [[nodiscard]] std::uint32_t cost() const noexcept { return best_; }
  [[nodiscard]] int expanded() const noexcept { return expanded_; }  ///< nodes taken from the queue

 private:
  template <typename Grid>
  bool find_on(Grid& grid, std::span<const Terminal> starts, std::span<const Terminal> goals);
  template <typename Grid>
  [[nodiscard]] bool is_pocket(Grid& grid,
                               std::span<const Terminal> starts,
                               std::span<const Terminal> goals);
  template <typename Grid>
  void run(Grid& grid, std::span<const Terminal> goals);
  void collect_nodes(const SearchGrid& grid);

  // A ring of buckets, each for nearly equal estimated total costs. No entry lies a full turn
  // ahead.
  static constexpr unsigned kBucketShift = 7;
  static constexpr std::uint32_t kBuckets = 256;

  std::array<std::vector<std::uint32_t>, kBuckets> buckets_;
  std::uint32_t lowest_ = 0;  // least estimated total cost of a start
  std::size_t queued_ = 0;
  std::uint32_t best_ = 0;
  CellIndex best_goal_;
  int expanded_ = 0;
  std::vector<std::uint32_t> so_far_;   // cost from the start, by index
  std::vector<std::uint8_t> arrivals_;  // direction of the last step, by index
  std::vector<std::uint32_t> flood_;
  std::vector<CellIndex> nodes_;
};

}  // namespace fairway
