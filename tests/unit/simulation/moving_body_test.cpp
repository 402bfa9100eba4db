// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/moving_body.hpp"

#include <gtest/gtest.h>

namespace fairway {
namespace {

MovingBody walker(bool loop) {
  MovingBody body;
  body.key_frames = {{1.0, {0, 0}}, {3.0, {4, 0}}, {4.0, {4, 1}}};
  body.loop = loop;
  return body;
}

TEST(MovingBody, MovesStraightBetweenKeyFrames) {
  const MovingObstacle at2 = walker(false).at(2.0);
  EXPECT_NEAR(at2.position.x(), 2.0, 1e-12);
  EXPECT_NEAR(at2.velocity.x(), 2.0, 1e-12);
}

TEST(MovingBody, StandsBeforeTheFirstAndAfterTheLast) {
  EXPECT_EQ(walker(false).at(0.0).velocity.norm(), 0.0);
  EXPECT_EQ(walker(false).at(9.0).position, Eigen::Vector2d(4, 1));
  EXPECT_EQ(walker(false).at(9.0).velocity.norm(), 0.0);
}

TEST(MovingBody, LoopsByItsOwnPeriod) {
  EXPECT_NEAR(walker(true).at(5.0).position.x(), walker(true).at(2.0).position.x(), 1e-12);
}

}  // namespace
}  // namespace fairway
