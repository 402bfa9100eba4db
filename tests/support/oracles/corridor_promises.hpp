// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "fairway/corridor/corridor.hpp"
#include "fairway/corridor/corridor_builder.hpp"
#include "fairway/map/free_space.hpp"
#include "fairway/path/path.hpp"
#include "support/oracles/geometry_oracle.hpp"

namespace fairway::test {

inline constexpr double kRounding = 1e-9;  // [m]; for a point on a side

inline Eigen::Vector2d point_at(const Path& path, double s) {
  for (std::size_t i = 1; i < path.waypoints.size(); ++i) {
    const Eigen::Vector2d way = path.waypoints[i] - path.waypoints[i - 1];
    if (s <= way.norm()) return path.waypoints[i - 1] + way.normalized() * s;
    s -= way.norm();
  }
  return path.waypoints.back();
}

// Checks the guarantees of build_corridor for a Built corridor.
inline void expect_a_sound_chain(const BitGrid& obstacles,
                                 const Path& path,
                                 const Corridor& corridor,
                                 const CorridorSettings& settings,
                                 bool look_at_every_cell) {
  const double clearance = corridor.space == CorridorSpace::Workspace ? 0.0 : corridor.robot_radius;
  ASSERT_FALSE(corridor.rectangles.empty());
  ASSERT_EQ(corridor.spans.size(), corridor.rectangles.size());
  const std::size_t n = corridor.rectangles.size();
  for (std::size_t i = 0; i < n; ++i) {
    const OrientedRectangle& r = corridor.rectangles[i];
    EXPECT_TRUE(is_free(obstacles, r, clearance));
    EXPECT_TRUE(r.contains(r.seed, kRounding));
    if (look_at_every_cell) {
      EXPECT_GT(test::clearance(obstacles, r), clearance);
    }
    const PathSpan& span = corridor.spans[i];
    ASSERT_LE(span.from, span.to);
    for (double s = span.from; s <= span.to; s += 0.02)
      EXPECT_TRUE(corridor.admissible(i).contains(point_at(path, s), kRounding));
    if (i == 0) continue;
    EXPECT_LE(span.from, corridor.spans[i - 1].to + kRounding);
    EXPECT_GT(span.to, corridor.spans[i - 1].to);
    const OverlapPatch patch = overlap(corridor.admissible(i - 1), corridor.admissible(i));
    EXPECT_GT(patch.count, 0);
    EXPECT_GE(patch.area(), settings.min_overlap_area);
  }
  EXPECT_TRUE(corridor.admissible(0).contains(path.waypoints.front(), kRounding));
  EXPECT_TRUE(corridor.admissible(n - 1).contains(path.waypoints.back(), kRounding));
  EXPECT_EQ(corridor.spans.front().from, 0.0);
  EXPECT_NEAR(corridor.spans.back().to, path.length(), kRounding);
}

}  // namespace fairway::test
