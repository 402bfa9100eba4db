// SPDX-License-Identifier: Apache-2.0
#include "bridge/drive_progress.hpp"

#include <gtest/gtest.h>

namespace fairway::bridge {
namespace {

TEST(RemainingLength, IsMeasuredFromTheNearestPoint) {
  const Path path{.waypoints = {{0, 0}, {4, 0}, {4, 3}}};
  EXPECT_DOUBLE_EQ(remaining_length(path, {-1, 0}), 7.0);
  EXPECT_DOUBLE_EQ(remaining_length(path, {1, 0.5}), 6.0);
  EXPECT_DOUBLE_EQ(remaining_length(path, {5, 2}), 1.0);
  EXPECT_DOUBLE_EQ(remaining_length(path, {4, 9}), 0.0);
  EXPECT_DOUBLE_EQ(remaining_length({.waypoints = {{1, 1}, {1, 1}}}, {0, 0}), 0.0);
  EXPECT_DOUBLE_EQ(remaining_length({.waypoints = {{1, 1}}}, {0, 0}), 0.0);
  EXPECT_DOUBLE_EQ(remaining_length({}, {0, 0}), 0.0);
}

TEST(DriveProgress, EstimatesTheTimeLeftAtTheMeanSpeed) {
  DriveProgress progress;
  progress.begin(100.0);
  EXPECT_EQ(progress.seconds_left(), 0.0) << "not known yet";
  PilotStep step;
  step.command.linear = 0.5;
  progress.update(step, 10.0, 100.0);
  progress.update(step, 9.5, 101.0);
  progress.update(step, 9.0, 102.0);
  EXPECT_DOUBLE_EQ(progress.seconds(), 2.0);
  EXPECT_DOUBLE_EQ(progress.remaining(), 9.0);
  EXPECT_DOUBLE_EQ(progress.seconds_left(), 18.0);
  progress.begin(200.0);
  EXPECT_EQ(progress.seconds(), 0.0);
}

TEST(DriveProgress, CountsEachRecoveryOnce) {
  DriveProgress progress;
  progress.begin(0.0);
  PilotStep step;
  for (const NavigationStatus status :
       {NavigationStatus::Ok, NavigationStatus::Recovering, NavigationStatus::Recovering,
        NavigationStatus::Ok, NavigationStatus::Recovering}) {
    step.status = status;
    progress.update(step, 1.0, 0.0);
  }
  EXPECT_EQ(progress.recoveries(), 2);
}

}  // namespace
}  // namespace fairway::bridge
