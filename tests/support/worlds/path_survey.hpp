// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "fairway/path/path_planner.hpp"
#include "support/oracles/path_oracle.hpp"
#include "support/random/random_world.hpp"
#include "support/worlds/path_check.hpp"

namespace fairway::test {

/// Checks paths between random points of a large map. Each path keeps its clearance, and there is
/// one wherever neighbouring cells connect the two points.
inline void expect_paths_where_cells_connect(const BitGrid& obstacles) {
  const DistanceField distances(obstacles);
  const GridFrame& frame = obstacles.frame();
  Random random(51);
  PathPlanner planner;
  const PathSettings settings;
  const double radius = 0.25;
  int found = 0;
  int asked = 0;
  while (asked < 40) {
    const auto point = [&] {
      return frame.to_world({random.uniform(0, frame.width), random.uniform(0, frame.height)});
    };
    const Eigen::Vector2d start = point();
    const Eigen::Vector2d goal = point();
    const double required = radius + settings.margin;
    const Eigen::Vector2d a = frame.center(frame.cell_at(start));
    const Eigen::Vector2d b = frame.center(frame.cell_at(goal));
    if (!is_free(obstacles, start, a, required) || !is_free(obstacles, goal, b, required)) continue;
    ++asked;
    const PathResult result = planner.find(obstacles, distances, start, goal, radius, settings);
    if (result.status == PathStatus::Found) {
      ++found;
      expect_sound(obstacles, result, start, goal, radius, settings.margin);
    } else if (asked <= 10) {
      EXPECT_FALSE(is_connected(obstacles, required, frame.cell_at(start), frame.cell_at(goal)));
    }
  }
  EXPECT_GT(found, 5);
}

}  // namespace fairway::test
