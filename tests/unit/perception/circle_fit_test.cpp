// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/object/circle_fit.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/geometry/pose2.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

std::vector<Vector2d> arc(
    const Vector2d& center, double radius, double from, double to, int count) {
  std::vector<Vector2d> points;
  for (int i = 0; i < count; ++i)
    points.push_back(center + radius * direction(from + (to - from) * i / (count - 1)));
  return points;
}

TEST(CircleFit, FindsTheCircleThatPointsLieOn) {
  test::Random random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const Vector2d center(random.uniform(-20, 20), random.uniform(-20, 20));
    const double radius = random.uniform(0.1, 1.0);
    const double from = random.uniform(-3, 3);
    const auto fit = fit_circle(arc(center, radius, from, from + random.uniform(0.5, 3.0), 12));
    ASSERT_TRUE(fit);
    EXPECT_NEAR((fit->center - center).norm(), 0.0, 1e-6);
    EXPECT_NEAR(fit->radius, radius, 1e-6);
    EXPECT_NEAR(fit->deviation, 0.0, 1e-6);
  }
}

TEST(CircleFit, ALineIsNoCircle) {
  EXPECT_FALSE(fit_circle(std::vector<Vector2d>{{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}}));
  EXPECT_FALSE(fit_circle(std::vector<Vector2d>{{0, 0}, {1, 1}, {2, 0}}));
}

TEST(CircleFit, ACentreIsFoundFromAnArcOfKnownRadius) {
  const Vector2d center(3, 1);
  const auto points = arc(center, 0.5, 2.2, 4.0, 15);
  const CenterFit fit = fit_center(points, 0.5, {3.2, 0.8}, 0.01, 1.0);
  EXPECT_NEAR((fit.center - center).norm(), 0.0, 1e-3);
  EXPECT_LT(fit.deviation, 1e-3);
  EXPECT_LT(fit.covariance.trace(), 1e-3);
}

TEST(CircleFit, AShortArcIsCompletedByTheGuess) {
  const Vector2d center(3, 0);
  const auto points = arc(center, 0.5, 3.1, 3.2, 6);  // seen from the left, so y is poorly
                                                      // determined
  const CenterFit fit = fit_center(points, 0.5, {3.1, 0.02}, 0.03, 0.1);
  EXPECT_NEAR(fit.center.x(), 3.0, 0.03);
  EXPECT_LT(fit.covariance(0, 0), 0.1 * fit.covariance(1, 1));
}

}  // namespace
}  // namespace fairway
