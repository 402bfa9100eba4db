// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/planner.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "fairway/corridor/corridor_builder.hpp"
#include "fairway/planning/path_plan.hpp"

namespace fairway {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

PreparedMap room() {
  return PreparedMap(
      BitGrid(GridFrame{.width = 100, .height = 80, .resolution = 0.05, .origin = {}}, false));
}

TEST(Planner, FindsAPathAndItsCorridor) {
  const Plan plan = Planner().plan(room(), {1, 1}, {.position = {4, 3}}, {});
  EXPECT_TRUE(plan.usable());
  EXPECT_TRUE(plan.whole);
  EXPECT_TRUE(fits(plan, 0.25, 0.25));
  EXPECT_FALSE(fits(plan, 0.4, 0.4)) << "it was made for a smaller robot";
}

TEST(Planner, ReportsStartsAndGoalsThatAreNotFinite) {
  Planner planner;
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    EXPECT_EQ(planner.plan(room(), {bad, 1}, {.position = {4, 3}}, {}).path_status,
              PathStatus::StartOutsideMap);
    EXPECT_EQ(planner.plan(room(), {1, 1}, {.position = {4, bad}}, {}).path_status,
              PathStatus::GoalOutsideMap);
  }
}

TEST(Planner, ReportsAnInvalidRadiusOrMargin) {
  Planner planner;
  for (const double bad : {-0.1, kNan, kInfinity}) {
    EXPECT_EQ(planner.plan(room(), {1, 1}, {.position = {4, 3}}, {.radius = bad}).path_status,
              PathStatus::InvalidInput);
    PlannerSettings settings;
    settings.path.margin = bad;
    EXPECT_EQ(planner.plan(room(), {1, 1}, {.position = {4, 3}}, settings).path_status,
              PathStatus::InvalidInput);
  }
}

TEST(BuildCorridor, ReportsAnInvalidRadiusOrSetting) {
  const PreparedMap map = room();
  const Path path{.waypoints = {{1, 1}, {4, 3}}};
  for (const CorridorMethod method : {CorridorMethod::Fewest, CorridorMethod::Mdsrc}) {
    for (const double bad : {-0.1, kNan, kInfinity}) {
      CorridorSettings settings{.method = method};
      EXPECT_EQ(build_corridor(map.obstacles, path, bad, settings).status,
                CorridorStatus::InvalidInput);
      settings.inward_offset = bad;
      EXPECT_EQ(build_corridor(map.obstacles, path, 0.25, settings).status,
                CorridorStatus::InvalidInput);
      settings = {.method = method, .growth_step = bad};
      EXPECT_EQ(build_corridor(map.obstacles, path, 0.25, settings).status,
                CorridorStatus::InvalidInput);
    }
  }
}

TEST(BuildCorridor, ReportsAPathThatIsNotFinite) {
  const PreparedMap map = room();
  for (const CorridorMethod method : {CorridorMethod::Fewest, CorridorMethod::Mdsrc}) {
    const Path path{.waypoints = {{1, 1}, {kNan, 3}, {4, 3}}};
    EXPECT_NE(build_corridor(map.obstacles, path, 0.25, {.method = method}).status,
              CorridorStatus::Built);
  }
}

TEST(PreparedMap, AChangedWindowIsPreparedLikeTheWholeMap) {
  PreparedMap map = room();
  BitGrid bits = map.obstacles;
  for (int y = 20; y < 40; ++y)
    bits.set({50, y}, true);
  map.update(bits, {.first = {50, 20}, .last = {50, 39}});
  const PreparedMap whole(bits);
  for (int y = 0; y < 80; ++y) {
    for (int x = 0; x < 100; ++x) {
      ASSERT_EQ(map.obstacles.blocked({x, y}), whole.obstacles.blocked({x, y}));
      ASSERT_EQ(map.distances.at({x, y}), whole.distances.at({x, y})) << x << ' ' << y;
    }
  }
}

TEST(PathAhead, StartsAtTheRobotAndEndsInsideTheMap) {
  const GridFrame frame{.width = 100, .height = 80, .resolution = 0.05, .origin = {}};
  const Path path{.waypoints = {{0.5, 2}, {1.5, 2}, {2.5, 2}, {3.5, 2}, {6.5, 2}}};
  const PathAhead ahead = path_ahead(path, {1.6, 2.1}, frame, 0.3);
  EXPECT_FALSE(ahead.complete);
  ASSERT_EQ(ahead.path.waypoints.size(), 3U);
  EXPECT_EQ(ahead.path.waypoints[0], Eigen::Vector2d(1.6, 2.1));
  EXPECT_EQ(ahead.path.waypoints[1], Eigen::Vector2d(2.5, 2));
  EXPECT_EQ(ahead.path.waypoints[2], Eigen::Vector2d(3.5, 2));
}

// A body parallel to a wall has to leave where the disc about it does not fit.
TEST(Planner, PlansForTheDiscInsideTheBodyWhereTheStartHasNoMoreClearance) {
  const PreparedMap map(
      BitGrid({.width = 100, .height = 80, .resolution = 0.1, .origin = {}}, false));
  PlannerSettings settings{.radius = 0.52};
  Planner planner;
  const Eigen::Vector2d start(0.33, 4.0);
  EXPECT_FALSE(planner.plan(map, start, {.position = {6, 4}}, settings).usable());
  settings.inner_radius = 0.25;
  const Plan plan = planner.plan(map, start, {.position = {6, 4}}, settings);
  ASSERT_TRUE(plan.usable()) << plan.reason();
  EXPECT_TRUE(fits(plan, 0.52, 0.25));
  EXPECT_FALSE(fits(plan, 0.52, 0.52));
}

TEST(Plan, IsValidOnlyWhereItCanBeFollowed) {
  const PreparedMap map(
      BitGrid({.width = 100, .height = 80, .resolution = 0.1, .origin = {}}, false));
  Planner planner;
  const Plan good = planner.plan(map, {1, 1}, {.position = {8, 6}}, {});
  ASSERT_TRUE(good.usable());
  EXPECT_TRUE(validate(good));
  const auto is_valid_with = [&](const auto& change) {
    Plan plan = good;
    change(plan);
    return validate(plan).has_value();
  };
  EXPECT_FALSE(is_valid_with([](Plan& p) { p.corridor.rectangles.clear(); }));
  EXPECT_FALSE(is_valid_with([](Plan& p) { p.path.waypoints.clear(); }));
  for (const double bad : {kNan, 1e8, -1e308}) {
    EXPECT_FALSE(is_valid_with([&](Plan& p) { p.path.waypoints[0].x() = bad; })) << bad;
    EXPECT_FALSE(is_valid_with([&](Plan& p) { p.goal.position.y() = bad; })) << bad;
    EXPECT_FALSE(is_valid_with([&](Plan& p) { p.goal.heading = bad; })) << bad;
    EXPECT_FALSE(is_valid_with([&](Plan& p) { p.corridor.rectangles[0].seed.x() = bad; })) << bad;
    EXPECT_FALSE(is_valid_with([&](Plan& p) { p.corridor.rectangles[0].orientation = bad; }))
        << bad;
    EXPECT_FALSE(is_valid_with([&](Plan& p) { p.corridor.robot_radius = bad; })) << bad;
    EXPECT_FALSE(is_valid_with([&](Plan& p) { p.corridor.inward_offset = bad; })) << bad;
    EXPECT_FALSE(is_valid_with([&](Plan& p) { p.margin = bad; })) << bad;
  }
  EXPECT_FALSE(is_valid_with([](Plan& p) { p.corridor.rectangles[0].max.x() = -1e6; }));
  EXPECT_FALSE(is_valid_with([](Plan& p) { p.corridor.inward_offset = 100.0; }));
  EXPECT_FALSE(is_valid_with([](Plan& p) {
    p.corridor.rectangles.push_back(p.corridor.rectangles.back());
    p.corridor.rectangles.back().seed += Eigen::Vector2d(500.0, 500.0);
  })) << "no overlap";
  EXPECT_TRUE(is_valid_with([](Plan& p) {
    p.path_status = PathStatus::NoConnection;
    p.path.waypoints.clear();
  })) << "not usable, and says so";
}

// A gap that is wider than the robot by 5 mm per side, for every place on the grid and every turn
// of the map. An even number of cells has its middle between the centres of two of them.
TEST(Planner, FindsEveryGapThatIsFiveMillimetresWiderPerSide) {
  constexpr double kSpare = 0.005;  // [m]
  Planner planner;
  for (const double resolution : {0.02, 0.05, 0.1}) {
    for (int cells = 4; cells <= 21; ++cells) {
      const double radius = 0.5 * cells * resolution - kSpare;
      if (radius < 0.14 || radius > 0.5) continue;
      for (const double turn : {0.0, 0.7}) {
        for (const int thickness : {1, 4}) {
          const int width = static_cast<int>(6.0 / resolution);
          const int height = static_cast<int>(4.0 / resolution);
          const GridFrame frame{.width = width,
                                .height = height,
                                .resolution = resolution,
                                .origin = {.position = {0.3, -0.2}, .heading = turn}};
          BitGrid grid(frame, false);
          for (int y = 0; y < height; ++y) {
            const bool gap = y >= height / 2 - 3 && y < height / 2 - 3 + cells;
            for (int x = width / 2; x < width / 2 + thickness; ++x)
              grid.set({x, y}, !gap);
          }
          const PreparedMap map(grid);
          const Eigen::Vector2d start = transform(frame.origin, {1.5, 1.6});
          const Eigen::Vector2d goal = transform(frame.origin, {4.6, 2.1});
          const Plan plan = planner.plan(map, start, {.position = goal}, {.radius = radius});
          EXPECT_TRUE(plan.usable()) << plan.reason() << ": " << cells << " cells of " << resolution
                                     << " m, " << thickness << " thick, turned by " << turn;
        }
      }
    }
  }
}

}  // namespace
}  // namespace fairway
