// SPDX-License-Identifier: Apache-2.0
#include "fairway/map/footprint_clearance.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "fairway/map/free_space.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

// The least distance between the sampled outline of the footprint and all sampled blocked cells.
double slow_clearance(const BitGrid& obstacles, const Footprint& footprint, const Pose2& pose) {
  double least = std::numeric_limits<double>::infinity();
  const GridFrame& frame = obstacles.frame();
  for (int y = -1; y <= frame.height; ++y) {
    for (int x = -1; x <= frame.width; ++x) {
      if (!obstacles.blocked({x, y})) continue;
      for (int i = 0; i <= 10; ++i) {
        for (int j = 0; j <= 10; ++j) {
          const Vector2d point = frame.to_world({x + i / 10.0, y + j / 10.0});
          least = std::min(least, footprint.distance(inverse_transform(pose, point)));
        }
      }
    }
  }
  return least;
}

TEST(FootprintClearance, AgreesWithATestOfEveryCell) {
  test::Random random(1);
  int touching = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const BitGrid obstacles(test::random_world(random, 48));
    const GridFrame& frame = obstacles.frame();
    const double size = 4.0 * frame.resolution;
    const Footprint::Disc discs[2] = {{.center = {size, 0}, .radius = size},
                                      {.center = {-size, 0.2 * size}, .radius = 0.7 * size}};
    const Footprint footprint = random.chance(0.5)
                                    ? Footprint::rectangle(3 * size, size, {0.3 * size, 0})
                                    : Footprint::discs(discs, 2);
    const Pose2 pose{.position = frame.to_world(
                         {random.uniform(2, frame.width - 2), random.uniform(2, frame.height - 2)}),
                     .heading = random.uniform(-3, 3)};
    const double limit = 1.0;
    const double slow = std::min(limit, slow_clearance(obstacles, footprint, pose));
    const double fast = footprint_clearance(obstacles, footprint, pose, limit);
    // The slow version samples cells at a tenth of their side.
    EXPECT_NEAR(std::max(0.0, fast), slow, 0.12 * frame.resolution);
    EXPECT_EQ(fast > 0.0, is_free(obstacles, footprint, pose, 0.0));
    touching += fast < 0.0 ? 1 : 0;
  }
  EXPECT_GT(touching, 5);
}

// An obstacle may be far inside a rectangle, on the line that is left of it after half of its
// width.
TEST(FootprintClearance, ARectangleThatShrinksByItsNegativeClearanceIsFree) {
  test::Random random(2);
  int deep = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const BitGrid obstacles(test::random_world(random, 48));
    const GridFrame& frame = obstacles.frame();
    const Footprint body = Footprint::rectangle(random.uniform(0.2, 1.0), random.uniform(0.1, 0.4));
    const Pose2 pose{.position = frame.to_world(
                         {random.uniform(2, frame.width - 2), random.uniform(2, frame.height - 2)}),
                     .heading = random.uniform(-3, 3)};
    const double clearance = footprint_clearance(obstacles, body, pose, 1.0);
    // Its middle is free, so that it is free as a point.
    if (clearance >= 0.0 || !is_free(obstacles, pose.position, pose.position, 2e-4)) continue;
    EXPECT_TRUE(is_free(obstacles, body.shrunk(-clearance), pose, 0.0)) << clearance;
    EXPECT_FALSE(is_free(obstacles, body.shrunk(-clearance - 3e-4), pose, 0.0))
        << "it shrinks no more than necessary";
    deep += -clearance > body.inscribed_radius() ? 1 : 0;
  }
  EXPECT_GT(deep, 20);
}

}  // namespace
}  // namespace fairway
