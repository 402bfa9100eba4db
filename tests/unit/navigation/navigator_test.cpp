// SPDX-License-Identifier: Apache-2.0
// What a navigator promises beyond its statuses, which are in statuses_test.cpp.
#include "fairway/navigation/navigator.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/mpc/interior_point/real_time_solver.hpp"
#include "fairway/simulation/unicycle_robot.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

// 12 m x 8 m with a few posts.
BitGrid posts() {
  BitGrid bits(GridFrame{.width = 240, .height = 160, .resolution = 0.05, .origin = {}}, false);
  for (const CellIndex corner : {CellIndex{80, 60}, CellIndex{120, 90}, CellIndex{160, 40}}) {
    for (int i = 0; i < 12; ++i) {
      for (int j = 0; j < 12; ++j)
        bits.set({corner.x + i, corner.y + j}, true);
    }
  }
  return bits;
}

// A robot with its navigator, and a person who crosses its path.
class Journey {
 public:
  Journey(const PreparedMap& map, const Settings& settings, ControlSolver* solver = nullptr)
      : map_(&map),
        settings_(settings),
        navigator_(solver != nullptr ? Navigator(settings, *solver) : Navigator(settings)) {
    robot_.pose = {.position = {1.0, 4.0}, .heading = 0.0};
  }

  void go(const Eigen::Vector2d& goal, const std::optional<double>& heading = {}) {
    Planner planner;
    navigator_.follow(planner.plan(*map_, robot_.pose.position,
                                   {.position = goal, .heading = heading},
                                   planner_settings(settings_)));
  }

  NavigationStep cycle(bool with_person = false) {
    const NavigationStep step = navigator_.update(input(with_person));
    execute(step.command);
    return step;
  }

  [[nodiscard]] NavigationInput input(bool with_person = false) {
    person_ = {{.position = {6.0, 1.0 + 0.5 * time_}, .velocity = {0.0, 0.5}, .radius = 0.3}};
    return {.time = time_,
            .pose = robot_.pose,
            .pose_time = time_,
            .obstacles = with_person ? MovingObstacles(person_) : MovingObstacles(),
            .obstacles_time = time_,
            .map = &map_->obstacles,
            .map_time = time_};
  }

  void execute(const Twist2& command) {
    robot_.advance(command, settings_.navigation.control_period);
    time_ += settings_.navigation.control_period;
  }

  bool reaches_goal(double limit) {
    for (const double end = time_ + limit; time_ < end;) {
      if (cycle().status == NavigationStatus::GoalReached) return true;
    }
    return false;
  }

  Navigator& navigator() { return navigator_; }
  [[nodiscard]] const Pose2& pose() const { return robot_.pose; }
  [[nodiscard]] double time() const { return time_; }

 private:
  const PreparedMap* map_;
  Settings settings_;
  Navigator navigator_;
  UnicycleRobot robot_;
  std::vector<MovingObstacle> person_;
  double time_ = 0.0;
};

class NavigatorTest : public testing::Test {
 protected:
  PreparedMap map_{posts()};
  Settings settings_;
};

bool is_same(const Twist2& a, const Twist2& b) {
  return a.linear == b.linear && a.angular == b.angular;
}

TEST_F(NavigatorTest, StopsAtTheGoalWithItsHeading) {
  Journey run(map_, settings_);
  run.go({10.5, 4.0}, 2.0);
  ASSERT_TRUE(run.reaches_goal(40.0));
  EXPECT_LT((run.pose().position - Eigen::Vector2d(10.5, 4.0)).norm(),
            settings_.navigation.goal_tolerance + 0.02);
  EXPECT_LT(std::abs(std::remainder(run.pose().heading - 2.0, 2.0 * std::numbers::pi)),
            settings_.navigation.heading_tolerance + 0.02);
}

TEST_F(NavigatorTest, EveryCommandIsWithinTheLimits) {
  settings_.robot.linear_max = 0.7;
  settings_.robot.angular_max = 0.9;
  settings_.robot.linear_acceleration_max = 0.5;
  settings_.robot.angular_acceleration_max = 1.2;
  Journey run(map_, settings_);
  run.go({10.5, 6.5}, -1.0);
  Twist2 before;
  for (int k = 0; k < 300; ++k) {
    if (k == 60) run.go({2.0, 1.0});  // another goal during the drive
    const Twist2 now = run.cycle(true).command;
    ASSERT_TRUE(is_finite(now));
    EXPECT_LE(now.linear, 0.7 + 1e-9);
    EXPECT_GE(now.linear, settings_.robot.linear_min - 1e-9);
    EXPECT_LE(std::abs(now.angular), 0.9 + 1e-9);
    EXPECT_LE(std::abs(now.linear - before.linear), 0.05 + 1e-9) << k;
    EXPECT_LE(std::abs(now.angular - before.angular), 0.12 + 1e-9) << k;
    before = now;
  }
}

TEST_F(NavigatorTest, EqualInputsGiveEqualBits) {
  Journey a(map_, settings_);
  Journey b(map_, settings_);
  a.go({10.5, 4.0});
  b.go({10.5, 4.0});
  for (int k = 0; k < 120; ++k)
    ASSERT_TRUE(is_same(a.cycle(true).command, b.cycle(true).command)) << k;
}

// A solver keeps nothing that another robot could notice.
TEST_F(NavigatorTest, RobotsThatShareASolverDriveAsWithTheirOwn) {
  RealTimeSolver shared(settings_.mpc);
  Journey first(map_, settings_, &shared);
  Journey second(map_, settings_, &shared);
  Journey alone_first(map_, settings_);
  Journey alone_second(map_, settings_);
  for (Journey* run : {&first, &alone_first})
    run->go({10.5, 4.0});
  for (Journey* run : {&second, &alone_second})
    run->go({10.5, 7.0});
  for (int k = 0; k < 80; ++k) {
    ASSERT_TRUE(is_same(first.cycle(true).command, alone_first.cycle(true).command)) << k;
    ASSERT_TRUE(is_same(second.cycle(true).command, alone_second.cycle(true).command)) << k;
  }
}

TEST_F(NavigatorTest, AnUnusablePlanBrakesToAStandstill) {
  Journey run(map_, settings_);
  run.go({10.5, 4.0});
  for (int k = 0; k < 20; ++k)
    static_cast<void>(run.cycle());
  run.go({10.5, 40.0});  // outside the map
  NavigationStep step;
  for (int k = 0; k < 10; ++k)
    step = run.cycle();
  EXPECT_EQ(step.command.linear, 0.0);
  EXPECT_EQ(step.status, NavigationStatus::NoPlan);
  EXPECT_EQ(step.limit, LimitingFactor::NoPath);
}

TEST_F(NavigatorTest, WithoutAPlanTheStatusSaysWhetherOneIsBeingMade) {
  Journey run(map_, settings_);
  NavigationInput input = run.input();
  EXPECT_EQ(run.navigator().update(input).status, NavigationStatus::NoPlan);
  input.time += settings_.navigation.control_period;
  input.pose_time = input.map_time = input.obstacles_time = input.time;
  input.planning = true;
  EXPECT_EQ(run.navigator().update(input).status, NavigationStatus::Planning);
}

TEST_F(NavigatorTest, RequestsAPlanAfterTheRebuildPeriodOnly) {
  settings_.planning.rebuild_period = 1.0;
  Journey run(map_, settings_);
  run.go({10.5, 4.0});
  for (int k = 0; k < 9; ++k)
    EXPECT_FALSE(run.cycle().wants_plan) << k;
  for (int k = 9; k < 11; ++k)
    static_cast<void>(run.cycle());
  EXPECT_TRUE(run.cycle().wants_plan);
  run.go({10.5, 4.0});
  EXPECT_FALSE(run.cycle().wants_plan) << "the period starts with the new plan";
}

TEST_F(NavigatorTest, TheFirstCommandFollowsTheActualTwist) {
  Journey run(map_, settings_);
  run.go({10.5, 4.0});
  run.navigator().reset({.linear = 0.8, .angular = 0.0});
  EXPECT_GT(run.cycle().command.linear, 0.59) << "no more than 0.2 m/s below 0.8";
}

TEST_F(NavigatorTest, AnActualTwistThatIsNotFiniteCountsAsStandstill) {
  Journey run(map_, settings_);
  run.go({10.5, 4.0});
  run.navigator().reset({.linear = std::numeric_limits<double>::quiet_NaN(), .angular = 0.0});
  const Twist2 command = run.cycle().command;
  ASSERT_TRUE(is_finite(command));
  EXPECT_LE(command.linear, 0.2 + 1e-9);
}

TEST_F(NavigatorTest, InvalidSettingsAreRefused) {
  settings_.robot.radius = -1.0;
  EXPECT_THROW(Navigator{settings_}, std::invalid_argument);
  RealTimeSolver solver{MpcSettings{}};
  EXPECT_THROW(Navigator(settings_, solver), std::invalid_argument);
}

// The message to the fleet binds the robot: whenever its inputs fail, it is where it said.
TEST_F(NavigatorTest, ARobotThatLosesItsPoseStopsAsItPublished) {
  for (const int cycles : {5, 14, 25, 40, 60}) {
    Journey run(map_, settings_);
    run.go({10.5, 4.0}, 1.5);
    for (int k = 1; k < cycles; ++k)
      static_cast<void>(run.cycle());
    const double time = run.time();
    const Pose2 pose = run.pose();
    const Twist2 command = run.navigator().update(run.input()).command;
    const SharedMotion message = run.navigator().share(3, time, pose);
    ASSERT_GT(message.stop.count, 0);
    run.execute(command);
    for (int k = 0; k < 12; ++k) {
      EXPECT_LT((run.pose().position - message.stop.at(run.time())).norm(), 0.02)
          << cycles << " + " << k;
      NavigationInput lost = run.input();
      lost.pose_time -= 10.0;
      run.execute(run.navigator().update(lost).command);
    }
  }
}

TEST_F(NavigatorTest, AMessageGivesTheRobotAndItsPath) {
  Journey run(map_, settings_);
  EXPECT_FALSE(run.navigator().share(3, 0.0, run.pose()).under_way);
  run.go({10.5, 4.0});
  for (int k = 0; k < 10; ++k)
    static_cast<void>(run.cycle());
  const SharedMotion message = run.navigator().share(3, run.time(), run.pose());
  EXPECT_TRUE(is_plausible(message));
  EXPECT_EQ(message.robot, 3U);
  EXPECT_TRUE(message.under_way);
  EXPECT_EQ(message.position, run.pose().position);
  EXPECT_GE(message.radius, settings_.robot.radius);
  EXPECT_GT(message.way.count, 0);
  EXPECT_FALSE(message.roundabout.exists());
}

TEST_F(NavigatorTest, ARobotAtItsGoalIsNotUnderWay) {
  Journey run(map_, settings_);
  run.go({3.0, 4.0});
  ASSERT_TRUE(run.reaches_goal(20.0));
  EXPECT_FALSE(run.navigator().share(3, run.time(), run.pose()).under_way);
}

TEST_F(NavigatorTest, ThePredictedMotionStartsWithTheCommand) {
  Journey run(map_, settings_);
  run.go({10.5, 4.0});
  int with_plan = 0;
  for (int k = 0; k < 60; ++k) {
    const NavigationStep step = run.cycle();
    if (step.plan == nullptr) continue;
    ++with_plan;
    EXPECT_TRUE(is_same(step.plan->commands[0], step.command)) << k;
    EXPECT_EQ(step.plan->horizon, settings_.mpc.horizon);
  }
  EXPECT_GT(with_plan, 50);
}

}  // namespace
}  // namespace fairway
