// SPDX-License-Identifier: Apache-2.0
// Provokes statuses and limiting factors of the navigator: one situation each. Those of bad inputs
// are in safe_contract_test.cpp, those of the facades in map_navigator_border_test.cpp.
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/navigation/explanation/status_label.hpp"
#include "fairway/navigation/navigator.hpp"
#include "fairway/simulation/unicycle_robot.hpp"
#include "support/runs/idle_solver.hpp"

namespace fairway {
namespace {

using enum NavigationStatus;

// Two rooms of 6 m x 4 m with a door of 1.2 m between them.
BitGrid two_rooms() {
  BitGrid bits(GridFrame{.width = 240, .height = 80, .resolution = 0.05, .origin = {}}, false);
  for (int y = 0; y < 80; ++y) {
    if (y < 10 || y >= 34) bits.set({.x = 120, .y = y}, true);
  }
  return bits;
}

// A robot in the first room, and everything that its navigator has answered.
class Statuses : public ::testing::Test {
 protected:
  void start(const Pose2& pose, const Eigen::Vector2d& goal, ControlSolver* solver = nullptr) {
    robot_ = UnicycleRobot{};
    robot_.pose = pose;
    if (solver != nullptr) {
      navigator_.emplace(settings_, *solver);
    } else {
      navigator_.emplace(settings_);
    }
    navigator_->follow(planner_.plan(map_, pose.position, {.position = goal, .heading = {}},
                                     planner_settings(settings_)));
  }

  NavigationStep cycle() {
    const NavigationStep step = navigator_->update({.time = time_,
                                                    .pose = robot_.pose,
                                                    .pose_time = time_,
                                                    .obstacles = obstacles_,
                                                    .obstacles_time = time_,
                                                    .map = &map_.obstacles,
                                                    .map_time = time_});
    statuses_.insert(step.status);
    limits_.insert(step.limit);
    pairs_.insert({step.status, step.limit});
    robot_.advance(step.command, settings_.navigation.control_period);
    time_ += settings_.navigation.control_period;
    return step;
  }

  void run(double duration) {
    for (const double end = time_ + duration; time_ < end - 1e-9;)
      cycle();
  }

  [[nodiscard]] bool has(NavigationStatus status, LimitingFactor limit) const {
    return pairs_.contains({status, limit});
  }

  Settings settings_;
  PreparedMap map_{two_rooms()};
  Planner planner_;
  std::optional<Navigator> navigator_;
  UnicycleRobot robot_;
  std::vector<MovingObstacle> obstacles_;
  double time_ = 0.0;
  std::set<NavigationStatus> statuses_;
  std::set<LimitingFactor> limits_;
  std::set<std::pair<NavigationStatus, LimitingFactor>> pairs_;
};

const Pose2 kStart{.position = {1.0, 1.1}, .heading = 0.0};
const Eigen::Vector2d kBehindTheDoor{10.0, 1.1};

TEST_F(Statuses, OkIsLimitedByAccelerationThenBySpeedThenByNothingAtTheGoal) {
  settings_.robot.linear_acceleration_max = 0.3;
  start(kStart, {4.0, 1.1});
  run(20.0);
  EXPECT_TRUE(has(Ok, LimitingFactor::Acceleration));
  EXPECT_TRUE(has(Ok, LimitingFactor::Speed));
  EXPECT_TRUE(has(GoalReached, LimitingFactor::None));
  EXPECT_EQ(statuses_, (std::set{Ok, GoalReached}));
}

TEST_F(Statuses, OkIsLimitedByTheCorridorAtACorner) {
  start({.position = {5.6, 3.6}, .heading = 1.57}, {11.0, 3.5});
  run(30.0);
  EXPECT_TRUE(has(Ok, LimitingFactor::Corridor));
  EXPECT_TRUE(statuses_.contains(GoalReached));
}

TEST_F(Statuses, OkIsLimitedByAMovingObstacleInTheDoor) {
  start(kStart, kBehindTheDoor);
  obstacles_ = {{.position = {6.0, 1.1}, .velocity = {0.0, 0.0}, .radius = 0.3}};
  run(8.0);
  EXPECT_TRUE(has(Ok, LimitingFactor::MovingObstacle));
}

TEST_F(Statuses, BlockedAtAnObstacleThatClosesTheDoor) {
  start(kStart, kBehindTheDoor);
  obstacles_ = {{.position = {6.0, 0.8}, .velocity = {0.0, 0.0}, .radius = 0.3},
                {.position = {6.0, 1.4}, .velocity = {0.0, 0.0}, .radius = 0.3}};
  run(30.0);
  EXPECT_TRUE(statuses_.contains(Blocked));
  EXPECT_FALSE(statuses_.contains(GoalReached));
}

TEST_F(Statuses, DegradedWhenAnObstacleIsInsideItsMargin) {
  start(kStart, {5.0, 1.1});
  obstacles_ = {{.position = {1.0, 1.1 + 0.25 + 0.3 + 0.04}, .velocity = {}, .radius = 0.3}};
  EXPECT_EQ(cycle().status, Degraded);
  EXPECT_EQ(cycle().limit, LimitingFactor::MovingObstacle);
}

TEST_F(Statuses, StoppingBecauseNoStopIsProvenWhenAWallAppears) {
  start(kStart, {5.0, 1.1});
  run(1.5);
  BitGrid bits = map_.obstacles;
  const CellIndex ahead = bits.frame().cell_at(robot_.pose.position + Eigen::Vector2d(0.55, 0.0));
  for (int y = 0; y < 80; ++y)
    bits.set({.x = ahead.x, .y = y}, true);
  map_ = PreparedMap(bits);
  EXPECT_EQ(cycle().status, Stopping);
  EXPECT_TRUE(has(Stopping, LimitingFactor::StopNotProven));
}

TEST_F(Statuses, StoppingOutsideTheCorridorAsksForAPlan) {
  start(kStart, {5.0, 1.1});
  robot_.pose.position = {8.0, 3.0};  // in the other room, before the first cycle
  const NavigationStep step = cycle();
  EXPECT_EQ(step.status, Stopping);
  EXPECT_EQ(step.limit, LimitingFactor::OutsideCorridor);
  EXPECT_TRUE(step.wants_plan);
}

// A solver that has no answer, as for a problem whose numbers contradict each other.
class NoAnswer final : public ControlSolver {
 public:
  const MpcSolution& solve(const ControlProblem& problem,
                           const InitialGuess& /*guess*/) noexcept override {
    solution_.status = SolveStatus::InvalidProblem;
    solution_.horizon = problem.horizon;
    return solution_;
  }

 private:
  MpcSolution solution_;
};

TEST_F(Statuses, InfeasibleWhenTheSolverHasNoAnswer) {
  NoAnswer solver;
  start(kStart, {5.0, 1.1}, &solver);
  const NavigationStep step = cycle();
  EXPECT_EQ(step.status, Infeasible);
  EXPECT_EQ(step.limit, LimitingFactor::SolverFailed);
  EXPECT_EQ(step.command.linear, 0.0);
  EXPECT_EQ(step.command.angular, 0.0);
}

TEST_F(Statuses, RecoveringTurnsTowardsThePathWhenARobotIsAtStandstill) {
  test::IdleSolver solver;
  for (const double heading : {2.5, -2.5, 1.0}) {
    statuses_.clear();
    start({.position = {3.0, 1.1}, .heading = heading}, kBehindTheDoor, &solver);
    run(20.0);
    EXPECT_TRUE(statuses_.contains(Recovering)) << heading;
    EXPECT_LT(std::abs(robot_.pose.heading), 0.5) << heading;
  }
}

TEST_F(Statuses, NoPlanForARobotThatIsLargerThanThePlan) {
  start(kStart, {5.0, 1.1});
  Plan plan = navigator_->plan();
  settings_.robot.radius = 0.5;
  navigator_.emplace(settings_);
  navigator_->follow(plan);
  const NavigationStep step = cycle();
  EXPECT_EQ(step.status, NoPlan);
  EXPECT_EQ(step.limit, LimitingFactor::SmallerPlan);
}

TEST_F(Statuses, NoPlanWithoutAGoal) {
  start(kStart, {5.0, 1.1});
  navigator_->cancel();
  const NavigationStep step = cycle();
  EXPECT_EQ(step.status, NoPlan);
  EXPECT_EQ(step.limit, LimitingFactor::NoPath);
}

// The pages and the tool show these names, so every one must say something of its own.
TEST(StatusLabels, NameEachStatusAndLimitingFactorDifferently) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < kNavigationStatuses; ++i)
    names.insert(label_of(static_cast<NavigationStatus>(i)));
  EXPECT_EQ(names.size(), kNavigationStatuses);
  EXPECT_FALSE(names.contains("Unknown"));
  names.clear();
  for (std::size_t i = 0; i < kLimitingFactors; ++i)
    names.insert(label_of(static_cast<LimitingFactor>(i)));
  EXPECT_EQ(names.size(), kLimitingFactors);
  EXPECT_FALSE(names.contains("Unknown"));
  EXPECT_STREQ(label_of(NavigationStatus::Degraded), "Driving (limited)");
  EXPECT_STREQ(label_of(LimitingFactor::StopNotProven), "No verified stopping trajectory");
}

}  // namespace
}  // namespace fairway
