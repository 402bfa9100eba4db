// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/people/moving_body.hpp"

#include <gtest/gtest.h>

namespace fairway {
namespace {

MovingBody walker(bool loop) {
  MovingBody body;
  body.key_frames = {{1.0, {0, 0}}, {3.0, {4, 0}}, {4.0, {4, 1}}};
  body.loop = loop;
  return body;
}

TEST(MovingBody, MovesLinearlyBetweenKeyFrames) {
  const MovingObstacle at2 = walker(false).at(2.0);
  EXPECT_NEAR(at2.position.x(), 2.0, 1e-12);
  EXPECT_NEAR(at2.velocity.x(), 2.0, 1e-12);
}

TEST(MovingBody, IsAtRestBeforeTheFirstKeyFrameAndAfterTheLast) {
  EXPECT_EQ(walker(false).at(0.0).velocity.norm(), 0.0);
  EXPECT_EQ(walker(false).at(9.0).position, Eigen::Vector2d(4, 1));
  EXPECT_EQ(walker(false).at(9.0).velocity.norm(), 0.0);
}

TEST(MovingBody, LoopsWithItsPeriod) {
  EXPECT_NEAR(walker(true).at(5.0).position.x(), walker(true).at(2.0).position.x(), 1e-12);
}

TEST(MovingBody, APassingBodyIsPresentOnlyBetweenItsEnds) {
  MovingBody passing = walker(false);
  EXPECT_TRUE(passing.is_there(0.0));
  passing.passing = true;
  EXPECT_FALSE(passing.is_there(0.99));
  EXPECT_TRUE(passing.is_there(1.0));
  EXPECT_TRUE(passing.is_there(4.0));
  EXPECT_FALSE(passing.is_there(4.01));
  EXPECT_EQ(passing.at(5.0).radius, 0.0);
  EXPECT_EQ(passing.at(3.0).radius, passing.radius);
}

TEST(MovingBody, ARecordingIsReplayedFromAnyTime) {
  MovingBody early = walker(false);
  early.passing = true;
  MovingBody late = early;
  for (MovingBody::KeyFrame& frame : late.key_frames)
    frame.time += 10.0;
  const std::vector<MovingBody> all = replayed({early, late}, 2.0, 20.0);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].at(0.0).position, early.at(2.0).position);
  EXPECT_FALSE(all[0].is_there(2.5));
  EXPECT_TRUE(all[1].is_there(9.0));
  EXPECT_EQ(replayed({early, late}, 2.0, 8.0).size(), 1U) << "the second comes too late";
  EXPECT_EQ(replayed({early, late}, 5.0, 20.0).size(), 1U) << "the first has left";
}

}  // namespace
}  // namespace fairway
