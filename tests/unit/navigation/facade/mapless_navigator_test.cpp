// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/facade/mapless_navigator.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "fairway/mpc/control_problem.hpp"
#include "fairway/simulation/sensors/lidar.hpp"
#include "fairway/simulation/sensors/noise.hpp"

namespace fairway {
namespace {

// A robot in a hall of 8 m x 6 m with a post; it knows only what its lidar has seen.
class BlindDrive {
 public:
  explicit BlindDrive(const Settings& settings = {}) : navigator(settings, robot.position) {
    for (int i = 0; i < 10; ++i) {
      for (int j = 0; j < 10; ++j)
        world_.set({75 + i, 55 + j}, true);
    }
  }

  NavigationStep cycle() {
    scan_surroundings(lidar_, world_, {}, robot, noise_, ranges_);
    navigator.observe({.time = time_,
                       .first_pose = robot,
                       .last_pose = robot,
                       .first_angle = -0.5 * lidar_.field_of_view,
                       .angle_step = lidar_.field_of_view / (lidar_.beams - 1),
                       .max_range = lidar_.max_range,
                       .ranges = ranges_},
                      robot.position);
    const NavigationStep step = navigator.update({.time = time_, .pose = robot});
    robot = fairway::step(robot, step.command, 0.1, Integration::Midpoint);
    time_ += 0.1;
    navigator.wait_for_plan();
    return step;
  }

  bool reaches_goal(int cycles) {
    for (int i = 0; i < cycles; ++i) {
      if (cycle().status == NavigationStatus::GoalReached) return true;
    }
    return false;
  }

  Pose2 robot{.position = {1.0, 3.0}, .heading = 0.0};
  MaplessNavigator navigator;

 private:
  BitGrid world_{{.width = 160, .height = 120, .resolution = 0.05, .origin = {}}, false};
  LidarModel lidar_;
  Noise noise_{1};
  std::vector<float> ranges_;
  double time_ = 0.0;
};

Settings in_a_thread(bool background) {
  Settings settings;
  settings.planning.background = background;
  return settings;
}

TEST(MaplessNavigator, DrivesToAGoalInBothModes) {
  for (const bool background : {false, true}) {
    BlindDrive drive(in_a_thread(background));
    drive.navigator.set_goal({.position = {6.5, 3.0}});
    EXPECT_TRUE(drive.reaches_goal(200)) << background;
  }
}

// The robot is still at the old goal, with a plan that leads there.
TEST(MaplessNavigator, ANewGoalIsNotReachedAtTheOldOne) {
  for (const bool background : {false, true}) {
    BlindDrive drive(in_a_thread(background));
    drive.navigator.set_goal({.position = {2.5, 3.0}});
    ASSERT_TRUE(drive.reaches_goal(100)) << background;
    drive.navigator.set_goal({.position = {2.5, 4.8}});
    EXPECT_NE(drive.cycle().status, NavigationStatus::GoalReached) << background;
    EXPECT_TRUE(drive.reaches_goal(100)) << background;
    EXPECT_LT((drive.robot.position - Eigen::Vector2d(2.5, 4.8)).norm(), 0.12) << background;
  }
}

TEST(MaplessNavigator, ReportsAnInvalidGoal) {
  BlindDrive drive;
  drive.navigator.set_goal({.position = {6.5, 3.0}, .heading = 90.0});
  const NavigationStep step = drive.cycle();
  EXPECT_EQ(step.status, NavigationStatus::BadInput);
  EXPECT_EQ(step.limit, LimitingFactor::InvalidGoal);
}

TEST(MaplessNavigator, FollowsAPathFromAnotherPlanner) {
  BlindDrive drive;
  for (int i = 0; i < 5; ++i)
    static_cast<void>(drive.cycle());
  drive.navigator.follow({.waypoints = {{1.0, 3.0}, {3.0, 4.5}, {6.5, 4.5}}});
  EXPECT_TRUE(drive.reaches_goal(200));
}

}  // namespace
}  // namespace fairway
