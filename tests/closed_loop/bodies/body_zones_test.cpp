// SPDX-License-Identifier: Apache-2.0
// Whole runs of robots with their true outline among random zones, judged by the simulator at its
// own fine steps.
#include <cmath>

#include <gtest/gtest.h>

#include "fairway/simulation/episode.hpp"
#include "support/oracles/zone_oracle.hpp"
#include "support/worlds/robot_presets.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

Scenario body_floor(const RobotModel& model, const Pose2& start, const Goal& goal) {
  Scenario scenario;
  scenario.map = OccupancyGrid({.width = 280, .height = 280, .resolution = 0.05, .origin = {}});
  scenario.time_limit = 120.0;
  scenario.robots = {{.name = "robot", .start = start, .goal = goal}};
  scenario.robots[0].model = model;
  return scenario;
}

void expect_zones_kept(const EpisodeResult& result) {
  const ZoneBreaches& breaches = result.robots.front().zones;
  EXPECT_LE(breaches.intrusion, 1e-6);
  EXPECT_LE(breaches.excursion, 1e-6);
  EXPECT_LE(breaches.excess, 1e-3);
  EXPECT_LE(breaches.against_lanes, 1e-6);
  EXPECT_FALSE(result.robots.front().collided);
}

std::string last_of(const EpisodeResult& result) {
  const TraceRow& row = result.trace.rows.back();
  return std::string(to_text(row.status)) + ", " + to_text(row.limit) + ", at " +
         std::to_string(row.pose.position.x()) + " " + std::to_string(row.pose.position.y());
}

TEST(BodiesAmongZones, KeepOutsAndSpeedLimitsAreObeyed) {
  const auto robots = test::robot_presets();
  int planned = 0;
  int reached = 0;
  for (std::uint64_t seed = 1; seed <= 2 * robots.size(); ++seed) {
    test::Random random(seed);
    const test::NamedRobot& robot = robots[seed % robots.size()];
    SCOPED_TRACE(std::string(robot.name) + ", seed " + std::to_string(seed));
    Scenario scenario = body_floor(robot.model, {.position = {2.0, 2.0}, .heading = 0.8},
                                   {.position = {12.0, 12.0}, .heading = {}});
    for (int i = random.integer(2, 4); i > 0; --i) {
      scenario.zones.push_back(
          {.kind = ZoneKind::KeepOut,
           .polygon =
               test::random_polygon(random, {random.uniform(4.5, 9.5), random.uniform(4.5, 9.5)},
                                    random.uniform(0.4, 1.4)),
           .reference = random.chance(0.3) ? ZoneReference::Centre : ZoneReference::Contour});
    }
    for (int i = random.integer(1, 3); i > 0; --i) {
      scenario.zones.push_back(
          {.kind = ZoneKind::SpeedLimit,
           .polygon = test::random_polygon(random, {random.uniform(3, 11), random.uniform(3, 11)},
                                           random.uniform(1.0, 4.0)),
           .reference = random.chance(0.3) ? ZoneReference::Centre : ZoneReference::Contour,
           .speed = random.uniform(0.15, 0.6)});
    }
    const EpisodeResult result = run_episode(scenario);
    expect_zones_kept(result);
    if (!result.robots.front().plan.usable()) continue;
    ++planned;
    reached += result.robots.front().reached ? 1 : 0;
    EXPECT_TRUE(result.robots.front().reached) << last_of(result);
  }
  EXPECT_GE(planned, static_cast<int>(robots.size()));
  EXPECT_EQ(reached, planned);
}

TEST(BodiesAmongZones, StripsAreNotLeft) {
  const auto robots = test::robot_presets();
  for (std::uint64_t seed = 0; seed < robots.size(); ++seed) {
    const test::NamedRobot& robot = robots[seed];
    SCOPED_TRACE(robot.name);
    Scenario scenario = body_floor(robot.model, {.position = {2.5, 2.5}, .heading = 0.0},
                                   {.position = {11.0, 11.0}, .heading = {}});
    const double half = robot.model.body.circumscribed_radius() + 0.4;
    const bool centre = seed % 2 == 1;
    const double width = centre ? 0.6 : half;
    scenario.zones = {{.kind = ZoneKind::Strip,
                       .polygon = test::strip_about({2.5, 2.5}, {11.0, 2.5}, width, width, half),
                       .reference = centre ? ZoneReference::Centre : ZoneReference::Contour},
                      {.kind = ZoneKind::Strip,
                       .polygon = test::strip_about({11.0, 2.5}, {11.0, 11.0}, width, width, half),
                       .reference = centre ? ZoneReference::Centre : ZoneReference::Contour}};
    const EpisodeResult result = run_episode(scenario);
    expect_zones_kept(result);
    EXPECT_TRUE(result.robots.front().reached) << last_of(result);
  }
}

// The direct path leads against the direction of the lane, so the robot drives around it.
TEST(BodiesAmongZones, OneWayZonesAreDrivenInTheirDirectionOnly) {
  for (const test::NamedRobot& robot : test::robot_presets()) {
    SCOPED_TRACE(robot.name);
    Scenario scenario = body_floor(robot.model, {.position = {2.0, 7.0}, .heading = 0.0},
                                   {.position = {12.0, 7.0}, .heading = {}});
    const test::Corners lane{{5.0, 5.0}, {9.0, 5.0}, {9.0, 9.0}, {5.0, 9.0}};
    scenario.zones = {{.kind = ZoneKind::OneWay, .polygon = lane, .direction = M_PI}};
    const EpisodeResult around = run_episode(scenario);
    expect_zones_kept(around);
    EXPECT_TRUE(around.robots.front().reached) << last_of(around);
    scenario.zones.front().direction = 0.0;
    const EpisodeResult through = run_episode(scenario);
    expect_zones_kept(through);
    EXPECT_TRUE(through.robots.front().reached) << last_of(through);
    EXPECT_LT(through.robots.front().length, around.robots.front().length - 0.5);
  }
}

}  // namespace
}  // namespace fairway
