// SPDX-License-Identifier: Apache-2.0
// Corridors among random zones and obstacles, against an oracle that samples the rectangles.
#include <gtest/gtest.h>

#include "fairway/planning/planner.hpp"
#include "fairway/zones/zone_map.hpp"
#include "support/oracles/zone_oracle.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

constexpr double kCorridorRadius = 0.25;  // [m]

PreparedMap floor_with(test::Random& random, const Zones& zones) {
  OccupancyGrid map({.width = 160, .height = 160, .resolution = 0.05, .origin = {}});
  for (int i = random.integer(0, 60); i > 0; --i) {
    map.set({random.integer(30, 130), random.integer(30, 130)}, CellState::Occupied);
  }
  BitGrid bits(map);
  bits.set_zones(std::make_shared<const ZoneMap>(zones, kCorridorRadius));
  return PreparedMap(std::move(bits));
}

Plan plan_on_floor(test::Random& random, const Zones& zones, CorridorMethod method) {
  Planner planner;
  PlannerSettings settings{.radius = kCorridorRadius};
  settings.corridor.method = method;
  return planner.plan(floor_with(random, zones), {0.8, 0.8},
                      {.position = {7.2, 7.2}, .heading = {}}, settings);
}

CorridorMethod some_method(std::uint64_t seed) {
  return seed % 3 == 0 ? CorridorMethod::Mdsrc : CorridorMethod::Fewest;
}

TEST(ZoneCorridors, NoRectangleComesNearAKeepOut) {
  int built = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::Random random(seed);
    Zones zones;
    for (int i = random.integer(1, 5); i > 0; --i) {
      zones.push_back({.kind = ZoneKind::KeepOut,
                       .polygon = test::random_polygon(
                           random, {random.uniform(2, 6), random.uniform(2, 6)}, 1.5)});
    }
    const Plan plan = plan_on_floor(random, zones, some_method(seed));
    if (!plan.usable()) continue;
    ++built;
    for (const OrientedRectangle& rectangle : plan.corridor.rectangles) {
      for (const Zone& zone : zones) {
        for (const Vector2d& point : test::points_of(rectangle, 0.03))
          ASSERT_LT(test::depth_in(zone.polygon, point), -plan.corridor.robot_radius + 1e-9);
        for (const Vector2d& corner : zone.polygon)
          ASSERT_GT((rectangle.nearest(corner) - corner).norm(), plan.corridor.robot_radius);
      }
    }
    for (std::size_t i = 1; i < plan.path.waypoints.size(); ++i) {
      const OrientedRectangle piece =
          segment_rectangle(plan.path.waypoints[i - 1], plan.path.waypoints[i]);
      for (const Vector2d& point : test::points_of(piece, 0.01)) {
        for (const Zone& zone : zones)
          ASSERT_LT(test::depth_in(zone.polygon, point), -kCorridorRadius + 1e-9);
      }
    }
  }
  EXPECT_GT(built, 40);
}

TEST(ZoneCorridors, NoRectangleForTheCentreLeavesTheStrips) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::Random random(seed);
    std::vector<Vector2d> nodes{{0.8, 0.8}};
    for (int i = random.integer(1, 3); i > 0; --i)
      nodes.emplace_back(random.uniform(1, 7), random.uniform(1, 7));
    nodes.emplace_back(7.2, 7.2);
    Zones zones;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      zones.push_back(
          {.kind = ZoneKind::Strip,
           .polygon = test::strip_about(nodes[i - 1], nodes[i], random.uniform(0.1, 0.4),
                                        random.uniform(0.1, 0.4), 0.3),
           .reference = ZoneReference::Centre});
    }
    Planner planner;
    BitGrid bits(OccupancyGrid({.width = 160, .height = 160, .resolution = 0.05, .origin = {}}));
    bits.set_zones(std::make_shared<const ZoneMap>(zones, kCorridorRadius));
    PlannerSettings settings{.radius = kCorridorRadius};
    settings.corridor.method = some_method(seed);
    const Plan plan = planner.plan(PreparedMap(std::move(bits)), nodes.front(),
                                   {.position = nodes.back(), .heading = {}}, settings);
    ASSERT_TRUE(plan.usable()) << plan.reason();
    for (const OrientedRectangle& rectangle : plan.corridor.rectangles) {
      for (const Vector2d& point : test::points_of(rectangle, 0.02)) {
        double deepest = -1e9;
        for (const Zone& zone : zones)
          deepest = std::max(deepest, test::depth_in(zone.polygon, point));
        ASSERT_GT(deepest, 0.0);
      }
    }
  }
}

}  // namespace
}  // namespace fairway
