// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/limit_mark.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace fairway {
namespace {

Plan straight_plan() {
  Plan plan;
  plan.path_status = PathStatus::Found;
  plan.corridor_status = CorridorStatus::Built;
  plan.path.waypoints = {{0.0, 0.0}, {8.0, 0.0}};
  plan.goal.position = {8.0, 0.0};
  // The second one is turned by 90 degrees, so its side 0 (least x) is the lowest in the world.
  plan.corridor.rectangles = {
      {.seed = {0.0, 0.0}, .orientation = 0.0, .min = {-1.0, -1.0}, .max = {5.0, 1.0}},
      {.seed = {6.0, 0.0},
       .orientation = 0.5 * std::numbers::pi,
       .min = {-2.0, -3.0},
       .max = {2.0, 3.0}}};
  plan.corridor.robot_radius = RobotSettings{}.radius;
  return plan;
}

NavigationStep step_limited_by(MpcSolution& solution,
                               ConstraintKind kind,
                               int index,
                               const Pose2& at) {
  solution.horizon = 3;
  solution.limiting = {.kind = kind, .step = 2, .index = index};
  solution.poses[2] = at;
  NavigationStep step;
  step.plan = &solution;
  return step;
}

TEST(LimitMark, IsTheNearestSideOfThatNumber) {
  Navigator navigator{Settings{}};
  navigator.follow(straight_plan());
  MpcSolution solution;
  const auto near_first =
      step_limited_by(solution, ConstraintKind::Corridor, 3, {.position = {2.0, 0.9}});
  LimitMark mark = limit_mark(navigator, near_first);
  EXPECT_EQ(mark.shape, LimitMark::Shape::Side);
  EXPECT_NEAR(mark.a.y(), 1.0, 1e-12);
  EXPECT_NEAR(mark.b.y(), 1.0, 1e-12);
  EXPECT_NEAR(std::abs(mark.a.x() - mark.b.x()), 6.0, 1e-12);
  const auto near_second =
      step_limited_by(solution, ConstraintKind::Corridor, 4, {.position = {8.0, -1.9}});
  mark = limit_mark(navigator, near_second);
  EXPECT_NEAR(mark.a.y(), -2.0, 1e-12);
  EXPECT_NEAR(mark.b.y(), -2.0, 1e-12);
}

TEST(LimitMark, HasNoShapeWithoutAPlanOrForASpeed) {
  Navigator navigator{Settings{}};
  navigator.follow(straight_plan());
  EXPECT_EQ(limit_mark(navigator, NavigationStep{}).shape, LimitMark::Shape::None);
  MpcSolution solution;
  const auto step = step_limited_by(solution, ConstraintKind::LinearSpeed, 0, {});
  const LimitMark mark = limit_mark(navigator, step);
  EXPECT_EQ(mark.shape, LimitMark::Shape::None);
  EXPECT_EQ(mark.row.kind, ConstraintKind::LinearSpeed);
}

}  // namespace
}  // namespace fairway
