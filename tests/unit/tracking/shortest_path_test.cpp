// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/shortest_path.hpp"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

OrientedRectangle rectangle_around(test::Random& random, const Vector2d& around) {
  return {.seed = around + Vector2d(random.uniform(-1, 1), random.uniform(-1, 1)),
          .orientation = random.uniform(-3, 3),
          .min = {-random.uniform(0.2, 2), -random.uniform(0.2, 2)},
          .max = {random.uniform(0.2, 2), random.uniform(0.2, 2)}};
}

OverlapPatch random_patch(test::Random& random, const Vector2d& around) {
  OverlapPatch patch;
  while (patch.count == 0) {
    patch = overlap(rectangle_around(random, around), rectangle_around(random, around));
  }
  return patch;
}

double way(const Vector2d& a, const Vector2d& touch, const Vector2d& b) {
  return (touch - a).norm() + (b - touch).norm();
}

// Convex combinations of the corners, on a grid over each triangle of the fan. Slow and simple.
double least_way(const OverlapPatch& patch, const Vector2d& a, const Vector2d& b) {
  double least = std::numeric_limits<double>::infinity();
  constexpr int kSide = 60;
  for (int i = 1; i + 1 < patch.count; ++i) {
    for (int u = 0; u <= kSide; ++u) {
      for (int v = 0; u + v <= kSide; ++v) {
        const auto at = static_cast<std::size_t>(i);
        const Vector2d p = patch.corners[0] + (patch.corners[at] - patch.corners[0]) * u / kSide +
                           (patch.corners[at + 1] - patch.corners[0]) * v / kSide;
        least = std::min(least, way(a, p, b));
      }
    }
  }
  return least;
}

TEST(TautString, TheTouchPointGivesTheShortestPathThroughThePatch) {
  test::Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const OverlapPatch patch = random_patch(random, {0, 0});
    const Vector2d a(random.uniform(-4, 4), random.uniform(-4, 4));
    const Vector2d b(random.uniform(-4, 4), random.uniform(-4, 4));
    const Vector2d touch = shortest_touch(patch, a, b);
    EXPECT_LE(way(a, touch, b), least_way(patch, a, b) + 1e-9);
    // It lies in the patch: it is outside of no edge.
    for (int i = 0; i < patch.count; ++i) {
      const Vector2d p = patch.corners[static_cast<std::size_t>(i)];
      const Vector2d e = patch.corners[static_cast<std::size_t>((i + 1) % patch.count)] - p;
      EXPECT_GE(e.x() * (touch - p).y() - e.y() * (touch - p).x(), -1e-9);
    }
  }
}

TEST(TautString, SweepsNeverLengthenThePathAndConverge) {
  test::Random random(2);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<OverlapPatch> patches;
    std::vector<Vector2d> points;
    for (int i = 0; i < 6; ++i) {
      patches.push_back(random_patch(random, {3.0 * i, random.uniform(-2, 2)}));
      points.push_back(patches.back().centroid());
    }
    const Vector2d start(-4, 0);
    const Vector2d end(20, 0);
    const auto length = [&] {
      double sum = (points.front() - start).norm() + (end - points.back()).norm();
      for (std::size_t i = 1; i < points.size(); ++i)
        sum += (points[i] - points[i - 1]).norm();
      return sum;
    };
    double last = length();
    for (int sweep = 0; sweep < 30; ++sweep) {
      shorten_in_patches(patches, start, end, points, 1);
      EXPECT_LE(length(), last + 1e-9);
      last = length();
    }
    shorten_in_patches(patches, start, end, points, 2000);
    // Thirty sweeps from scratch reach the limit within a centimetre; every cycle adds a few.
    EXPECT_NEAR(last, length(), 0.01);
  }
}

TEST(TautString, IsStraightWherePossible) {
  const OrientedRectangle r{.seed = {0, 0}, .orientation = 0, .min = {-1, -1}, .max = {1, 1}};
  const OverlapPatch patch = overlap(r, r);
  EXPECT_LT((shortest_touch(patch, {-3, 0.5}, {3, 0.5}) - Vector2d(0, 0.5)).norm(), 1e-12);
  EXPECT_LT((shortest_touch(patch, {-3, 2}, {3, 2}) - Vector2d(0, 1)).norm(), 1e-12);
}

}  // namespace
}  // namespace fairway
