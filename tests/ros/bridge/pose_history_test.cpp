// SPDX-License-Identifier: Apache-2.0
#include "bridge/sensing/pose_history.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace fairway::bridge {
namespace {

TEST(PoseHistory, InterpolatesBetweenTwoPosesAcrossTheWrap) {
  PoseHistory history;
  history.add(1.0, {.position = {0, 0}, .heading = 3.1}, {});
  history.add(2.0, {.position = {2, 4}, .heading = -3.1}, {});
  const auto pose = history.at(1.5);
  ASSERT_TRUE(pose);
  EXPECT_TRUE(pose->position.isApprox(Eigen::Vector2d(1, 2)));
  EXPECT_NEAR(std::cos(pose->heading), -1.0, 1e-12) << "the shorter turn";
}

TEST(PoseHistory, ExtrapolatesBrieflyBeyondTheNewestPose) {
  PoseHistory history;
  history.add(1.0, {.position = {1, 1}, .heading = 0.0}, {.linear = 2.0, .angular = 1.0});
  const auto pose = history.at(1.1);
  ASSERT_TRUE(pose);
  EXPECT_NEAR(pose->heading, 0.1, 1e-12);
  EXPECT_NEAR((pose->position - Eigen::Vector2d(1, 1)).norm(), 0.2, 1e-12);
  EXPECT_FALSE(history.at(1.0 + PoseHistory::kBeyond + 0.01));
}

TEST(PoseHistory, HasNoPoseOutsideItsTimes) {
  PoseHistory history;
  EXPECT_FALSE(history.at(0.0));
  for (int i = 0; i <= 30; ++i)
    history.add(0.1 * i, {.position = {i, 0}, .heading = 0}, {});
  EXPECT_FALSE(history.at(1.5)) << "more than a second ago";
  EXPECT_TRUE(history.at(2.5));
  EXPECT_FALSE(history.at(std::nan("")));
}

TEST(PoseHistory, IgnoresOldPosesAndSurvivesAClockThatWasSetBack) {
  PoseHistory history;
  history.add(10.0, {.position = {1, 0}, .heading = 0}, {});
  history.add(9.5, {.position = {7, 7}, .heading = 0}, {});
  history.add(std::nan(""), {.position = {8, 8}, .heading = 0}, {});
  EXPECT_EQ(history.pose().position.x(), 1.0);
  history.add(2.0, {.position = {3, 0}, .heading = 0}, {});
  EXPECT_EQ(history.time(), 2.0);
  EXPECT_EQ(history.pose().position.x(), 3.0);
}

TEST(PoseHistory, InverseUndoesCompose) {
  const Pose2 frame{.position = {3, -1}, .heading = 0.8};
  const Pose2 pose{.position = {-2, 5}, .heading = -1.1};
  const Pose2 back = compose(inverse(frame), compose(frame, pose));
  EXPECT_TRUE(back.position.isApprox(pose.position, 1e-12));
  EXPECT_NEAR(back.heading, pose.heading, 1e-12);
}

}  // namespace
}  // namespace fairway::bridge
