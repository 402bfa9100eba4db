// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/object_disc.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

constexpr double kSize = 1.4;  // [m]

struct Round {
  Vector2d center;
  double radius;
};

// Hits of beams from the origin on the nearest of some discs, with errors of up to `error` [m].
std::vector<Vector2d> hits(const std::vector<Round>& discs, double error) {
  test::Random random(1);
  std::vector<Vector2d> points;
  for (double angle = -1.5; angle < 1.5; angle += 0.00655) {
    const Vector2d along(std::cos(angle), std::sin(angle));
    double range = std::numeric_limits<double>::infinity();
    for (const Round& disc : discs) {
      const double ahead = disc.center.dot(along);
      const double inside = disc.radius * disc.radius - (disc.center - ahead * along).squaredNorm();
      if (inside > 0.0) range = std::min(range, ahead - std::sqrt(inside));
    }
    if (std::isfinite(range)) points.emplace_back((range + random.uniform(-error, error)) * along);
  }
  return points;
}

TEST(ObjectDisc, APostHasItsCentreAndRadius) {
  const std::optional<ObjectDisc> disc = disc_of(hits({{{3.0, 0.5}, 0.4}}, 0.01), {0, 0}, kSize);
  ASSERT_TRUE(disc);
  EXPECT_TRUE(disc->round);
  EXPECT_NEAR(disc->radius, 0.4, 0.08);
  EXPECT_LT((disc->center - Vector2d(3.0, 0.5)).norm(), 0.08);
}

TEST(ObjectDisc, AWallIsNotRoundAndALongOneIsNoObject) {
  std::vector<Vector2d> wall;
  for (double y = -0.4; y < 0.4; y += 0.02)
    wall.emplace_back(3.0, y);
  ASSERT_TRUE(disc_of(wall, {0, 0}, kSize));
  EXPECT_FALSE(disc_of(wall, {0, 0}, kSize)->round);
  for (double y = 0.4; y < 1.2; y += 0.02)
    wall.emplace_back(3.0, y);
  EXPECT_FALSE(disc_of(wall, {0, 0}, kSize));
  EXPECT_FALSE(find_waist(wall, {0, 0}, kSize));
}

TEST(ObjectDisc, TwoDiscsThatOverlapAreSplitAtTheirWaist) {
  for (const double apart : {0.45, 0.6, 0.75}) {
    const Round one{.center = {3.0, -apart}, .radius = 0.5};
    const Round two{.center = {3.1, apart}, .radius = 0.4};
    const std::vector<Vector2d> points = hits({one, two}, 0.01);
    const std::optional<std::size_t> waist = find_waist(points, {0, 0}, kSize);
    ASSERT_TRUE(waist) << apart;
    const std::span<const Vector2d> all(points);
    const std::optional<ObjectDisc> first = disc_of(all.first(*waist), {0, 0}, kSize);
    const std::optional<ObjectDisc> second = disc_of(all.subspan(*waist), {0, 0}, kSize);
    ASSERT_TRUE(first && second);
    EXPECT_LT((first->center - one.center).norm(), 0.15) << apart;
    EXPECT_LT((second->center - two.center).norm(), 0.15) << apart;
  }
}

TEST(ObjectDisc, OneDiscIsNotSplit) {
  EXPECT_FALSE(find_waist(hits({{{2.0, 0.0}, 0.5}}, 0.01), {0, 0}, kSize));
}

}  // namespace
}  // namespace fairway
