// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/travel_cost.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "fairway/map/free_space.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

TEST(TravelCost, StepsBetweenAllowedCellsAreFreeExactlyWhereReported) {
  test::Random random(31);
  int blocked_diagonals = 0;
  for (int trial = 0; trial < 120; ++trial) {
    const BitGrid obstacles(test::random_world(random, 50));
    const DistanceField distances(obstacles);
    const GridFrame& frame = obstacles.frame();
    // Half of the radii are just below or at sqrt 2 times a whole number, where diagonals are
    // critical.
    const int k = random.integer(0, 4);
    const double cells = random.chance(0.5) ? random.uniform(0.0, 5.0)
                                            : std::sqrt(2.0 * k * k + random.uniform(0.0, 0.5));
    const double required = cells * frame.resolution;
    const TravelCost costs(obstacles, distances, required, {});
    for (int y = 0; y < frame.height; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        const CellIndex a{x, y};
        const Vector2d p = frame.center(a);
        ASSERT_EQ(costs.is_allowed(a), is_free(obstacles, p, p, required));
        if (!costs.is_allowed(a)) continue;
        for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {1, 1}, {-1, 1}, {1, -1}}) {
          const CellIndex b{x + dx, y + dy};
          if (!costs.is_allowed(b)) continue;
          const bool free = is_free(obstacles, p, frame.center(b), required);
          ASSERT_EQ(dx == 0 || dy == 0 || costs.diagonal_is_free(a, dx, dy), free)
              << cells << ": " << x << ", " << y << " + " << dx << ", " << dy;
          blocked_diagonals += free ? 0 : 1;
        }
      }
    }
  }
  EXPECT_GT(blocked_diagonals, 50);
}

TEST(TravelCost, AMetreCostsMoreNearObstacles) {
  const BitGrid obstacles({.width = 40, .height = 40, .resolution = 0.1, .origin = {}}, false);
  const DistanceField distances(obstacles);
  const PathSettings settings{.margin = 0.0, .comfort_distance = 0.5, .comfort_weight = 2.0};
  const TravelCost costs(obstacles, distances, 0.3, settings);
  EXPECT_NEAR(costs.at_distance(0.3F), 3.0, 1e-4);
  EXPECT_NEAR(costs.at_distance(0.55F), 2.0, 1e-4);
  EXPECT_EQ(costs.at_distance(0.9F), 1.0F);
  EXPECT_EQ(costs.at_distance(0.0F), costs.greatest_cost()) << "never more than 1 + comfort_weight";
}

TEST(TravelCost, WithoutComfortEveryMetreCostsOne) {
  const BitGrid obstacles({.width = 40, .height = 40, .resolution = 0.1, .origin = {}}, false);
  const DistanceField distances(obstacles);
  for (const PathSettings& settings : {PathSettings{.margin = 0.0, .comfort_distance = 0.0},
                                       PathSettings{.margin = 0.0, .comfort_weight = 0.0}}) {
    const TravelCost costs(obstacles, distances, 0.3, settings);
    EXPECT_NEAR(costs.line({2.3, 4.5}, {30.1, 17.7}).cost, std::hypot(27.8, 13.2), 1e-9);
  }
}

TEST(TravelCost, ALineCostsTheIntegralOverItsCells) {
  test::Random random(32);
  for (int trial = 0; trial < 30; ++trial) {
    const BitGrid obstacles(test::random_world(random, 60));
    const DistanceField distances(obstacles);
    const GridFrame& frame = obstacles.frame();
    const PathSettings settings{.margin = 0.0, .comfort_distance = 6 * frame.resolution};
    const TravelCost costs(obstacles, distances, frame.resolution, settings);
    for (int i = 0; i < 20; ++i) {
      const auto point = [&] {
        Vector2d p(random.uniform(0, frame.width), random.uniform(0, frame.height));
        if (random.chance(0.3)) p.x() = std::floor(p.x());  // along and through cell edges
        if (random.chance(0.3)) p.y() = std::floor(p.y());
        return p;
      };
      const Vector2d a = point();
      const Vector2d b = point();
      if (std::abs(a.x() - b.x()) < 0.01 && a.x() == std::floor(a.x())) continue;
      if (std::abs(a.y() - b.y()) < 0.01 && a.y() == std::floor(a.y())) continue;
      constexpr int kSamples = 20000;
      double sum = 0.0;
      for (int s = 0; s < kSamples; ++s) {
        const Vector2d p = a + (b - a) * ((s + 0.5) / kSamples);
        const CellIndex cell{static_cast<int>(p.x()), static_cast<int>(p.y())};
        sum += static_cast<double>(costs.at_distance(static_cast<float>(distances.at(cell))));
      }
      const double expected = sum * (b - a).norm() / kSamples;
      // At each of at most 120 crossings, one sample on either side may fall into the other cell.
      const double tolerance = 1e-6 + 120 * 1.5 * (b - a).norm() / kSamples;
      EXPECT_NEAR(costs.line(a, b).cost, expected, tolerance);
      EXPECT_NEAR(costs.line(b, a).cost, costs.line(a, b).cost, 1e-9 + tolerance);
      EXPECT_TRUE(std::isinf(costs.line(a, b, 0.9 * expected - tolerance).cost));
    }
  }
}

// Few obstacles, so that lines skip cells far from all of them.
TEST(TravelCost, ALineInTheOpenCostsTheIntegralOverItsCells) {
  test::Random random(33);
  for (int trial = 0; trial < 20; ++trial) {
    BitGrid obstacles({.width = 180, .height = 140, .resolution = 0.05, .origin = {}}, false);
    for (int i = 0; i < 4; ++i)
      obstacles.set({random.integer(0, 179), random.integer(0, 139)}, true);
    const DistanceField distances(obstacles);
    const TravelCost costs(obstacles, distances, 0.2, {});
    for (int i = 0; i < 10; ++i) {
      const Vector2d a(random.uniform(0, 180), random.uniform(0, 140));
      const Vector2d b(random.uniform(0, 180), random.uniform(0, 140));
      constexpr int kSamples = 40000;
      double sum = 0.0;
      double least = 1e9;
      for (int s = 0; s < kSamples; ++s) {
        const Vector2d p = a + (b - a) * ((s + 0.5) / kSamples);
        const CellIndex cell{static_cast<int>(p.x()), static_cast<int>(p.y())};
        const double distance = distances.at(cell);
        sum += static_cast<double>(costs.at_distance(static_cast<float>(distance)));
        least = std::min(least, distance);
      }
      const double expected = sum * (b - a).norm() / kSamples;
      EXPECT_NEAR(costs.line(a, b).cost, expected, 360 * 1.5 * (b - a).norm() / kSamples);
      // A cell that is free all over has its centre at least half a diagonal further away.
      const bool surely_free = costs.line(a, b).surely_free;
      if (surely_free) {
        EXPECT_GE(least, 0.2 + 0.05 * std::sqrt(0.5));
      }
      if (least > 0.3) {
        EXPECT_TRUE(surely_free);
      }
    }
  }
}

TEST(TravelCost, ALineOutsideTheMapHasInfiniteCost) {
  const BitGrid obstacles({.width = 40, .height = 40, .resolution = 0.1, .origin = {}}, false);
  const DistanceField distances(obstacles);
  const TravelCost costs(obstacles, distances, 0.3, {});
  EXPECT_TRUE(std::isinf(costs.line({1, 1}, {41, 1}).cost));
  EXPECT_TRUE(std::isinf(costs.line({-0.1, 1}, {3, 1}).cost));
  EXPECT_TRUE(std::isinf(costs.line({1, std::nan("")}, {3, 1}).cost));
  EXPECT_EQ(costs.line({1, 1}, {1, 1}).cost, 0.0);
}

}  // namespace
}  // namespace fairway
