// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fairway/map/bit_grid.hpp"
#include "fairway/map/distance_field.hpp"
#include "fairway/path/block_chain.hpp"
#include "fairway/path/grid_search.hpp"
#include "fairway/path/path.hpp"
#include "fairway/path/search_grid.hpp"
#include "fairway/path/straightening.hpp"

namespace fairway {

/// A path, or the reason why there is none.
struct PathResult {
  PathStatus status = PathStatus::NoConnection;
  Path path;          ///< from the exact start to the exact goal; empty unless Found
  double cost = 0.0;  ///< cost of the chain of points found, before straightening [m]
  int expanded = 0;   ///< number of nodes taken from the queue
};

/// Finds paths for a disc robot, on one map after another, and reuses its memory.
///
/// Every straight piece of a path keeps the robot's radius plus `settings.margin` from every
/// blocked cell. This is exact: is_free holds for it. If the start or the goal is closer to an
/// obstacle than that, the first or the last piece keeps only the radius. A path has at least two
/// waypoints: the first equals the start and the last equals the goal, to the bit.
///
/// The search first covers blocks of 4 x 4 cells, and then passes through the best cells of the
/// blocks found. Where that does not fit or costs more than expected, it searches all cells along
/// the blocks. It finds a path wherever neighbouring allowed cells (see TravelCost) connect start
/// and goal; that path is nearly always a cheapest one. Where there is none, it also tries points
/// between the centres of cells: the middle of a gap that is an even number of cells wide lies
/// there. The planner is deterministic: the same map and query give the same bits.
///
/// On the map of the last call it uses what it knows of it, and from the same start it continues
/// that search: further goals cost little, and give the same paths.
class PathPlanner {
 public:
  /// Finds a path from `start` to `goal` [m, world] for a disc of `robot_radius` [m].
  ///
  /// `obstacles` and `distances` describe the same map and are only read during the call. A radius
  /// or a margin that is negative or not finite gives PathStatus::InvalidInput.
  [[nodiscard]] PathResult find(const BitGrid& obstacles,
                                const DistanceField& distances,
                                const Eigen::Vector2d& start,
                                const Eigen::Vector2d& goal,
                                double robot_radius,
                                const PathSettings& settings);

 private:
  // An end of the path, and the cells that connect it to the grid.
  struct End {
    Eigen::Vector2d point;  // grid coordinates
    bool is_goal = false;   // the path leads to it, and not away from it
    bool tight = false;     // closer to an obstacle than radius + margin
    std::vector<CellIndex> cells;
    std::vector<Terminal> blocks;
    std::vector<Terminal> terminals;  // the cells, with the cost of reaching each
  };

  void join_grid(const TravelCost& costs, double robot_radius, End& end);
  bool add_ring(const TravelCost& costs, double clearance, int ring, End& end);
  [[nodiscard]] bool search(const TravelCost& costs, bool any_angle, PathResult& result);
  [[nodiscard]] bool chain_is_good(const TravelCost& costs, std::span<const CellIndex> blocks);
  [[nodiscard]] bool search_between_centres(const TravelCost& costs,
                                            const PathSettings& settings,
                                            double robot_radius,
                                            PathResult& result);
  [[nodiscard]] static bool may_join(const TravelCost& costs,
                                     const End& end,
                                     const Eigen::Vector2d& point);
  [[nodiscard]] bool fits_along(const TravelCost& costs, double robot_radius) const noexcept;
  void take_centres();
  [[nodiscard]] Path straight_path(const TravelCost& costs, bool any_angle);

  End start_;
  End goal_;
  BlockGrid blocks_;
  CellGrid cells_;
  GridSearch block_search_;
  GridSearch search_;  // over cells
  BlockChain chain_;
  Straightening straightening_;
  std::vector<Eigen::Vector2d> points_;  // of the path that was found, without its ends
};

}  // namespace fairway
