// SPDX-License-Identifier: Apache-2.0
// Plans with hooks, from places at a wall, and along paths of other planners.
#include <gtest/gtest.h>

#include "fairway/corridor/corridor_builder.hpp"
#include "fairway/planning/path_plan.hpp"
#include "fairway/planning/planner.hpp"
#include "support/oracles/corridor_promises.hpp"

namespace fairway {
namespace {

PreparedMap empty_room() {
  return PreparedMap(
      BitGrid(GridFrame{.width = 100, .height = 80, .resolution = 0.05, .origin = {}}, false));
}

TEST(PlannerHooks, AClockMeasuresPathAndCorridor) {
  double now = 0.0;
  const Plan timed = Planner().plan(empty_room(), {1, 1}, {.position = {4, 3}}, {},
                                    {.clock = [&] { return now += 1.0; }});
  EXPECT_GE(timed.path_seconds, 1.0);
  EXPECT_GE(timed.corridor_seconds, 1.0);
  const Plan untimed = Planner().plan(empty_room(), {1, 1}, {.position = {4, 3}}, {});
  EXPECT_EQ(untimed.path_seconds, 0.0);
  EXPECT_EQ(untimed.corridor_seconds, 0.0);
}

TEST(PlannerHooks, ABuilderReplacesTheDefault) {
  int calls = 0;
  const Plan plan = Planner().plan(empty_room(), {1, 1}, {.position = {4, 3}}, {},
                                   {.clock = {},
                                    .build = [&](const BitGrid& obstacles, const Path& path,
                                                 double radius, const CorridorSettings& settings) {
                                      ++calls;
                                      CorridorResult result =
                                          build_corridor(obstacles, path, radius, settings);
                                      result.status = CorridorStatus::NoOverlap;
                                      return result;
                                    }});
  EXPECT_GT(calls, 1) << "it tries several margins and overlaps";
  EXPECT_FALSE(plan.usable());
  EXPECT_EQ(plan.corridor_status, CorridorStatus::NoOverlap);
}

TEST(Planner, AStartSlightlyInsideAWallHasAPlanForAlmostTheWholeRobot) {
  const Plan plan = Planner().plan(empty_room(), {0.24, 2}, {.position = {4, 2}}, {.radius = 0.25});
  ASSERT_TRUE(plan.usable()) << plan.reason();
  EXPECT_LT(plan.corridor.robot_radius, 0.25);
  EXPECT_TRUE(fits(plan, 0.25, 0.25));
}

TEST(Planner, AStartDeepInsideAWallIsBlocked) {
  EXPECT_EQ(
      Planner().plan(empty_room(), {0.2, 2}, {.position = {4, 2}}, {.radius = 0.25}).path_status,
      PathStatus::StartBlocked);
}

TEST(Planner, AGoalAtAWallIsBlocked) {
  EXPECT_EQ(
      Planner().plan(empty_room(), {1, 2}, {.position = {4.9, 2}}, {.radius = 0.25}).path_status,
      PathStatus::GoalBlocked);
}

TEST(PlanAlong, CoversTheGivenPathAndNotAShorterOne) {
  Planner planner;
  const Path detour{.waypoints = {{1, 1}, {1, 3}, {4, 3}, {4, 1}}};
  const Plan plan = plan_along(planner, empty_room(), {1, 1}, {.path = detour, .goal_heading = 0.7},
                               {.radius = 0.25});
  ASSERT_TRUE(plan.usable());
  EXPECT_TRUE(plan.whole);
  EXPECT_EQ(plan.goal.position, Eigen::Vector2d(4, 1));
  EXPECT_EQ(plan.goal.heading, 0.7);
  EXPECT_NEAR(plan.path.length(), 7.0, 1e-9);
  const CorridorSettings settings;
  test::expect_a_sound_chain(empty_room().obstacles, plan.path, plan.corridor, settings, true);
}

TEST(PlanAlong, SearchesItsOwnPathWhereTheRobotDoesNotFit) {
  BitGrid walled = empty_room().obstacles;
  for (int y = 0; y < 60; ++y)
    walled.set({50, y}, true);  // across the given path at x = 2.5 m, up to y = 3 m
  Planner planner;
  const Plan plan = plan_along(planner, PreparedMap(walled), {1, 1},
                               {.path = {.waypoints = {{1, 1}, {4, 1}}}}, {.radius = 0.25});
  ASSERT_TRUE(plan.usable()) << plan.reason();
  EXPECT_TRUE(plan.whole);
  EXPECT_EQ(plan.goal.position, Eigen::Vector2d(4, 1));
  EXPECT_GT(plan.path.length(), 5.0);
}

TEST(PlanAlong, EndsBeforeTheEdgeOfTheMapWithoutTheHeadingOfTheGoal) {
  Planner planner;
  const Plan plan =
      plan_along(planner, empty_room(), {1, 1},
                 {.path = {.waypoints = {{1, 1}, {2, 1}, {4, 1}, {9, 1}}}, .goal_heading = 0.7},
                 {.radius = 0.25});
  ASSERT_TRUE(plan.usable()) << plan.reason();
  EXPECT_FALSE(plan.whole);
  EXPECT_EQ(plan.goal.position, Eigen::Vector2d(4, 1));
  EXPECT_FALSE(plan.goal.heading);
}

}  // namespace
}  // namespace fairway
