// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "fairway/path/path_planner.hpp"

namespace fairway::test {

/// A prepared map for planning; every `find` uses a new planner.
struct PathWorld {
  explicit PathWorld(BitGrid grid) : obstacles(std::move(grid)), distances(obstacles) {}

  [[nodiscard]] PathResult find(const Eigen::Vector2d& start,
                                const Eigen::Vector2d& goal,
                                double radius,
                                const PathSettings& settings = {}) const {
    PathPlanner planner;
    return planner.find(obstacles, distances, start, goal, radius, settings);
  }

  BitGrid obstacles;
  DistanceField distances;
};

}  // namespace fairway::test
