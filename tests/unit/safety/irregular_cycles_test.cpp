// SPDX-License-Identifier: Apache-2.0
// Cycles that are late, early, at the same time or before the last one: what a navigator does, and
// what it names.
#include <cmath>

#include <gtest/gtest.h>

#include "fairway/navigation/navigator.hpp"
#include "fairway/simulation/unicycle_robot.hpp"

namespace fairway {
namespace {

class IrregularCycles : public ::testing::Test {
 protected:
  IrregularCycles() : navigator_(settings_) {
    robot_.pose = {.position = {1, 2}, .heading = 0};
    navigator_.follow(planner_.plan(map_, robot_.pose.position, {.position = {9, 2}, .heading = {}},
                                    planner_settings(settings_)));
  }

  // A cycle at `stamp`, after which the base executes the command for `duration` [s].
  NavigationStep cycle(double stamp, double duration) {
    const NavigationStep step = navigator_.update({.time = stamp,
                                                   .pose = robot_.pose,
                                                   .pose_time = stamp,
                                                   .obstacles_time = stamp,
                                                   .map = &map_.obstacles,
                                                   .map_time = stamp});
    for (int i = 0; i < 20; ++i)
      robot_.advance(step.command, duration / 20);
    return step;
  }

  void drive(double seconds, double period) {
    for (const double end = time_ + seconds; time_ < end - 1e-9; time_ += period)
      last_ = cycle(time_, period);
  }

  Settings settings_;
  PreparedMap map_{OccupancyGrid({.width = 100, .height = 40, .resolution = 0.1, .origin = {}})};
  Planner planner_;
  Navigator navigator_;
  UnicycleRobot robot_;
  NavigationStep last_;
  double time_ = 0.0;
};

TEST_F(IrregularCycles, ALateCycleBrakesAndSaysWhy) {
  drive(2.0, 0.1);
  ASSERT_EQ(last_.status, NavigationStatus::Ok);
  const double before = last_.command.linear;
  time_ += 0.2;
  const NavigationStep late = cycle(time_, 0.1);
  EXPECT_EQ(late.limit, LimitingFactor::LateCycle);
  EXPECT_EQ(late.status, NavigationStatus::Stale);
  EXPECT_LT(late.command.linear, before - 0.19);
  time_ += 0.1;
  EXPECT_EQ(cycle(time_, 0.1).status, NavigationStatus::Ok) << "the next one is on time";
}

TEST_F(IrregularCycles, CyclesThatAreAlwaysLateDoNotMoveTheRobot) {
  for (const double period : {0.3, 0.5, 0.7}) {
    navigator_.reset();
    robot_.twist = {};
    const Eigen::Vector2d start = robot_.pose.position;
    for (int k = 0; k < 20; ++k) {
      time_ += period;
      const NavigationStep step = cycle(time_, period);
      if (k == 0) continue;
      EXPECT_EQ(step.limit, LimitingFactor::LateCycle);
    }
    EXPECT_LT((robot_.pose.position - start).norm(), 0.3);
    EXPECT_EQ(robot_.twist.linear, 0.0);
  }
}

TEST_F(IrregularCycles, ALoopThatIsFasterThanThePeriodArrivesWithoutBeingBlocked) {
  for (const double period : {0.02, 0.05, 0.07}) {
    robot_.pose = {.position = {1, 2}, .heading = 0};
    robot_.twist = {};
    navigator_.reset();
    navigator_.follow(planner_.plan(map_, robot_.pose.position, {.position = {9, 2}, .heading = {}},
                                    planner_settings(settings_)));
    Twist2 before;
    double began = time_ += period;
    while (time_ < began + 12.0) {
      const NavigationStep step = cycle(time_, period);
      EXPECT_NE(step.status, NavigationStatus::Blocked);
      EXPECT_NE(step.status, NavigationStatus::Recovering);
      EXPECT_LE(std::abs(step.command.linear - before.linear), 2.0 * 0.1 + 1e-9);
      before = step.command;
      time_ += period;
      if (step.status == NavigationStatus::GoalReached) break;
    }
    EXPECT_LT(time_ - began, 9.5) << period;
  }
}

TEST_F(IrregularCycles, AClockThatDoesNotAdvanceStopsTheRobot) {
  drive(2.0, 0.1);
  for (int k = 0; k < 10; ++k) {
    const NavigationStep step = cycle(time_ - 0.1, 0.1);
    EXPECT_EQ(step.limit, LimitingFactor::InvalidTime);
    EXPECT_EQ(step.status, NavigationStatus::BadInput);
  }
  EXPECT_EQ(robot_.twist.linear, 0.0);
}

TEST_F(IrregularCycles, AClockThatWasSetBackStopsTheRobotForOneCycle) {
  drive(2.0, 0.1);
  time_ -= 100.0;
  EXPECT_EQ(cycle(time_, 0.1).limit, LimitingFactor::InvalidTime);
  time_ += 0.1;
  const NavigationStep next = cycle(time_, 0.1);
  EXPECT_EQ(next.status, NavigationStatus::Ok) << to_text(next.limit);
}

}  // namespace
}  // namespace fairway
