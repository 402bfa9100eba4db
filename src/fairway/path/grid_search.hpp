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

  [[nodiscard]] bool operator==(const Terminal&) const noexcept = default;
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

  /// Finds the same path as `find`. From the same starts it continues the last search, so that
  /// further goals cost little.
  /// @pre this was the last search on `grid`, and its nodes have not changed since.
  [[nodiscard]] bool find_further(BlockGrid& grid,
                                  std::span<const Terminal> starts,
                                  std::span<const Terminal> goals);

  /// The nodes of the path found, from start to goal.
  [[nodiscard]] std::span<const CellIndex> nodes() const noexcept { return nodes_; }
  /// Cost of the path found, those of its terminals included.
  [[nodiscard]] std::uint32_t cost() const noexcept { return best_; }
  /// Nodes taken from the queue in the last call.
  [[nodiscard]] int expanded() const noexcept { return expanded_; }

 private:
  template <typename Grid>
  bool find_on(Grid& grid,
               std::span<const Terminal> starts,
               std::span<const Terminal> goals,
               bool further);
  template <typename Grid>
  void enqueue_starts(const Grid& grid, std::span<const Terminal> goals);
  template <typename Grid>
  void enqueue_again(const Grid& grid, std::span<const Terminal> goals);
  void enqueue(CellIndex node, std::uint32_t total);
  [[nodiscard]] Terminal cheapest_goal(const SearchGrid& grid,
                                       std::span<const Terminal> goals) const noexcept;
  template <typename Grid>
  [[nodiscard]] bool is_pocket(Grid& grid, std::span<const Terminal> goals);
  template <typename Grid>
  void run(Grid& grid, std::span<const Terminal> goals);
  void collect_nodes(const CellGrid& grid, CellIndex node);
  void collect_nodes(const BlockGrid& grid, CellIndex node);

  // Half of the cost of a step, per unit of cost of either of its nodes.
  static constexpr std::array<std::uint32_t, 8> kHalfStep{29, 41, 29, 41, 29, 41, 29, 41};
  // Visited by the flood fill, and not reached by a search.
  static constexpr std::uint32_t kFlooded = kUnreached - 1;
  static constexpr std::uint32_t kTooFar = kUnreached / 2;  // sums of costs below cannot overflow
  static constexpr std::uint8_t kStart = 8;    // marks the start, which has no previous node
  static constexpr std::uint8_t kClosed = 16;  // expanded since its cost was last reduced

  // A ring of buckets, each for nearly equal estimated total costs. No entry lies a full turn
  // ahead.
  static constexpr unsigned kBucketShift = 7;
  static constexpr std::uint32_t kBuckets = 256;

  std::array<std::vector<std::uint32_t>, kBuckets> buckets_;
  std::uint32_t lowest_ = 0;  // least estimated total cost of a start
  std::size_t queued_ = 0;
  std::uint32_t best_ = 0;
  std::vector<Terminal> starts_;  // of the last search
  int expanded_ = 0;
  std::vector<std::uint32_t> so_far_;   // cost from the start, by index
  std::vector<std::uint8_t> arrivals_;  // direction of the last step, by index
  std::vector<std::uint32_t> flood_;
  std::vector<std::uint32_t> open_;  // nodes in the queue
  std::vector<CellIndex> nodes_;
};

}  // namespace fairway
