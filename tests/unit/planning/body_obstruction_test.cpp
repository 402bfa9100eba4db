// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/body_obstruction.hpp"

#include <string>

#include <gtest/gtest.h>

namespace fairway {
namespace {

using Kind = PathObstruction::Kind;

const Eigen::Vector2d kBodyStart{2.0, 3.0};

// A room of 12 m x 6 m with a wall at x = 6 m that has a gap of `cells` cells of 0.1 m.
PreparedMap divided(int cells) {
  BitGrid bits(GridFrame{.width = 120, .height = 60, .resolution = 0.1, .origin = {}}, false);
  for (int y = 0; y < 60; ++y) {
    if (y < 30 - cells / 2 || y >= 30 + (cells + 1) / 2) bits.set({.x = 60, .y = y}, true);
  }
  return PreparedMap(std::move(bits));
}

// What a planner of drives answers where it has none.
Plan failed(PathStatus status, const Eigen::Vector2d& goal = {10.0, 3.0}) {
  Plan plan;
  plan.goal.position = goal;
  plan.path_status = status;
  plan.margin = 0.05;
  return plan;
}

const BodyShape kLong = BodyShape::rectangle(3.0, 1.0, 2.5);  // extends 2.55 m from its axle

TEST(BodyObstruction, AGapNarrowerThanTheBodyCountsAgainstItsWidth) {
  const PreparedMap map = divided(8);
  const Plan plan = failed(PathStatus::NoConnection);
  const auto found = find_body_obstruction(map, kLong, kBodyStart, plan);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, Kind::NarrowGap);
  EXPECT_NEAR(found->position.x(), 6.05, 0.1);
  EXPECT_NEAR(found->found, 0.8, 1e-6);
  EXPECT_NEAR(found->needed, 1.0, 1e-9);
  EXPECT_NE(
      explain_body(map, kLong, kBodyStart, plan).find("is 0.800 m wide and the body is 1.000 m"),
      std::string::npos);
}

TEST(BodyObstruction, AWiderGapCountsAgainstTheSpaceToTurn) {
  const PreparedMap map = divided(15);
  const Plan plan = failed(PathStatus::NoConnection);
  const auto found = find_body_obstruction(map, kLong, kBodyStart, plan);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, Kind::NarrowGap);
  EXPECT_NEAR(found->found, 1.5, 1e-6);
  EXPECT_NEAR(found->needed, 2.0 * kLong.circumscribed_radius(), 1e-9);
  EXPECT_NE(explain_body(map, kLong, kBodyStart, plan).find("to turn on the spot"),
            std::string::npos);
}

TEST(BodyObstruction, AClosedWallHasAPlace) {
  const PreparedMap map = divided(0);
  const Plan plan = failed(PathStatus::NoConnection);
  const auto found = find_body_obstruction(map, kLong, kBodyStart, plan);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, Kind::ClosedRoute);
  EXPECT_NE(explain_body(map, kLong, kBodyStart, plan).find("is closed at (6.05"),
            std::string::npos);
}

TEST(BodyObstruction, AnEndIsMeasuredFromTheReferencePoint) {
  const PreparedMap map = divided(8);
  const Plan plan = failed(PathStatus::GoalBlocked, {7.0, 1.0});
  const auto found = find_body_obstruction(map, kLong, kBodyStart, plan);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, Kind::GoalClearance);
  EXPECT_NEAR(found->found, 0.9, 1e-6);
  EXPECT_NEAR(found->needed, kLong.circumscribed_radius(), 1e-9);
  EXPECT_NE(explain_body(map, kLong, kBodyStart, plan)
                .find("the goal (7.00, 1.00): the reference point is 0.900 m from an obstacle"),
            std::string::npos);
}

TEST(BodyObstruction, IsSilentAboutAPlanThatIsUsable) {
  Plan plan = failed(PathStatus::Found);
  plan.corridor_status = CorridorStatus::Built;
  ASSERT_TRUE(plan.usable());
  EXPECT_FALSE(find_body_obstruction(divided(8), kLong, kBodyStart, plan));
  EXPECT_EQ(explain_body(divided(8), kLong, kBodyStart, plan), "");
}

}  // namespace
}  // namespace fairway
