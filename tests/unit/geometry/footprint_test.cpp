// SPDX-License-Identifier: Apache-2.0
#include "fairway/geometry/footprint.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace fairway {
namespace {

using Eigen::Vector2d;

TEST(Footprint, RadiiOfADisc) {
  const Footprint disc = Footprint::disc(0.3);
  EXPECT_FALSE(disc.is_rectangle());
  EXPECT_EQ(disc.circumscribed_radius(), 0.3);
  EXPECT_EQ(disc.inscribed_radius(), 0.3);
}

TEST(Footprint, RadiiOfARectangle) {
  const Footprint jackal = Footprint::rectangle(0.458, 0.416);
  EXPECT_TRUE(jackal.is_rectangle());
  EXPECT_NEAR(jackal.circumscribed_radius(), 0.309, 5e-4);
  EXPECT_NEAR(jackal.inscribed_radius(), 0.208, 1e-12);
  // A robot driven by its rear axle: the centre lies outside.
  const Footprint car = Footprint::rectangle(2.0, 1.0, {1.2, 0.0});
  EXPECT_EQ(car.inscribed_radius(), 0.0);
  EXPECT_NEAR(car.circumscribed_radius(), std::hypot(2.2, 0.5), 1e-12);
}

TEST(Footprint, RadiiOfSeveralDiscs) {
  const Footprint::Disc two[2] = {{.center = {0.2, 0}, .radius = 0.25},
                                  {.center = {-0.1, 0}, .radius = 0.25}};
  const Footprint discs = Footprint::discs(two, 2);
  EXPECT_NEAR(discs.circumscribed_radius(), 0.45, 1e-12);
  EXPECT_NEAR(discs.inscribed_radius(), 0.15, 1e-12);
}

TEST(Footprint, DistanceIsZeroInsideAndEuclideanOutside) {
  const Footprint box = Footprint::rectangle(1.0, 0.5, {0.1, 0.0});
  EXPECT_EQ(box.distance({0.6, 0.25}), 0.0);
  EXPECT_NEAR(box.distance({0.9, 0.65}), 0.5, 1e-12);
  const Footprint disc = Footprint::disc(0.3);
  EXPECT_EQ(disc.distance({0.1, 0.1}), 0.0);
  EXPECT_NEAR(disc.distance({0.0, -1.0}), 0.7, 1e-12);
}

TEST(Footprint, ShrinkingEndsAtAPoint) {
  const Footprint box = Footprint::rectangle(1.0, 0.5);
  EXPECT_NEAR(box.shrunk(0.1).circumscribed_radius(), std::hypot(0.4, 0.15), 1e-12);
  EXPECT_EQ(box.shrunk(2.0).circumscribed_radius(), 0.0);
  EXPECT_EQ(Footprint::disc(0.3).shrunk(0.5).circumscribed_radius(), 0.0);
}

TEST(Footprint, ItsRectangleHasTheRobotsPose) {
  const OrientedRectangle at = Footprint::rectangle(1.0, 0.5, {0.2, 0.0})
                                   .rectangle_at({.position = {3, 4}, .heading = M_PI_2});
  EXPECT_TRUE(at.contains({3.0, 4.65}));
  EXPECT_FALSE(at.contains({3.0, 3.65}));
  EXPECT_TRUE(at.contains({3.24, 4.2}));
}

}  // namespace
}  // namespace fairway
