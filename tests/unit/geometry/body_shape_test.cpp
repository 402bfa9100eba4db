// SPDX-License-Identifier: Apache-2.0
#include "fairway/geometry/body_shape.hpp"

#include <gtest/gtest.h>

#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

TEST(BodyShape, RectangleReachesFromTheReferenceToItsFront) {
  const BodyShape body = BodyShape::rectangle(1.8, 0.8, 1.5);
  EXPECT_TRUE(body.is_rectangle());
  EXPECT_DOUBLE_EQ(body.low().x(), -0.3);
  EXPECT_DOUBLE_EQ(body.high().x(), 1.5);
  EXPECT_DOUBLE_EQ(body.high().y(), 0.4);
  EXPECT_DOUBLE_EQ(body.circumscribed_radius(), std::hypot(1.5, 0.4));
  EXPECT_DOUBLE_EQ(body.inscribed_radius(Vector2d::Zero()), 0.3);
}

TEST(BodyShape, HasNoInscribedDiscWhereTheReferenceLiesOutside) {
  EXPECT_EQ(BodyShape::rectangle(1.0, 0.5, 1.2).inscribed_radius(Vector2d::Zero()), 0.0);
}

TEST(BodyShape, TakesPolygonsInEitherOrientation) {
  const std::array<Vector2d, 3> clockwise{Vector2d(0, 0), Vector2d(0, 1), Vector2d(1, 0)};
  const Expected<BodyShape> body = BodyShape::polygon(clockwise);
  ASSERT_TRUE(body) << body.error().message;
  const Vector2d inside(0.2, 0.2);
  EXPECT_NEAR(body->inscribed_radius(inside), 0.2, 1e-12);
}

TEST(BodyShape, RefusesShapesThatAreNoBody) {
  const std::array<Vector2d, 4> arrow{Vector2d(0, 0), Vector2d(1, 1), Vector2d(0, 2),
                                      Vector2d(0.5, 1)};
  EXPECT_NE(BodyShape::polygon(arrow).error().message.find("convex"), std::string::npos);
  const std::array<Vector2d, 3> line{Vector2d(0, 0), Vector2d(1, 1), Vector2d(2, 2)};
  EXPECT_NE(BodyShape::polygon(line).error().message.find("area"), std::string::npos);
  const std::array<Vector2d, 3> far{Vector2d(0, 0), Vector2d(1e9, 1), Vector2d(2, 2)};
  EXPECT_NE(BodyShape::polygon(far).error().message.find("coordinates"), std::string::npos);
  EXPECT_FALSE(BodyShape::polygon({}));
  EXPECT_FALSE(BodyShape::make({}));
}

TEST(BodyShape, DistanceIsThatToTheNearestPointOfTheBody) {
  const BodyShape body = BodyShape::rectangle(2.0, 1.0, 1.5);
  EXPECT_EQ(body.distance({0.3, 0.2}), 0.0);
  EXPECT_DOUBLE_EQ(body.distance({2.0, 0.1}), 0.5);
  EXPECT_DOUBLE_EQ(body.distance({-0.8, 0.9}), 0.5);  // 0.3 and 0.4 from the rear corner
  ConvexPart capsule;
  capsule.count = 2;
  capsule.vertices[1] = {1.0, 0.0};
  capsule.radius = 0.25;
  const Expected<BodyShape> rounded = BodyShape::make(std::array{capsule});
  ASSERT_TRUE(rounded);
  EXPECT_DOUBLE_EQ(rounded->distance({0.5, 1.0}), 0.75);
  EXPECT_DOUBLE_EQ(rounded->distance({1.3, 0.4}), 0.25);
  EXPECT_EQ(rounded->distance({0.0, 0.2}), 0.0);
  ConvexPart grown;
  grown.count = 3;
  grown.vertices[1] = {1.0, 0.0};
  grown.vertices[2] = {0.0, 1.0};
  grown.radius = 0.1;
  const Expected<BodyShape> triangle = BodyShape::make(std::array{grown});
  ASSERT_TRUE(triangle);
  EXPECT_NEAR(triangle->distance({-0.3, -0.4}), 0.4, 1e-12);  // past the corner at the origin
}

TEST(BodyShape, CoverHoldsEveryPointAndTheCoreLiesInside) {
  test::Random random(3);
  for (int trial = 0; trial < 100; ++trial) {
    const double length = random.uniform(0.3, 5.0);
    const double width = random.uniform(0.1, 2.0);
    const double front = random.uniform(-1.0, length + 1.0);
    const BodyShape body = BodyShape::rectangle(length, width, front);
    for (int i = 0; i < 50; ++i) {
      const Vector2d point(random.uniform(front - length, front),
                           random.uniform(-width / 2.0, width / 2.0));
      bool covered = false;
      for (const Footprint::Disc& disc : body.cover())
        covered = covered || (point - disc.center).norm() <= disc.radius + 1e-12;
      EXPECT_TRUE(covered);
    }
    for (const Footprint::Disc& disc : body.core())
      EXPECT_LE(disc.radius, body.inscribed_radius(disc.center) + 1e-12);
  }
}

TEST(BodyShape, GreatestSpeedIsThatOfTheFastestPoint) {
  const BodyShape body = BodyShape::rectangle(2.0, 1.0, 1.0);
  EXPECT_DOUBLE_EQ(body.greatest_speed(1.0, 0.0, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(body.greatest_speed(0.0, 0.0, 2.0), 2.0 * std::hypot(1.0, 0.5));
  EXPECT_DOUBLE_EQ(body.greatest_speed(1.0, 0.0, 1.0), std::hypot(1.5, 1.0));
}

}  // namespace
}  // namespace fairway
