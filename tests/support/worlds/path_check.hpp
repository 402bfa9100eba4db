// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "fairway/map/free_space.hpp"
#include "fairway/path/path_planner.hpp"

namespace fairway::test {

/// Checks all guarantees of PathPlanner for a path that was found.
inline void expect_sound(const BitGrid& obstacles,
                         const PathResult& result,
                         const Eigen::Vector2d& start,
                         const Eigen::Vector2d& goal,
                         double robot_radius,
                         double margin) {
  ASSERT_EQ(result.status, PathStatus::Found);
  const auto& w = result.path.waypoints;
  ASSERT_GE(w.size(), 2U);
  EXPECT_EQ(w.front(), start);
  EXPECT_EQ(w.back(), goal);
  const double required = robot_radius + margin;
  const bool tight_start = !is_free(obstacles, start, start, required);
  const bool tight_goal = !is_free(obstacles, goal, goal, required);
  for (std::size_t i = 1; i < w.size(); ++i) {
    EXPECT_TRUE(is_free(obstacles, w[i - 1], w[i], robot_radius)) << "piece " << i;
    if ((i == 1 && tight_start) || (i + 1 == w.size() && tight_goal)) continue;
    EXPECT_TRUE(is_free(obstacles, w[i - 1], w[i], required)) << "piece " << i;
  }
}

}  // namespace fairway::test
