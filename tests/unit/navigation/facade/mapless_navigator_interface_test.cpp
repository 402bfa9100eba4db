// SPDX-License-Identifier: Apache-2.0
// The functions of a MaplessNavigator beside reaching goals, and what it may not do.
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/mpc/control_problem.hpp"
#include "fairway/navigation/facade/mapless_navigator.hpp"
#include "fairway/perception/perception.hpp"
#include "fairway/simulation/sensors/lidar.hpp"
#include "fairway/simulation/sensors/noise.hpp"

namespace fairway {
namespace {

// A robot in a hall of 12 m x 6 m with a dead end, whose lidar can be switched off.
class Explorer : public testing::Test {
 protected:
  Explorer() {
    for (int i = 0; i < 80; ++i) {  // three walls about (5, 3), open towards the robot
      world_.set({100 + i / 2, 30}, true);
      world_.set({100 + i / 2, 90}, true);
    }
    for (int y = 30; y <= 90; ++y)
      world_.set({140, y}, true);
  }

  NavigationStep cycle(bool scan = true) {
    if (scan) {
      scan_surroundings(lidar_, world_, {}, robot_, noise_, ranges_);
      navigator_.observe({.time = time_,
                          .first_pose = robot_,
                          .last_pose = robot_,
                          .first_angle = -0.5 * lidar_.field_of_view,
                          .angle_step = lidar_.field_of_view / (lidar_.beams - 1),
                          .max_range = lidar_.max_range,
                          .ranges = ranges_},
                         robot_.position);
    }
    step_ = navigator_.update({.time = time_, .pose = robot_});
    robot_ = fairway::step(robot_, step_.command, 0.1, Integration::Midpoint);
    time_ += 0.1;
    return step_;
  }

  void run(int cycles, bool scan = true) {
    for (int i = 0; i < cycles; ++i)
      static_cast<void>(cycle(scan));
  }

  BitGrid world_{{.width = 240, .height = 120, .resolution = 0.05, .origin = {}}, false};
  Pose2 robot_{.position = {1.0, 3.0}, .heading = 0.0};
  MaplessNavigator navigator_{Settings{}, robot_.position};
  LidarModel lidar_;
  Noise noise_{1};
  std::vector<float> ranges_;
  NavigationStep step_;
  double time_ = 0.0;
};

TEST_F(Explorer, StaysStoppedBeforeTheFirstScan) {
  navigator_.set_goal({.position = {4.0, 3.0}});
  run(10, false);
  EXPECT_EQ(step_.status, NavigationStatus::Stale);
  EXPECT_EQ(step_.limit, LimitingFactor::StaleMap);
  EXPECT_EQ(robot_.position, Eigen::Vector2d(1.0, 3.0));
}

TEST_F(Explorer, StopsWhenScansCease) {
  navigator_.set_goal({.position = {4.5, 1.0}});
  run(15);
  EXPECT_GT(step_.command.linear, 0.3);
  run(12, false);
  EXPECT_EQ(step_.status, NavigationStatus::Stale);
  EXPECT_EQ(step_.command.linear, 0.0);
}

TEST_F(Explorer, LeavesADeadEndThatItCouldNotSee) {
  navigator_.set_goal({.position = {10.0, 3.0}});
  for (int i = 0; i < 600 && step_.status != NavigationStatus::GoalReached; ++i)
    static_cast<void>(cycle());
  EXPECT_EQ(step_.status, NavigationStatus::GoalReached);
}

TEST_F(Explorer, CancelBrakesToAStandstill) {
  navigator_.set_goal({.position = {4.5, 3.0}});
  run(12);
  EXPECT_GT(step_.command.linear, 0.3);
  navigator_.cancel();
  run(10);
  EXPECT_EQ(step_.command.linear, 0.0);
  EXPECT_EQ(step_.status, NavigationStatus::NoPlan);
  EXPECT_FALSE(navigator_.share(0, time_, robot_).under_way);
}

TEST_F(Explorer, OtherSettingsAreUsedAndInvalidOnesRefused) {
  navigator_.set_goal({.position = {4.5, 1.0}});
  run(5);
  Settings slow;
  slow.robot.linear_max = 0.2;
  navigator_.set_settings(slow);
  run(12);
  EXPECT_EQ(navigator_.settings().robot.linear_max, 0.2);
  EXPECT_LE(step_.command.linear, 0.2 + 1e-9);
  EXPECT_GT(step_.command.linear, 0.1) << "it continues to its goal";
  Settings bad;
  bad.robot.radius = -1.0;
  EXPECT_THROW(navigator_.set_settings(bad), std::invalid_argument);
  EXPECT_EQ(navigator_.settings().robot.linear_max, 0.2);
}

// What is behind the robot is not seen again, so it must not be forgotten.
TEST_F(Explorer, AChangeOfSettingsKeepsWhatWasSeen) {
  navigator_.set_goal({.position = {4.5, 1.0}});
  run(20);
  const auto blocked = [&] {
    const BitGrid& seen = navigator_.perception().grid().occupied();
    int count = 0;
    for (int y = 0; y < seen.frame().height; ++y) {
      for (int x = 0; x < seen.frame().width; ++x)
        count += seen.blocked({x, y}) ? 1 : 0;
    }
    return count;
  };
  const int before = blocked();
  ASSERT_GT(before, 0);
  Settings slow;
  slow.robot.linear_max = 0.3;
  navigator_.set_settings(slow);
  EXPECT_EQ(blocked(), before);
  Settings other = slow;
  other.perception.hit_evidence = 7;
  navigator_.set_settings(other);
  EXPECT_EQ(blocked(), 0) << "it sees in another way now";
}

TEST_F(Explorer, APlanBelongsToItsGoal) {
  navigator_.set_goal({.position = {4.5, 1.0}});
  EXPECT_FALSE(navigator_.plan_is_current());
  run(3);
  EXPECT_TRUE(navigator_.plan_is_current());
  EXPECT_TRUE(navigator_.plan().usable());
  navigator_.set_goal({.position = {1.0, 5.0}});
  EXPECT_FALSE(navigator_.plan_is_current());
}

TEST_F(Explorer, EqualInputsGiveEqualBits) {
  MaplessNavigator other{Settings{}, robot_.position};
  navigator_.set_goal({.position = {4.5, 1.0}});
  other.set_goal({.position = {4.5, 1.0}});
  for (int i = 0; i < 60; ++i) {
    const Pose2 pose = robot_;
    const double time = time_;
    static_cast<void>(cycle());
    other.observe({.time = time,
                   .first_pose = pose,
                   .last_pose = pose,
                   .first_angle = -0.5 * lidar_.field_of_view,
                   .angle_step = lidar_.field_of_view / (lidar_.beams - 1),
                   .max_range = lidar_.max_range,
                   .ranges = ranges_},
                  pose.position);
    const NavigationStep again = other.update({.time = time, .pose = pose});
    ASSERT_EQ(again.command.linear, step_.command.linear) << i;
    ASSERT_EQ(again.command.angular, step_.command.angular) << i;
  }
}

}  // namespace
}  // namespace fairway
