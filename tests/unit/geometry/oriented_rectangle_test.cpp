// SPDX-License-Identifier: Apache-2.0
#include "fairway/geometry/oriented_rectangle.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

OrientedRectangle random_rectangle(test::Random& random) {
  OrientedRectangle r;
  r.seed = Vector2d(random.uniform(-5, 5), random.uniform(-5, 5));
  r.orientation = random.uniform(-4, 4);
  r.min = Vector2d(-random.uniform(0, 3), -random.uniform(0, 3));
  r.max = Vector2d(random.uniform(0, 3), random.uniform(0, 3));
  return r;
}

TEST(OrientedRectangle, ContainsItsBoundary) {
  const OrientedRectangle r{.seed = {1, 2}, .orientation = 0.0, .min = {-1, -1}, .max = {2, 1}};
  EXPECT_TRUE(r.contains({0, 1}));
  EXPECT_TRUE(r.contains({3, 3}));
  EXPECT_FALSE(r.contains({3.001, 3}));
  EXPECT_TRUE(r.contains({3.001, 3}, 0.01));
  EXPECT_FALSE(r.contains({std::nan(""), 0}));
}

TEST(OrientedRectangle, ShrinkingBeyondItsWidthMakesItEmpty) {
  const OrientedRectangle r{.seed = {0, 0}, .orientation = 0.3, .min = {-1, -0.2}, .max = {1, 0.2}};
  EXPECT_NEAR(r.shrunk(0.1).area(), 1.8 * 0.2, 1e-12);
  EXPECT_TRUE(r.shrunk(0.3).is_empty());
  EXPECT_EQ(r.shrunk(0.3).area(), 0.0);
  EXPECT_FALSE(r.shrunk(0.3).contains({0, 0}));
}

TEST(OrientedRectangle, CornersRunCounterClockwise) {
  test::Random random(1);
  for (int i = 0; i < 100; ++i) {
    const auto c = random_rectangle(random).corners();
    const Vector2d a = c[1] - c[0];
    const Vector2d b = c[3] - c[0];
    EXPECT_GE(a.x() * b.y() - a.y() * b.x(), -1e-12);
  }
}

TEST(OrientedRectangle, OverlapAreaAgreesWithCounting) {
  test::Random random(2);
  for (int i = 0; i < 30; ++i) {
    const OrientedRectangle a = random_rectangle(random);
    const OrientedRectangle b = random_rectangle(random);
    int both = 0;
    constexpr int kSide = 400;
    for (int u = 0; u < kSide; ++u) {
      for (int v = 0; v < kSide; ++v) {
        const Vector2d local = a.min + Vector2d((u + 0.5) / kSide * (a.max - a.min).x(),
                                                (v + 0.5) / kSide * (a.max - a.min).y());
        both += b.contains(a.to_world(local)) ? 1 : 0;
      }
    }
    const double counted = a.area() * both / (kSide * kSide);
    // Counting has an error of about a cell along the outline of the patch.
    EXPECT_NEAR(overlap(a, b).area(), counted, 0.02 * (1.0 + a.area()) / 2.0);
    EXPECT_NEAR(overlap(a, b).area(), overlap(b, a).area(), 1e-9);
  }
}

TEST(OrientedRectangle, OverlapCentroidLiesInBoth) {
  test::Random random(3);
  int meeting = 0;
  for (int i = 0; i < 200; ++i) {
    const OrientedRectangle a = random_rectangle(random);
    const OrientedRectangle b = random_rectangle(random);
    const OverlapPatch patch = overlap(a, b);
    if (patch.count == 0) continue;
    ++meeting;
    EXPECT_TRUE(a.contains(patch.centroid(), 1e-9));
    EXPECT_TRUE(b.contains(patch.centroid(), 1e-9));
  }
  EXPECT_GT(meeting, 20);
}

TEST(OrientedRectangle, NearestIsInsideAndNotFurtherThanAnyCorner) {
  test::Random random(4);
  for (int i = 0; i < 200; ++i) {
    const OrientedRectangle r = random_rectangle(random);
    const Vector2d p(random.uniform(-9, 9), random.uniform(-9, 9));
    const Vector2d q = r.nearest(p);
    EXPECT_TRUE(r.contains(q, 1e-9));
    for (const Vector2d& corner : r.corners())
      EXPECT_LE((q - p).norm(), (corner - p).norm() + 1e-9);
  }
}

TEST(OrientedRectangle, SegmentIsDegenerateButNotEmpty) {
  const OrientedRectangle s = segment_rectangle({1, 1}, {3, 2});
  EXPECT_FALSE(s.is_empty());
  EXPECT_EQ(s.area(), 0.0);
  EXPECT_TRUE(s.contains({2, 1.5}, 1e-12));
  EXPECT_FALSE(segment_rectangle({1, 1}, {1, 1}).is_empty());
}

}  // namespace
}  // namespace fairway
