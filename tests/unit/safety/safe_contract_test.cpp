// SPDX-License-Identifier: Apache-2.0
// Tests a navigator with bad inputs: it stops from the same cycle on, with a status and a limiting
// factor that give the reason.
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/navigation/navigator.hpp"
#include "fairway/simulation/unicycle_robot.hpp"

namespace fairway {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// A robot that has driven for two seconds on open ground.
class SafeContract : public ::testing::Test {
 protected:
  SafeContract() : navigator_(settings_) {
    robot_.pose = {.position = {1, 2}, .heading = 0};
    navigator_.follow(planner_.plan(map_, robot_.pose.position, {.position = {9, 2}, .heading = {}},
                                    planner_settings(settings_)));
    for (int k = 0; k < 20; ++k)
      last_ = cycle(input());
    EXPECT_EQ(last_.status, NavigationStatus::Ok);
    EXPECT_GT(last_.command.linear, 0.9);
  }

  [[nodiscard]] NavigationInput input() const {
    return {.time = time_,
            .pose = robot_.pose,
            .pose_time = time_,
            .obstacles = obstacles_,
            .obstacles_time = time_,
            .map = &map_.obstacles,
            .map_time = time_};
  }

  NavigationStep cycle(const NavigationInput& told) {
    const NavigationStep step = navigator_.update(told);
    robot_.advance(step.command, settings_.navigation.control_period);
    time_ += settings_.navigation.control_period;
    return step;
  }

  // Checks that it brakes at the limit at once, to standstill, and gives the reason.
  void expect_stop(NavigationInput told, NavigationStatus status, LimitingFactor limit) {
    Twist2 before = last_.command;
    for (int k = 0; k < 10; ++k) {
      const NavigationStep step = cycle(told);
      EXPECT_EQ(step.status, status) << to_text(step.status);
      EXPECT_EQ(step.limit, limit) << to_text(step.limit);
      EXPECT_NEAR(step.command.linear, std::max(0.0, before.linear - 0.2), 1e-6);
      before = step.command;
      if (std::isfinite(told.time)) told.time = time_;
    }
    EXPECT_EQ(before.linear, 0.0);
    EXPECT_EQ(before.angular, 0.0);
  }

  Settings settings_;
  PreparedMap map_{OccupancyGrid({.width = 100, .height = 40, .resolution = 0.1, .origin = {}})};
  Planner planner_;
  Navigator navigator_;
  UnicycleRobot robot_;
  std::vector<MovingObstacle> obstacles_;
  NavigationStep last_;
  double time_ = 0.0;
};

TEST_F(SafeContract, StopsOnAStalePose) {
  NavigationInput told = input();
  told.pose_time -= 0.25;
  expect_stop(told, NavigationStatus::Stale, LimitingFactor::StalePose);
}

TEST_F(SafeContract, StopsOnAStaleOrMissingMap) {
  NavigationInput told = input();
  told.map = nullptr;
  const NavigationStep step = cycle(told);
  EXPECT_EQ(step.status, NavigationStatus::Stale);
  EXPECT_EQ(step.limit, LimitingFactor::StaleMap);
  EXPECT_NEAR(step.command.linear, last_.command.linear - 0.2, 1e-6);
}

TEST_F(SafeContract, StopsOnAPoseOrTimeThatIsNotFinite) {
  NavigationInput told = input();
  told.pose.heading = kNan;
  expect_stop(told, NavigationStatus::BadInput, LimitingFactor::InvalidPose);
}

TEST_F(SafeContract, StopsOnTracksThatAreNotFinite) {
  obstacles_ = {{.position = {5, 2}, .velocity = {kNan, 0}, .radius = 0.3}};
  const NavigationStep step = cycle(input());
  EXPECT_EQ(step.status, NavigationStatus::BadInput);
  EXPECT_EQ(step.limit, LimitingFactor::InvalidTracks);
  EXPECT_NEAR(step.command.linear, last_.command.linear - 0.2, 1e-6);
}

TEST_F(SafeContract, StopsOnStaleTracks) {
  obstacles_ = {{.position = {5, 9}, .radius = 0.3}};
  NavigationInput told = input();
  told.obstacles_time -= 0.6;
  const NavigationStep step = cycle(told);
  EXPECT_EQ(step.status, NavigationStatus::Stale);
  EXPECT_EQ(step.limit, LimitingFactor::StaleTracks);
}

TEST_F(SafeContract, StopsOnAPoseThatJumpsAndContinuesWhenItIsBack) {
  NavigationInput told = input();
  told.pose.position.y() += 0.8;
  const NavigationStep step = cycle(told);
  EXPECT_EQ(step.status, NavigationStatus::BadInput);
  EXPECT_EQ(step.limit, LimitingFactor::PoseJump);
  EXPECT_NEAR(step.command.linear, last_.command.linear - 0.2, 1e-6);
  EXPECT_EQ(cycle(input()).status, NavigationStatus::Ok);
}

TEST_F(SafeContract, DrivesOnASlightlyLatePose) {
  std::vector<Pose2> poses;
  for (int k = 0; k < 20; ++k) {
    poses.push_back(robot_.pose);
    NavigationInput told = input();
    if (k >= 1) {
      told.pose = poses[static_cast<std::size_t>(k - 1)];
      told.pose_time -= settings_.navigation.control_period;
    }
    EXPECT_EQ(cycle(told).status, NavigationStatus::Ok);
  }
  EXPECT_NEAR(robot_.pose.position.y(), 2.0, 0.02);
}

TEST_F(SafeContract, EvadesAnApproachingObstacleAlthoughAStopIsProven) {
  // From behind, faster than the robot can drive, in its lane.
  obstacles_ = {{.position = robot_.pose.position - Eigen::Vector2d(2.5, 0.05),
                 .velocity = {1.6, 0},
                 .radius = 0.3}};
  double nearest = 10.0;
  for (int k = 0; k < 60; ++k) {
    (void)cycle(input());
    obstacles_[0].position += settings_.navigation.control_period * obstacles_[0].velocity;
    nearest = std::min(nearest, (obstacles_[0].position - robot_.pose.position).norm());
  }
  EXPECT_GT(nearest, settings_.robot.radius + 0.3);
}

}  // namespace
}  // namespace fairway
