// SPDX-License-Identifier: Apache-2.0
#include "fairway/fleet/roundabout.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "fairway/geometry/pose2.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

ReferencePath straight(const Vector2d& from, const Vector2d& to) {
  ReferencePath path;
  path.count = 2;
  path.points = {from, to};
  path.arc = {0.0, (to - from).norm()};
  path.ends_at_goal = true;
  return path;
}

TEST(Roundabout, IsPassedWithItsCentreOnTheLeft) {
  ReferencePath bent;
  ASSERT_TRUE(bend_around(straight({-4, 0}, {4, 0}), {.center = {0, 0}, .radius = 1.0}, bent));
  EXPECT_EQ(bent.points[0], Vector2d(-4, 0));
  EXPECT_EQ(bent.points[static_cast<std::size_t>(bent.count - 1)], Vector2d(4, 0));
  EXPECT_TRUE(bent.ends_at_goal);
  EXPECT_LT(bent.at(0.5 * bent.length()).y(), -0.9) << "driving along x, right is below";
}

TEST(Roundabout, APathOnTheCorrectSideIsUnchanged) {
  ReferencePath bent;
  EXPECT_FALSE(
      bend_around(straight({-4, -1.1}, {4, -1.1}), {.center = {0, 0}, .radius = 1.0}, bent));
  EXPECT_FALSE(bend_around(straight({-4, 1.1}, {4, 1.1}), {.center = {0, 0}, .radius = 1.0}, bent));
  EXPECT_FALSE(bend_around(straight({2, 0}, {4, 0}), {.center = {0, 0}, .radius = 1.0}, bent));
}

TEST(Roundabout, TheDetourStaysOutsideAndNeverTurnsBack) {
  test::Random random(3);
  int led = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Roundabout roundabout{.center = {random.uniform(-2, 2), random.uniform(-2, 2)},
                                .radius = random.uniform(0.2, 3.0)};
    const Vector2d from = roundabout.center + random.uniform(1.001, 3.0) * roundabout.radius *
                                                  direction(random.uniform(-3, 3));
    const Vector2d to = roundabout.center + random.uniform(1.001, 3.0) * roundabout.radius *
                                                direction(random.uniform(-3, 3));
    ReferencePath bent;
    if (!bend_around(straight(from, to), roundabout, bent)) continue;
    ++led;
    for (int i = 0; i <= 50; ++i) {
      const Vector2d point = bent.at(bent.length() * i / 50.0);
      // A chord of 0.35 rad is up to 1.5 % closer than its circle.
      EXPECT_GE((point - roundabout.center).norm(), 0.984 * roundabout.radius);
    }
    for (std::size_t i = 1; i < static_cast<std::size_t>(bent.count); ++i) {
      const Vector2d a = bent.points[i - 1] - roundabout.center;
      const Vector2d b = bent.points[i] - roundabout.center;
      EXPECT_GE(a.x() * b.y() - a.y() * b.x(), -1e-9) << "clockwise";
    }
  }
  EXPECT_GT(led, 300);
}

TEST(Roundabout, FromInsideItSpiralsOut) {
  ReferencePath bent;
  const Roundabout roundabout{.center = {0, 0}, .radius = 2.0};
  ASSERT_TRUE(bend_around(straight({-0.5, 0}, {5, 0}), roundabout, bent));
  double last = 0.0;
  for (int i = 0; i <= 20; ++i) {
    const double distance = bent.at(bent.length() * i / 20.0).norm();
    EXPECT_GE(distance, last - 0.05);
    last = std::max(last, distance);
  }
}

}  // namespace
}  // namespace fairway
