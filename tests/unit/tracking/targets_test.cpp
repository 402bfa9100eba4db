// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/targets.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "fairway/navigation/settings.hpp"
#include "fairway/tracking/timed_targets.hpp"
#include "fairway/tracking/waypoint_targets.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

OrientedRectangle seeded_box(const Vector2d& low, const Vector2d& high, const Vector2d& seed) {
  return {.seed = seed, .orientation = 0.0, .min = low - seed, .max = high - seed};
}

const Goal kGoal{.position = {9.0, 9.0}, .heading = {}};

// Along x, then up along y, then along x again.
CorridorFollower staircase(const Vector2d& robot) {
  Corridor corridor;
  corridor.rectangles = {seeded_box({0, 0}, {6, 2}, {1, 1}), seeded_box({4, 0}, {6, 8}, {5, 1.5}),
                         seeded_box({4, 6}, {10, 10}, {5, 7})};
  CorridorFollower follower(corridor, kGoal.position, {});
  EXPECT_TRUE(follower.update(robot, 0.0));
  return follower;
}

double cost(const StepTarget& target, const Pose2& pose) {
  const Vector2d d = pose.position - target.position;
  const double turn = pose.heading - target.heading;
  return target.weight.x() * d.x() * d.x() + target.weight.y() * d.y() * d.y() +
         target.weight.z() * turn * turn;
}

// The cost of (15a) with two targets equals that of the one that represents them, at any pose.
TEST(DualTargets, CostAsMuchAsTheTwoSeedsOfThePaper) {
  MpcSettings settings;
  settings.weight_heading = 0.0;  // headings: below
  settings.weight_next_heading = 0.0;
  const CorridorFollower corridor = staircase({1.0, 1.0});
  ControlProblem problem;
  problem.horizon = 12;
  const Pose2 robot{.position = {1.0, 1.0}, .heading = 0.3};
  set_dual_targets(corridor, kGoal, robot, settings, problem);
  test::Random random(1);
  for (int trial = 0; trial < 50; ++trial) {
    const Pose2 pose{.position = {random.uniform(-5, 15), random.uniform(-5, 15)},
                     .heading = random.uniform(-3, 3)};
    double two = 0.0;
    double one = problem.cost_offset;
    for (std::size_t k = 1; k <= 12; ++k) {
      two += settings.weight_position * (pose.position - Vector2d(5, 1.5)).squaredNorm() +
             settings.weight_next_position * (pose.position - Vector2d(5, 7)).squaredNorm();
      one += cost(problem.targets[k], pose);
    }
    EXPECT_NEAR(one, two, 1e-9 * two);
  }
}

TEST(DualTargets, AreBothTheGoalInTheLastRectangle) {
  const CorridorFollower corridor = staircase({6.0, 9.0});
  ASSERT_EQ(corridor.current(), 2U);
  ControlProblem problem;
  set_dual_targets(corridor, kGoal, {.position = {6.0, 9.0}}, {}, problem);
  for (std::size_t k = 1; k <= 10; ++k)
    EXPECT_EQ(problem.targets[k].position, kGoal.position);
  EXPECT_NEAR(problem.cost_offset, 0.0, 1e-12);
}

TEST(DualTargets, AreTheLastSeedAndTheGoalOneRectangleBefore) {
  const CorridorFollower corridor = staircase({5.0, 4.0});
  ASSERT_EQ(corridor.current(), 1U);
  ControlProblem problem;
  MpcSettings settings;
  set_dual_targets(corridor, kGoal, {.position = {5.0, 4.0}}, settings, problem);
  const double sum = settings.weight_position + settings.weight_next_position;
  const Vector2d mean =
      (settings.weight_position * Vector2d(5, 7) + settings.weight_next_position * kGoal.position) /
      sum;
  EXPECT_LT((problem.targets[1].position - mean).norm(), 1e-9);
  EXPECT_NEAR(problem.targets[1].weight.x(), sum, 1e-12);
}

TEST(CentroidTarget, IsTheMiddleOfTheNextOverlap) {
  ControlProblem problem;
  set_centroid_target(staircase({1.0, 1.0}), kGoal, {.position = {1.0, 1.0}}, {}, problem);
  for (std::size_t k = 1; k <= 10; ++k)
    EXPECT_LT((problem.targets[k].position - Vector2d(5.0, 1.0)).norm(), 1e-9);
  set_centroid_target(staircase({5.0, 3.0}), kGoal, {.position = {5.0, 3.0}}, {}, problem);
  EXPECT_LT((problem.targets[1].position - Vector2d(5.0, 7.0)).norm(), 1e-9);
}

TEST(CentroidTarget, IsTheGoalInTheLastRectangle) {
  ControlProblem problem;
  set_centroid_target(staircase({6.0, 9.0}), kGoal, {.position = {6.0, 9.0}}, {}, problem);
  EXPECT_EQ(problem.targets[1].position, kGoal.position);
  EXPECT_EQ(problem.targets[10].position, kGoal.position);
}

TEST(CentroidTarget, FacesTheTargetByTheShorterTurn) {
  ControlProblem problem;
  for (const double heading : {3.1, -3.1, 9.0}) {
    const Pose2 robot{.position = {1.0, 1.0}, .heading = heading};
    set_centroid_target(staircase(robot.position), kGoal, robot, {}, problem);
    EXPECT_NEAR(std::remainder(problem.targets[1].heading, 2.0 * std::numbers::pi), 0.0, 1e-9)
        << "the overlap is straight along x";
    EXPECT_LE(std::abs(problem.targets[1].heading - heading), std::numbers::pi + 1e-9);
  }
}

TEST(WaypointTargets, EndAtTheHeadingOfTheGoal) {
  const Goal goal{.position = kGoal.position, .heading = -2.5};
  const Pose2 robot{.position = {6.0, 9.0}, .heading = 2.5};
  const double turned = 2.0 * std::numbers::pi - 2.5;  // the same heading, nearest to the robot's
  ControlProblem problem;
  set_centroid_target(staircase(robot.position), goal, robot, {}, problem);
  EXPECT_NEAR(problem.targets[1].heading, turned, 1e-9);
  set_dual_targets(staircase(robot.position), goal, robot, {}, problem);
  EXPECT_NEAR(problem.targets[1].heading, turned, 1e-9);
}

// A robot at the goal has no direction to it, so that its heading stays.
TEST(WaypointTargets, KeepTheHeadingAtAGoalWithoutOne) {
  const Pose2 robot{.position = kGoal.position, .heading = 1.2};
  ControlProblem problem;
  set_centroid_target(staircase(robot.position), kGoal, robot, {}, problem);
  EXPECT_EQ(problem.targets[1].heading, 1.2);
  set_dual_targets(staircase(robot.position), kGoal, robot, {}, problem);
  EXPECT_NEAR(problem.targets[1].heading, 1.2, 1e-12);
}

// set_targets and the method itself, for one robot.
struct BothWays {
  explicit BothWays(TargetMode mode) {
    settings.tracking.target_mode = mode;
    set_targets({.corridor = corridor,
                 .path = corridor.reference_path(),
                 .goal = kGoal,
                 .pose = robot,
                 .start = {.speed = 0.4, .heading = robot.heading}},
                settings.tracking, settings.mpc, settings.robot, selected);
  }

  void expect_equal() const {
    EXPECT_EQ(selected.cost_offset, direct.cost_offset);
    for (std::size_t k = 1; k <= static_cast<std::size_t>(direct.horizon); ++k) {
      EXPECT_EQ(selected.targets[k].position, direct.targets[k].position) << k;
      EXPECT_EQ(selected.targets[k].heading, direct.targets[k].heading) << k;
      EXPECT_EQ(selected.targets[k].weight, direct.targets[k].weight) << k;
    }
  }

  Pose2 robot{.position = {1.0, 1.0}, .heading = 0.2};
  CorridorFollower corridor = staircase(robot.position);
  Settings settings;
  ControlProblem selected;
  ControlProblem direct;
};

TEST(SetTargets, MovesAlongTheReferencePathByDefault) {
  BothWays both(TrackingSettings{}.target_mode);
  set_timed_targets(both.corridor.reference_path(), {.speed = 0.4, .heading = both.robot.heading},
                    both.settings.tracking, both.settings.mpc, both.settings.robot, both.direct);
  both.expect_equal();
  EXPECT_NE(both.selected.targets[1].position, both.selected.targets[10].position);
}

TEST(SetTargets, UsesTheTwoSeedsOfThePaperOnRequest) {
  BothWays both(TargetMode::DualWaypoints);
  set_dual_targets(both.corridor, kGoal, both.robot, both.settings.mpc, both.direct);
  both.expect_equal();
  EXPECT_GT(both.selected.cost_offset, 0.0);
}

TEST(SetTargets, UsesTheCentroidOfTheOverlapOnRequest) {
  BothWays both(TargetMode::OverlapCentroid);
  set_centroid_target(both.corridor, kGoal, both.robot, both.settings.mpc, both.direct);
  both.expect_equal();
  EXPECT_LT((both.selected.targets[1].position - Vector2d(5.0, 1.0)).norm(), 1e-9);
}

}  // namespace
}  // namespace fairway
