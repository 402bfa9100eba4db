// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/path_obstruction.hpp"

#include <cmath>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "fairway/map/free_space.hpp"
#include "fairway/zones/zone_map.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

constexpr double kCell = 0.05;  // [m]
const Eigen::Vector2d kStart{1.0, 2.0};
const Eigen::Vector2d kGoal{5.0, 2.0};

// A room of 6 m x 4 m at `origin` with a wall at x = 3 m, open from y = `low` for `cells` cells.
PreparedMap divided(double low, int cells, const Pose2& origin = {}) {
  BitGrid bits(GridFrame{.width = 120, .height = 80, .resolution = kCell, .origin = origin}, false);
  const int first = static_cast<int>(std::lround(low / kCell));
  for (int y = 0; y < 80; ++y) {
    if (y < first || y >= first + cells) bits.set({60, y}, true);
  }
  return PreparedMap(std::move(bits));
}

Plan plan_on(const PreparedMap& map,
             double radius,
             const Eigen::Vector2d& start = kStart,
             const Eigen::Vector2d& goal = kGoal) {
  return Planner().plan(map, start, {.position = goal}, {.radius = radius});
}

TEST(PathObstruction, MeasuresTheNarrowestGapOfTheBestRoute) {
  for (const int cells : {2, 3, 7, 8, 9}) {
    const PreparedMap map = divided(1.4, cells);
    const double radius = 0.3;
    const Plan plan = plan_on(map, radius);
    ASSERT_EQ(plan.path_status, PathStatus::NoConnection);
    const auto found = find_obstruction(map, kStart, plan, radius);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->kind, PathObstruction::Kind::NarrowGap);
    EXPECT_NEAR(found->found, cells * kCell, 0.1 * kCell);
    EXPECT_NEAR(found->needed, 2.0 * (radius + plan.margin), 1e-12);
    EXPECT_NEAR(found->position.x(), 3.025, 0.5 * kCell);
    EXPECT_NEAR(found->position.y(), 1.4 + 0.5 * cells * kCell, 0.1 * kCell);
  }
}

TEST(PathObstruction, ChoosesTheWidestOfSeveralGaps) {
  PreparedMap map = divided(0.5, 6);
  BitGrid bits = map.obstacles;
  for (int y = 60; y < 68; ++y)
    bits.set({60, y}, false);
  map = PreparedMap(bits);
  const auto found = find_obstruction(map, kStart, plan_on(map, 0.3), 0.3);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->found, 8 * kCell, 0.1 * kCell);
  EXPECT_NEAR(found->position.y(), 3.2, 0.1 * kCell);
}

TEST(PathObstruction, MeasuresInAWorldThatIsTurned) {
  const Pose2 origin{.position = {-7.0, 3.0}, .heading = 0.6};
  const PreparedMap map = divided(1.4, 8, origin);
  const Eigen::Vector2d start = transform(origin, kStart);
  const Plan plan = plan_on(map, 0.3, start, transform(origin, kGoal));
  const auto found = find_obstruction(map, start, plan, 0.3);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->found, 0.4, 0.1 * kCell);
  EXPECT_LT((found->position - transform(origin, {3.025, 1.6})).norm(), 0.6 * kCell);
}

TEST(PathObstruction, NamesWhereEveryRouteIsClosed) {
  const PreparedMap map = divided(0.0, 0);
  const auto found = find_obstruction(map, kStart, plan_on(map, 0.3), 0.3);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, PathObstruction::Kind::ClosedRoute);
  EXPECT_NEAR(found->position.x(), 3.025, 1e-9);
}

TEST(PathObstruction, MeasuresTheClearanceOfStartAndGoal) {
  const PreparedMap map = divided(1.0, 40);
  const Eigen::Vector2d near_wall{5.79, 2.0};  // 0.21 m from the edge of the map
  const auto at_goal = find_obstruction(map, kStart, plan_on(map, 0.3, kStart, near_wall), 0.3);
  ASSERT_TRUE(at_goal);
  EXPECT_EQ(at_goal->kind, PathObstruction::Kind::GoalClearance);
  EXPECT_NEAR(at_goal->found, 0.21, 1e-9);
  EXPECT_EQ(at_goal->needed, 0.3);
  const auto at_start = find_obstruction(map, near_wall, plan_on(map, 0.3, near_wall), 0.3);
  ASSERT_TRUE(at_start);
  EXPECT_EQ(at_start->kind, PathObstruction::Kind::StartClearance);
  EXPECT_EQ(at_start->position, near_wall);
}

TEST(PathObstruction, IsSilentAboutAPlanThatIsUsable) {
  const PreparedMap map = divided(1.0, 40);
  const Plan plan = plan_on(map, 0.3);
  ASSERT_TRUE(plan.usable());
  EXPECT_FALSE(find_obstruction(map, kStart, plan, 0.3));
  EXPECT_EQ(explain(map, kStart, plan, 0.3), "");
}

TEST(PathObstruction, ExplainsInOneSentenceWithNumbers) {
  const PreparedMap map = divided(1.4, 9, {.position = {-0.01, 0.01}});
  EXPECT_EQ(explain(map, kStart, plan_on(map, 0.3), 0.3),
            "there is no path wide enough: the narrowest gap on the best route, at (3.02, 1.64), "
            "is 0.450 m wide and the robot needs 0.602 m (twice robot.radius plus the least "
            "path.margin)");
  EXPECT_EQ(
      explain(map, kStart, plan_on(map, 0.3, kStart, {7, 2}), 0.3),
      "the goal (7.00, 2.00) is outside the map, which is 6.00 m x 4.00 m from (-0.01, 0.01)");
}

// The gap that is reported is smaller than what is needed, whatever the world looks like.
TEST(PathObstruction, SaysHowNearAnEndIsToAZone) {
  const auto reason = [](ZoneKind kind, ZoneReference reference, const Eigen::Vector2d& start,
                         const Eigen::Vector2d& goal) {
    BitGrid bits(GridFrame{.width = 120, .height = 80, .resolution = kCell, .origin = {}}, false);
    const Zones zones{{.kind = kind,
                       .polygon = {{3, 1}, {5, 1}, {5, 3}, {3, 3}},
                       .reference = reference,
                       .name = "pit"}};
    bits.set_zones(std::make_shared<const ZoneMap>(zones, 0.25));
    const PreparedMap map(std::move(bits));
    return explain(map, start, plan_on(map, 0.25, start, goal), 0.25);
  };
  using enum ZoneKind;
  EXPECT_EQ(reason(KeepOut, ZoneReference::Contour, {1, 2}, {2.9, 2}),
            "the goal (2.90, 2.00) is 0.100 m from the keep-out zone pit and the robot needs "
            "0.250 m (robot.radius)");
  EXPECT_EQ(reason(KeepOut, ZoneReference::Centre, {1, 2}, {4, 2}),
            "the goal (4.00, 2.00) is inside the keep-out zone pit");
  EXPECT_EQ(reason(Strip, ZoneReference::Contour, {4, 2}, {4.9, 2}),
            "the goal (4.90, 2.00) is 0.100 m inside the strips and the robot needs 0.250 m "
            "(robot.radius)");
  EXPECT_EQ(reason(Strip, ZoneReference::Centre, {4, 2}, {5.5, 2}),
            "the goal (5.50, 2.00) is 0.500 m outside of the strips");
}

TEST(PathObstruction, NamesThePlaceWhereACorridorEnds) {
  const PreparedMap map = divided(1.4, 20);
  Plan plan = plan_on(map, 0.2);
  ASSERT_TRUE(plan.usable());
  plan.path.waypoints = {{1.0, 2.0}, {2.0, 2.0}, {2.0, 3.0}};
  plan.corridor_status = CorridorStatus::NoOverlap;
  plan.stuck_at = 1.5;
  const std::string text = explain(map, kStart, plan, 0.2);
  EXPECT_NE(text.find("after 1.500 m of the path, at (2.00, 2.50), 1.000 m from the nearest"),
            std::string::npos)
      << text;
}

TEST(PathObstruction, ReportsLessThanTheRobotNeeds) {
  constexpr double kRadius = 0.3;
  test::Random random(11);
  int narrow = 0;
  for (int i = 0; i < 400; ++i) {
    const PreparedMap map(test::random_world(random));
    const GridFrame& frame = map.obstacles.frame();
    const auto free_point = [&] {
      for (int tries = 0; tries < 200; ++tries) {
        const CellIndex cell{random.integer(0, frame.width - 1),
                             random.integer(0, frame.height - 1)};
        if (map.distances.at(cell) > kRadius + 0.01) return frame.center(cell);
      }
      return frame.center({0, 0});
    };
    const Eigen::Vector2d start = free_point();
    const Eigen::Vector2d goal = free_point();
    const Plan plan = plan_on(map, kRadius, start, goal);
    const auto found = find_obstruction(map, start, plan, kRadius);
    ASSERT_EQ(found.has_value(), plan.path_status != PathStatus::Found)
        << to_text(plan.path_status);
    if (!found) continue;
    EXPECT_LT(found->found, found->needed + frame.resolution) << explain(map, start, plan, kRadius);
    if (found->kind == PathObstruction::Kind::NarrowGap) ++narrow;
  }
  EXPECT_GT(narrow, 10);
}

}  // namespace
}  // namespace fairway
