// SPDX-License-Identifier: Apache-2.0
#include <numbers>

#include <gtest/gtest.h>

#include "fairway/geometry/robot_model.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

TEST(PlanarTwist, DrivesACircleBackToItsBegin) {
  const Pose2 start{.position = {1.0, 2.0}, .heading = 0.3};
  const Pose2 end = moved(start, {.linear = 1.0, .angular = 0.5}, 4.0 * std::numbers::pi);
  EXPECT_NEAR((end.position - start.position).norm(), 0.0, 1e-12);
  EXPECT_NEAR(end.heading - start.heading, 2.0 * std::numbers::pi, 1e-12);
}

TEST(PlanarTwist, AgreesWithManySmallSteps) {
  test::Random random(5);
  for (int trial = 0; trial < 50; ++trial) {
    const PlanarTwist twist{random.uniform(-1, 1), random.uniform(-1, 1),
                            trial % 5 == 0 ? 1e-5 * trial : random.uniform(-3, 3)};
    Pose2 slow{.position = {0.0, 0.0}, .heading = random.uniform(-3, 3)};
    const Pose2 fast = moved(slow, twist, 1.0);
    constexpr int kSteps = 2000;
    for (int i = 0; i < kSteps; ++i) {
      const double dt = 1.0 / kSteps;
      const double heading = slow.heading + 0.5 * dt * twist.angular;
      slow.position += dt * rotated({twist.linear, twist.lateral}, heading);
      slow.heading += dt * twist.angular;
    }
    EXPECT_NEAR((slow.position - fast.position).norm(), 0.0, 1e-6);
  }
}

TEST(PlanarTwist, TwistBetweenIsTheInverseOfMoved) {
  test::Random random(7);
  for (int trial = 0; trial < 200; ++trial) {
    const Pose2 from{.position = {random.uniform(-5, 5), random.uniform(-5, 5)},
                     .heading = random.uniform(-3, 3)};
    const Pose2 to{.position = {random.uniform(-5, 5), random.uniform(-5, 5)},
                   .heading = trial % 4 == 0 ? from.heading + 1e-6 : random.uniform(-3, 3)};
    const Pose2 reached = moved(from, twist_between(from, to), 1.0);
    EXPECT_NEAR((reached.position - to.position).norm(), 0.0, 1e-9);
    EXPECT_NEAR(std::remainder(reached.heading - to.heading, 2.0 * std::numbers::pi), 0.0, 1e-12);
  }
}

}  // namespace
}  // namespace fairway
