// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/sensors/lidar.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "support/oracles/cell_oracle.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

// Tests every cell and every disc, one by one.
double slow_ray(const BitGrid& obstacles,
                const std::vector<MovingObstacle>& discs,
                const Vector2d& from,
                double angle,
                double max_range) {
  double range = max_range;
  const GridFrame& frame = obstacles.frame();
  const Vector2d to = from + max_range * direction(angle);
  for (int y = -1; y <= frame.height; ++y) {
    for (int x = -1; x <= frame.width; ++x) {
      if (!obstacles.blocked({x, y})) continue;
      const auto crossing = test::cross_cell(frame.to_grid(from), frame.to_grid(to), {x, y});
      if (crossing) range = std::min(range, crossing->enter * max_range);
    }
  }
  for (const MovingObstacle& disc : discs) {
    for (int i = 0; i <= 20000; ++i) {
      const double s = max_range * i / 20000;
      if ((from + s * direction(angle) - disc.position).norm() <= disc.radius) {
        range = std::min(range, s);
        break;
      }
    }
  }
  return range;
}

TEST(Lidar, ARayEndsWhereTheSlowRayEnds) {
  test::Random random(1);
  for (int trial = 0; trial < 60; ++trial) {
    const BitGrid obstacles(test::random_world(random, 60));
    const GridFrame& frame = obstacles.frame();
    const Vector2d from = frame.to_world(
        {random.uniform(0.1, frame.width - 0.1), random.uniform(0.1, frame.height - 0.1)});
    std::vector<MovingObstacle> discs;
    for (int i = random.integer(0, 2); i > 0; --i) {
      discs.push_back({.position = frame.to_world(
                           {random.uniform(0, frame.width), random.uniform(0, frame.height)}),
                       .velocity = {0, 0},
                       .radius = random.uniform(0.05, 0.4)});
    }
    const double angle = random.uniform(-3, 3);
    EXPECT_NEAR(cast_ray(obstacles, discs, from, angle, 20.0),
                slow_ray(obstacles, discs, from, angle, 20.0), 2e-3);
  }
}

TEST(Lidar, ErrorsHaveTheGivenSize) {
  const BitGrid room(GridFrame{.width = 100, .height = 100, .resolution = 0.05, .origin = {}},
                     false);
  LidarModel lidar;
  lidar.range_sigma = 0.02;
  lidar.dropout = 0.05;
  Noise noise(5);
  std::vector<float> ranges;
  int lost = 0;
  int count = 0;
  double square = 0.0;
  const Pose2 sensor{.position = {2.0, 3.0}, .heading = 0.4};
  for (int n = 0; n < 50; ++n) {
    scan_surroundings(lidar, room, {}, sensor, noise, ranges);
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      ++count;
      if (std::isnan(ranges[i])) {
        ++lost;
        continue;
      }
      const double angle =
          0.4 - 0.75 * std::numbers::pi + 1.5 * std::numbers::pi * static_cast<double>(i) / 719.0;
      const double error =
          static_cast<double>(ranges[i]) - cast_ray(room, {}, sensor.position, angle, 30.0);
      square += error * error;
    }
  }
  EXPECT_NEAR(lost / static_cast<double>(count), 0.05, 0.005);
  EXPECT_NEAR(std::sqrt(square / (count - lost)), 0.02, 0.001);
}

TEST(Lidar, WithoutAHitTheRangeIsInfinite) {
  const BitGrid hall(GridFrame{.width = 1000, .height = 1000, .resolution = 0.1, .origin = {}},
                     false);
  LidarModel lidar;
  lidar.max_range = 10.0;
  lidar.beams = 5;
  Noise noise(1);
  std::vector<float> ranges;
  scan_surroundings(lidar, hall, {}, {.position = {50, 50}, .heading = 0}, noise, ranges);
  for (const float range : ranges)
    EXPECT_TRUE(std::isinf(range));
}

}  // namespace
}  // namespace fairway
