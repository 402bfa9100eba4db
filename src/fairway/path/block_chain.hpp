// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "fairway/path/grid_search.hpp"
#include "fairway/path/travel_cost.hpp"

namespace fairway {

/// Turns a path of blocks into a chain of points that the robot can follow in straight lines.
///
/// Every block offers the best cell of each of its quarters. The chain passes through one of them
/// per block, so that the sum of its lengths times the mean cost at both ends is the least. A line
/// on which the robot does not fit is forbidden, and the chain is found again.
class BlockChain {
 public:
  /// Finds the chain from one of `starts` to one of `goals`, cells with the cost of reaching each.
  /// @pre the first of the blocks has a start, the last one a goal.
  /// @return Whether there is a chain on which every line fits, after a few attempts.
  [[nodiscard]] bool find(const TravelCost& costs,
                          std::span<const CellIndex> blocks,
                          std::span<const Terminal> starts,
                          std::span<const Terminal> goals);

  /// The centres of the cells, in grid coordinates.
  [[nodiscard]] std::span<const Eigen::Vector2d> points() const noexcept { return points_; }
  /// Cost of the lines, those between the cells and the true start and goal included [cells].
  [[nodiscard]] double cost() const noexcept { return cost_; }

 private:
  struct Candidate {
    float x = 0.0F;  // of the centre, in grid coordinates
    float y = 0.0F;
    float cost = 0.0F;    // of a metre
    float at_end = 0.0F;  // cost between a terminal and the true start or goal [cells]
    float so_far = 0.0F;  // least cost from the start [cells]
    std::int32_t before = -1;
    bool has_forbidden = false;  // whether a line to it is forbidden
  };
  struct Line {
    std::size_t from;
    std::size_t to;
  };

  void add_ends(const TravelCost& costs, CellIndex block, std::span<const Terminal> ends);
  void add_block(const TravelCost& costs, CellIndex block);
  void connect() noexcept;
  [[nodiscard]] bool is_forbidden(std::size_t from, std::size_t to) const noexcept;
  [[nodiscard]] bool choose();
  [[nodiscard]] bool all_lines_fit(const TravelCost& costs);

  std::vector<Candidate> candidates_;  // of all blocks, in the order of the path
  std::vector<std::size_t> layers_;    // first candidate of every block
  std::vector<Line> forbidden_;
  std::vector<std::size_t> chosen_;  // candidates of the chain
  std::vector<Eigen::Vector2d> points_;
  double step_ = 1.0;  // unit of the costs of terminals, per cell
  double cost_ = 0.0;
};

}  // namespace fairway
