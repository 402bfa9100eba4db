// SPDX-License-Identifier: Apache-2.0
// Whole runs among random zones. The simulator judges each at its own fine steps, and an oracle
// with other arithmetic judges the poses of the cycles.
#include <cmath>

#include <gtest/gtest.h>

#include "fairway/simulation/episode.hpp"
#include "support/oracles/zone_oracle.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

constexpr double kZonesRadius = 0.3;  // [m]

Scenario open_floor(const Vector2d& start, const Vector2d& goal) {
  Scenario scenario;
  scenario.map = OccupancyGrid({.width = 280, .height = 280, .resolution = 0.05, .origin = {}});
  scenario.settings.robot.radius = kZonesRadius;
  scenario.time_limit = 120.0;
  const Vector2d way = goal - start;
  scenario.robots = {{.name = "robot",
                      .start = {.position = start, .heading = std::atan2(way.y(), way.x())},
                      .goal = {.position = goal, .heading = {}}}};
  return scenario;
}

void expect_no_breach(const EpisodeResult& result) {
  const ZoneBreaches& breaches = result.robots.front().zones;
  EXPECT_LE(breaches.intrusion, 1e-6);
  EXPECT_LE(breaches.excursion, 1e-6);
  EXPECT_LE(breaches.excess, 1e-3);
  EXPECT_LE(breaches.against_lanes, 1e-6);
}

void expect_kept(const Scenario& scenario, const EpisodeResult& result) {
  expect_no_breach(result);
  for (const TraceRow& row : result.trace.rows) {
    double outside = std::numeric_limits<double>::infinity();
    for (const Zone& zone : scenario.zones) {
      const double depth = test::depth_in(zone.polygon, row.pose.position);
      if (zone.kind == ZoneKind::KeepOut) {
        ASSERT_LE(depth, 1e-6 - kZonesRadius);
      }
      if (zone.kind == ZoneKind::SpeedLimit && depth > -kZonesRadius) {
        ASSERT_LE(std::abs(row.twist.linear), zone.speed + 1e-3);
      }
      if (zone.kind == ZoneKind::Strip) outside = std::min(outside, -depth);
    }
    if (std::isfinite(outside)) {
      ASSERT_LE(outside, 1e-6);
    }
  }
}

std::string last_state(const EpisodeResult& result) {
  const TraceRow& row = result.trace.rows.back();
  return std::string(to_text(row.status)) + ", " + to_text(row.limit) + ", at " +
         std::to_string(row.pose.position.x()) + " " + std::to_string(row.pose.position.y());
}

// Keep-outs and speed limits along the path across the floor.
Scenario random_floor(test::Random& random) {
  Scenario scenario = open_floor({1.0, 1.0}, {13.0, 13.0});
  for (int i = random.integer(2, 7); i > 0; --i) {
    scenario.zones.push_back(
        {.kind = ZoneKind::KeepOut,
         .polygon = test::random_polygon(random, {random.uniform(3, 11), random.uniform(3, 11)},
                                         random.uniform(0.4, 2.0))});
  }
  for (int i = random.integer(1, 3); i > 0; --i) {
    scenario.zones.push_back(
        {.kind = ZoneKind::SpeedLimit,
         .polygon = test::random_polygon(random, {random.uniform(3, 11), random.uniform(3, 11)},
                                         random.uniform(1.0, 4.0)),
         .speed = random.uniform(0.15, 0.6)});
  }
  return scenario;
}

TEST(ZonesInClosedLoop, KeepOutsAndSpeedLimitsAreObeyed) {
  int driven = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::Random random(seed);
    const Scenario scenario = random_floor(random);
    const EpisodeResult result = run_episode(scenario);
    expect_kept(scenario, result);
    if (!result.robots.front().plan.usable()) continue;
    ++driven;
    EXPECT_TRUE(result.robots.front().reached) << last_state(result);
  }
  EXPECT_GE(driven, 25);
}

// Bodies that are no discs, and bases that answer late. The simulator judges them.
TEST(ZonesInClosedLoop, OtherBodiesAndSlowBasesObeyThemToo) {
  int driven = 0;
  for (std::uint64_t seed = 31; seed <= 54; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::Random random(seed);
    Scenario scenario = random_floor(random);
    RobotSettings& robot = scenario.settings.robot;
    if (seed % 2 == 0) {
      robot.length = 0.7;
      robot.width = 0.4;
      robot.radius = 0.5 * std::hypot(robot.length, robot.width);
    }
    if (seed % 3 == 0) {
      robot.linear_delay = random.uniform(0.0, 0.3);
      robot.angular_delay = random.uniform(0.0, 0.3);
      robot.linear_lag = random.uniform(0.0, 0.2);
      robot.angular_lag = random.uniform(0.0, 0.2);
    }
    ASSERT_TRUE(validate(scenario.settings)) << validate(scenario.settings).error().message;
    const EpisodeResult result = run_episode(scenario);
    expect_no_breach(result);
    if (!result.robots.front().plan.usable()) continue;
    ++driven;
    EXPECT_TRUE(result.robots.front().reached) << last_state(result);
  }
  EXPECT_GE(driven, 18);
}

// Nodes of a chain of strips. It turns by less than 120 degrees at each: where it turns back, both
// strips overlap for long, and the union leaves a needle to drive around.
std::vector<Vector2d> random_nodes(test::Random& random) {
  const auto turns_back = [](const std::vector<Vector2d>& nodes) {
    for (std::size_t i = 2; i < nodes.size(); ++i) {
      const Vector2d before = (nodes[i - 1] - nodes[i - 2]).normalized();
      if (before.dot((nodes[i] - nodes[i - 1]).normalized()) < -0.5) return true;
    }
    return false;
  };
  while (true) {
    std::vector<Vector2d> nodes{{1.0, 1.0}};
    for (int i = random.integer(1, 4); i > 0; --i)
      nodes.emplace_back(random.uniform(1.5, 12.5), random.uniform(1.5, 12.5));
    nodes.emplace_back(13.0, 13.0);
    if (!turns_back(nodes)) return nodes;
  }
}

TEST(ZonesInClosedLoop, StripsAreNotLeft) {
  int driven = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::Random random(seed);
    const ZoneReference reference = seed % 2 == 0 ? ZoneReference::Centre : ZoneReference::Contour;
    const std::vector<Vector2d> nodes = random_nodes(random);
    Scenario scenario = open_floor(nodes.front(), nodes.back());
    const double body = reference == ZoneReference::Contour ? kZonesRadius : 0.0;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      scenario.zones.push_back(
          {.kind = ZoneKind::Strip,
           .polygon = test::strip_about(nodes[i - 1], nodes[i], body + random.uniform(0.1, 0.5),
                                        body + random.uniform(0.1, 0.5), body + 0.3),
           .reference = reference});
    }
    const EpisodeResult result = run_episode(scenario);
    expect_kept(scenario, result);
    ASSERT_TRUE(result.robots.front().plan.usable()) << result.robots.front().plan.reason();
    ++driven;
    EXPECT_TRUE(result.robots.front().reached) << last_state(result);
  }
  EXPECT_EQ(driven, 30);
}

// The path turns around the tip between the second strip and the third one, where the centre has no
// clearance to drive a curve.
TEST(ZonesInClosedLoop, ATurnBackBetweenTwoStripsIsDriven) {
  Scenario scenario = open_floor({1.0, 1.0}, {13.0, 13.0});
  for (const test::Corners& polygon :
       {test::Corners{{1.053, 0.537}, {11.451, 11.568}, {11.029, 11.965}, {0.632, 0.935}},
        test::Corners{{11.260, 11.904}, {3.393, 11.219}, {3.455, 10.506}, {11.322, 11.191}},
        test::Corners{{3.494, 10.573}, {13.364, 12.742}, {13.223, 13.385}, {3.353, 11.217}}}) {
    scenario.zones.push_back(
        {.kind = ZoneKind::Strip, .polygon = polygon, .reference = ZoneReference::Centre});
  }
  const EpisodeResult result = run_episode(scenario);
  expect_kept(scenario, result);
  EXPECT_TRUE(result.robots.front().reached) << last_state(result);
}

}  // namespace
}  // namespace fairway
