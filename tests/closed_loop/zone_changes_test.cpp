// SPDX-License-Identifier: Apache-2.0
// Zones and holds that are set while a robot drives, and one-way zones.
#include <cmath>

#include <gtest/gtest.h>

#include "fairway/navigation/facade/map_navigator.hpp"
#include "fairway/simulation/episode.hpp"
#include "fairway/zones/zone_map.hpp"
#include "support/oracles/zone_oracle.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

class ZoneChanges : public ::testing::Test {
 protected:
  ZoneChanges()
      : navigator_(settings(),
                   OccupancyGrid({.width = 240, .height = 120, .resolution = 0.05, .origin = {}})) {
    robot_.pose = {.position = {1.0, 3.0}, .heading = 0.0};
    robot_.limits = limits_of(settings().robot);
    navigator_.set_goal({.position = {11.0, 3.0}, .heading = {}});
  }

  static Settings settings() {
    Settings settings;
    settings.robot.radius = 0.3;
    return settings;
  }

  NavigationStep cycle() {
    const NavigationStep step = navigator_.update({.time = time_, .pose = robot_.pose});
    robot_.advance(step.command, settings().navigation.control_period);
    time_ += settings().navigation.control_period;
    return step;
  }

  // Drives until `done` holds for a step, at most 60 s. @return whether it did.
  template <typename Done>
  bool drive_until(Done&& done) {
    for (int i = 0; i < 1200; ++i) {
      if (done(cycle())) return true;
    }
    return false;
  }

  bool reaches_goal() {
    return drive_until(
        [](const NavigationStep& step) { return step.status == NavigationStatus::GoalReached; });
  }

  MapNavigator navigator_;
  UnicycleRobot robot_;
  double time_ = 0.0;
};

TEST_F(ZoneChanges, AHoldStopsAlongTheCorridorAndKeepsTheGoal) {
  ASSERT_TRUE(drive_until([&](const NavigationStep&) { return robot_.pose.position.x() > 4.0; }));
  ASSERT_GT(robot_.twist.linear, 0.5);
  navigator_.hold();
  double last = robot_.twist.linear;
  ASSERT_TRUE(drive_until([&](const NavigationStep& step) {
    EXPECT_EQ(step.status, NavigationStatus::Holding);
    EXPECT_EQ(step.limit, LimitingFactor::Hold);
    EXPECT_LE(step.command.linear, last + 1e-9);
    last = step.command.linear;
    return robot_.twist.linear == 0.0;
  }));
  const Vector2d place = robot_.pose.position;
  EXPECT_NEAR(place.y(), 3.0, 0.05);
  EXPECT_LT(place.x(), 6.0);
  for (int i = 0; i < 100; ++i) {
    const NavigationStep step = cycle();
    EXPECT_EQ(step.status, NavigationStatus::Holding);
    EXPECT_EQ(step.command.linear, 0.0);
  }
  EXPECT_EQ(robot_.pose.position, place);
  navigator_.resume();
  EXPECT_TRUE(reaches_goal());
}

TEST_F(ZoneChanges, AKeepOutInFrontOfTheRobotIsDrivenAround) {
  ASSERT_TRUE(drive_until([&](const NavigationStep&) { return robot_.pose.position.x() > 3.0; }));
  const test::Corners polygon{{5.0, 2.0}, {6.0, 2.0}, {6.0, 4.0}, {5.0, 4.0}};
  navigator_.set_zones({{.kind = ZoneKind::KeepOut, .polygon = polygon}});
  const bool reached = drive_until([&](const NavigationStep& step) {
    EXPECT_LE(test::depth_in(polygon, robot_.pose.position), 1e-6 - 0.3);
    return step.status == NavigationStatus::GoalReached;
  });
  EXPECT_TRUE(reached);
}

TEST_F(ZoneChanges, AZoneRightInFrontStopsTheRobotByName) {
  ASSERT_TRUE(drive_until([&](const NavigationStep&) { return robot_.pose.position.x() > 5.0; }));
  // It cannot brake before this zone, and stops partly inside it.
  const double x = robot_.pose.position.x() + 0.32;
  navigator_.set_zones(
      {{.kind = ZoneKind::KeepOut, .polygon = {{x, -1.0}, {x + 9, -1.0}, {x + 9, 7.0}, {x, 7.0}}}});
  bool named = false;
  for (int i = 0; i < 200; ++i)
    named = cycle().limit == LimitingFactor::KeepOutZone || named;
  EXPECT_TRUE(named);
  EXPECT_EQ(robot_.twist.linear, 0.0);
  EXPECT_LT(robot_.pose.position.x(), x + 0.7);
  navigator_.set_zones({});
  EXPECT_TRUE(reaches_goal());
}

TEST_F(ZoneChanges, ARobotOutsideOfNewStripsStaysThere) {
  ASSERT_TRUE(drive_until([&](const NavigationStep&) { return robot_.pose.position.x() > 5.0; }));
  navigator_.set_zones({{.kind = ZoneKind::Strip,
                         .polygon = {{0, 0}, {12, 0}, {12, 1}, {0, 1}},
                         .reference = ZoneReference::Centre}});
  bool named = false;
  for (int i = 0; i < 200; ++i)
    named = cycle().limit == LimitingFactor::Strip || named;
  EXPECT_TRUE(named);
  EXPECT_EQ(robot_.twist.linear, 0.0);
}

TEST_F(ZoneChanges, ASpeedZoneIsNamedWhereItSlowsTheRobot) {
  navigator_.set_zones(
      {{.kind = ZoneKind::SpeedLimit, .polygon = {{5, 0}, {8, 0}, {8, 6}, {5, 6}}, .speed = 0.3}});
  int named = 0;
  const bool reached = drive_until([&](const NavigationStep& step) {
    if (step.limit == LimitingFactor::SpeedZone) ++named;
    return step.status == NavigationStatus::GoalReached;
  });
  EXPECT_TRUE(reached);
  EXPECT_GT(named, 50) << "3 m at 0.3 m/s take a hundred cycles";
}

TEST_F(ZoneChanges, AOneWayZoneAgainstTheRobotStopsItByName) {
  ASSERT_TRUE(drive_until([&](const NavigationStep&) { return robot_.pose.position.x() > 5.0; }));
  navigator_.set_zones({{.kind = ZoneKind::OneWay,
                         .polygon = {{0, 0}, {12, 0}, {12, 6}, {0, 6}},
                         .direction = 3.141592653589793}});
  EXPECT_EQ(cycle().limit, LimitingFactor::OneWayZone);
  for (int i = 0; i < 50; ++i)
    cycle();
  EXPECT_EQ(robot_.twist.linear, 0.0);
}

TEST_F(ZoneChanges, FaultyZonesAreRefusedAndChangeNothing) {
  navigator_.set_zones({{.kind = ZoneKind::KeepOut, .polygon = {{5, 2}, {6, 2}, {6, 4}, {5, 4}}}});
  EXPECT_THROW(navigator_.set_zones({{.polygon = {{0, 0}, {1, 1}}}}), std::invalid_argument);
  ASSERT_TRUE(reaches_goal());
  EXPECT_GT(navigator_.plan().path.length(), 10.0);
}

double length_of_run(double from, double to) {
  Scenario scenario;
  scenario.map = OccupancyGrid({.width = 240, .height = 160, .resolution = 0.05, .origin = {}});
  scenario.settings.robot.radius = 0.3;
  scenario.time_limit = 60.0;
  scenario.robots = {{.name = "robot",
                      .start = {.position = {from, 4.0}, .heading = from < to ? 0.0 : 3.1},
                      .goal = {.position = {to, 4.0}, .heading = {}}}};
  scenario.zones = {{.kind = ZoneKind::OneWay,
                     .polygon = {{3, 2.5}, {9, 2.5}, {9, 5.5}, {3, 5.5}},
                     .direction = 0.0}};
  const EpisodeResult result = run_episode(scenario);
  EXPECT_TRUE(result.success) << to_text(result.trace.rows.back().status) << ", "
                              << to_text(result.trace.rows.back().limit);
  EXPECT_LE(result.robots.front().zones.against_lanes, 1e-6);
  return result.robots.front().length;
}

TEST(OneWayZones, AreDrivenAlongAndNotAgainst) {
  EXPECT_LT(length_of_run(1.0, 11.0), 10.1);
  EXPECT_GT(length_of_run(11.0, 1.0), 10.3);
}

TEST(PenaltiesAndPreferences, MoveThePath) {
  const OccupancyGrid map({.width = 240, .height = 160, .resolution = 0.05, .origin = {}});
  const auto highest = [&](const Zones& zones) {
    BitGrid bits(map);
    bits.set_zones(std::make_shared<const ZoneMap>(zones, 0.3));
    const PreparedMap prepared(std::move(bits));
    Planner planner;
    const Plan plan = planner.plan(prepared, {1.0, 4.0}, {.position = {11.0, 4.0}, .heading = {}},
                                   {.radius = 0.3});
    EXPECT_TRUE(plan.usable());
    double most = 0.0;
    for (const Vector2d& point : plan.path.waypoints)
      most = std::max(most, std::abs(point.y() - 4.0));
    return most;
  };
  EXPECT_LT(highest({}), 1e-6);
  const test::Corners middle{{5, 3}, {7, 3}, {7, 5}, {5, 5}};
  EXPECT_GT(highest({{.kind = ZoneKind::Penalty, .polygon = middle, .weight = 4}}), 0.95);
  EXPECT_LT(highest({{.kind = ZoneKind::Penalty, .polygon = middle, .weight = 0.01}}), 0.2);
  const test::Corners lane{{0, 5}, {12, 5}, {12, 6}, {0, 6}};
  EXPECT_GT(highest({{.kind = ZoneKind::Preferred, .polygon = lane, .weight = 2}}), 0.95);
}

}  // namespace
}  // namespace fairway
