// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "fairway/map/bit_grid.hpp"
#include "fairway/map/distance_field.hpp"
#include "fairway/path/grid_search.hpp"
#include "fairway/path/path.hpp"
#include "fairway/path/search_grid.hpp"
#include "fairway/path/straightening.hpp"

namespace fairway {

/// A path, or why there is none.
struct PathResult {
  PathStatus status = PathStatus::NoConnection;
  Path path;          ///< from the very start to the very goal; empty unless Found
  double cost = 0.0;  ///< of the chain of cells found, before straightening [m]
  int expanded = 0;   ///< nodes taken from the queue
};

/// Finds paths for a disc robot on one map after another, reusing its memory.
///
/// Every straight piece of a path keeps the robot's radius plus `settings.margin` from every
/// blocked cell, exactly (is_free holds for it). From a start nearer than that to an obstacle the
/// first piece leads out, and to such a goal the last piece leads in: these two keep the radius.
/// A path has at least two waypoints, the first is the start and the last is the goal, to the bit.
///
/// The search goes over blocks of 4 x 4 cells first and then over the cells along the way found; it
/// finds a way wherever neighbouring allowed cells (see TravelCost) connect the two, and one that
/// is nearly always the cheapest. Deterministic: the same map and query give the same bits.
class PathPlanner {
 public:
  /// `obstacles` and `distances` are of the same map and only read during the call.
  /// A radius or margin that is negative or not finite is answered by PathStatus::InvalidInput.
  [[nodiscard]] PathResult find(const BitGrid& obstacles,
                                const DistanceField& distances,
                                const Eigen::Vector2d& start,
                                const Eigen::Vector2d& goal,
                                double robot_radius,
                                const PathSettings& settings);

 private:
  // An end of the path, and the cells by which it joins the grid.
  struct End {
    Eigen::Vector2d point;  // grid coordinates
    bool tight = false;     // nearer to an obstacle than radius + margin
    std::vector<CellIndex> cells;
    std::vector<Terminal> blocks;
    std::vector<Terminal> terminals;  // the cells, with the cost of the way to them
  };

  void join_grid(const TravelCost& costs, double robot_radius, End& end);
  bool add_ring(const TravelCost& costs, double clearance, int ring, End& end);
  [[nodiscard]] bool search(const TravelCost& costs, PathResult& result);
  [[nodiscard]] Path straight_path(const TravelCost& costs, bool any_angle);

  End start_;
  End goal_;
  BlockGrid blocks_;
  CellGrid cells_;
  GridSearch search_;
  Straightening straightening_;
  std::vector<CellIndex> way_;
  std::vector<Eigen::Vector2d> points_;
};

}  // namespace fairway
