// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/straightening.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/map/free_space.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

TEST(Straightening, AStaircaseInFreeSpaceBecomesALine) {
  const BitGrid obstacles({.width = 100, .height = 100, .resolution = 0.1, .origin = {}}, false);
  const DistanceField distances(obstacles);
  const TravelCost costs(obstacles, distances, 0.2, {});
  std::vector<Vector2d> points{{20.2, 20.1}};
  for (int i = 20; i < 60; ++i)
    points.emplace_back(i + 0.5, 20.5 + (i - 20) / 3);
  points.emplace_back(60.0, 33.0);
  const std::vector<Vector2d> ends{points.front(), points.back()};
  Straightening straightening;
  straightening.apply(costs, points);
  EXPECT_EQ(points, ends);
}

TEST(Straightening, ACornerIsPulledTightAroundItsObstacle) {
  BitGrid obstacles({.width = 200, .height = 200, .resolution = 0.05, .origin = {}}, false);
  for (int y = 0; y < 100; ++y)
    obstacles.set({100, y}, true);
  const DistanceField distances(obstacles);
  PathSettings settings;
  settings.comfort_weight = 0.0;
  const TravelCost costs(obstacles, distances, 0.3, settings);
  std::vector<Vector2d> points;
  for (int y = 40; y <= 130; ++y)
    points.emplace_back(60.5, y + 0.5);
  for (int x = 61; x <= 140; ++x)
    points.emplace_back(x + 0.5, 130.5);
  for (int y = 129; y >= 40; --y)
    points.emplace_back(140.5, y + 0.5);
  Straightening straightening;
  straightening.apply(costs, points);
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += (points[i] - points[i - 1]).norm();
    EXPECT_TRUE(is_free(obstacles, points[i - 1] * 0.05, points[i] * 0.05, 0.3));
  }
  // The shortest path: a tangent, an arc of 6 cells around the wall's corner, the top, and the same
  // on the other side.
  const double far = std::hypot(39.5, 59.5);
  const double tangent = std::sqrt(far * far - 36.0);
  const double heading = std::atan2(59.5, 39.5) + std::asin(6.0 / far);
  const double taut = 2.0 * (tangent + 6.0 * heading) + 1.0;
  EXPECT_GT(length, taut - 0.1);
  EXPECT_LT(length, 1.02 * taut);
}

TEST(Straightening, TwoPointsAreUnchanged) {
  const BitGrid obstacles({.width = 50, .height = 50, .resolution = 0.1, .origin = {}}, false);
  const DistanceField distances(obstacles);
  const TravelCost costs(obstacles, distances, 0.2, {});
  Straightening straightening;
  std::vector<Vector2d> points{{10, 10}, {30, 20}};
  const std::vector<Vector2d> before = points;
  straightening.apply(costs, points);
  EXPECT_EQ(points, before);
  points.resize(1);
  straightening.apply(costs, points);
  EXPECT_EQ(points.size(), 1U);
}

}  // namespace
}  // namespace fairway
