// SPDX-License-Identifier: Apache-2.0
#include "bridge/polygon_text.hpp"

#include <gtest/gtest.h>

#include "pilot/pilot_rig.hpp"

namespace fairway::bridge {
namespace {

using test::Rig;
using test::room;

TEST(PolygonText, ReadsThePolygonsOfParameters) {
  const auto polygon = polygon_of("zone", " [[0.5, -1e-1],[2,0] , [ 2, 1.5 ]] ");
  ASSERT_TRUE(polygon);
  ASSERT_EQ(polygon->size(), 3U);
  EXPECT_EQ((*polygon)[0], Eigen::Vector2d(0.5, -0.1));
  EXPECT_EQ((*polygon)[2], Eigen::Vector2d(2.0, 1.5));
  EXPECT_TRUE(polygon_of("zone", "")->empty());
  EXPECT_TRUE(polygon_of("zone", "[]")->empty());
}

TEST(PolygonText, RefusesOthersInOneLine) {
  for (const char* text : {"[[0, 0], [1, 0]]", "[[0, 0], [1, 0], [1]]", "[0, 0, 1, 0, 1, 1]",
                           "[[0, 0], [1, 0], [1, nan]]", "[[0, 0], [1, 0], [1, 1]] x", "[[0 0]]",
                           "a mapping", "[[0, 0], [1, 0], [1, 1]", "[[0, 0], [1, 0], [1, inf]]"}) {
    const auto polygon = polygon_of("monitor_stop_zone", text);
    ASSERT_FALSE(polygon) << text;
    EXPECT_EQ(polygon.error().message.find("monitor_stop_zone: expected a polygon"), 0U);
  }
}

TEST(PilotOptions, RefuseZonesThatNoMonitorLooksAt) {
  PilotOptions options;
  options.monitor_stop_zone = {{0.3, -0.3}, {0.8, -0.3}, {0.8, 0.3}};
  EXPECT_TRUE(validate(options));
  for (bool PilotOptions::*needed : {&PilotOptions::use_monitor, &PilotOptions::use_scan}) {
    PilotOptions without = options;
    without.*needed = false;
    EXPECT_FALSE(validate(without));
  }
  PilotOptions car = options;
  car.body = RobotModel{.base = {.kind = BaseKind::Car}};
  EXPECT_FALSE(validate(car));
  options.monitor_slow_speed = 0.0;
  EXPECT_FALSE(validate(options));
  options = {};
  options.monitor_slow_zone = {{0.0, 0.0}, {0.0, 0.0}, {1.0, 1.0}};
  EXPECT_FALSE(validate(options));
}

// A slow zone that always holds a wall of the room.
TEST(Pilot, ObeysTheZonesOfItsMonitor) {
  PilotOptions options{.plan_in_background = false};
  options.monitor_slow_zone = {{-9.0, -9.0}, {9.0, -9.0}, {9.0, 9.0}, {-9.0, 9.0}};
  options.monitor_slow_speed = 0.2;
  Rig rig(options);
  rig.pilot.set_goal({.position = {3.5, 1.5}, .heading = {}});
  double fastest = 0.0;
  PilotStep last;
  while (rig.world.time() < 60.0 && last.end == GoalEnd::None) {
    last = rig.step();
    fastest = std::max(fastest, std::abs(last.command.linear));
  }
  EXPECT_EQ(last.end, GoalEnd::Reached);
  EXPECT_LE(fastest, 0.2 + 1e-9);
  EXPECT_GT(fastest, 0.19);
  options.monitor_stop_zone = options.monitor_slow_zone;
  Rig stopped(options);
  stopped.pilot.set_goal({.position = {3.5, 1.5}, .heading = {}});
  EXPECT_EQ(stopped.drive(2.0).monitor, MonitorReason::StopZone);
  EXPECT_EQ(stopped.speed(), 0.0);
}

}  // namespace
}  // namespace fairway::bridge
