// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/map/bit_grid.hpp"
#include "fairway/map/distance_field.hpp"
#include "fairway/path/path.hpp"
#include "fairway/path/path_settings.hpp"

namespace fairway {

/// A path, or why there is none.
struct PathResult {
  PathStatus status = PathStatus::NoConnection;
  Path path;          ///< from the very start to the very goal; empty unless Found
  double cost = 0.0;  ///< what the grid search minimised [m], before straightening
  int expanded = 0;   ///< cells taken from the queue
};

/// Finds paths for a disc robot on one map after another, reusing its memory.
///
/// Every straight piece of a path keeps the robot's radius plus `settings.margin` from every
/// blocked cell, exactly (is_free holds for it). Start and goal keep at least the radius; from a
/// start nearer than the margin the path leads out first. Deterministic: the same map and query
/// give the same bits.
class PathPlanner {
 public:
  /// `obstacles` and `distances` are of the same map and only read during the call.
  [[nodiscard]] PathResult find(const BitGrid& obstacles,
                                const DistanceField& distances,
                                const Eigen::Vector2d& start,
                                const Eigen::Vector2d& goal,
                                double robot_radius,
                                const PathSettings& settings);

 private:
  // (search buffers)
};

}  // namespace fairway
