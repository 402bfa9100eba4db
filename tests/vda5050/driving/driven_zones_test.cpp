// SPDX-License-Identifier: Apache-2.0
// Zones of version 3 that need leave, or have a direction, under a robot that drives.
#include <gtest/gtest.h>

#include "simulated_run.hpp"

namespace fairway::vda5050::test {
namespace {

OccupancyGrid wide_hall() {
  return OccupancyGrid(
      {.width = 240, .height = 120, .resolution = 0.05, .origin = {{-2.0, -3.0}, 0.0}});
}

// Enables one zone from x = 2.5 to x = 4, and from y = -2 to `top`.
void enable(SimulatedRun& run, json zone, double top) {
  zone["zoneId"] = "z";
  zone["vertices"] = {{{"x", 2.5}, {"y", -2.0}},
                      {{"x", 4.0}, {"y", -2.0}},
                      {{"x", 4.0}, {"y", top}},
                      {{"x", 2.5}, {"y", top}}};
  json message = run.messages.header();
  message["zoneSet"] = {
      {"mapId", "floor"}, {"zoneSetId", "day"}, {"zones", json::array({std::move(zone)})}};
  run.send(Topic::ZoneSet, message);
  run.send(Topic::InstantActions,
           run.messages.instant("enableZoneSet", "e", {{"zoneSetId", "day"}}));
}

double furthest(const SimulatedRun& run) {
  double x = -10.0;
  for (const Eigen::Vector2d& place : run.places)
    x = std::max(x, place.x());
  return x;
}

TEST(DrivenZones, AreEnteredOnlyWithLeave) {
  SimulatedRun run(ProtocolVersion::V3_0_0, {}, wide_hall());
  enable(run, {{"zoneType", "RELEASE"}, {"releaseLossBehavior", "STOP"}}, 2.0);
  run.send(Topic::Order, run.messages.lanes({}));
  constexpr int kLongWait = 400;  // cycles of 0.1 s: longer than the patience at an obstacle
  for (int i = 0; i < kLongWait; ++i)
    run.cycle();
  EXPECT_LE(furthest(run), 2.5 - 0.25 + 1e-6) << "no part of the body is inside";
  EXPECT_GT(furthest(run), 1.5) << "the robot drives up to the zone";
  EXPECT_TRUE(run.vehicle.state().errors.empty());
  json answer = run.messages.header();
  answer["responses"] = json::array();
  ASSERT_EQ(run.vehicle.state().zone_requests.size(), 1U);
  for (const ZoneRequest& request : run.vehicle.state().zone_requests)
    answer["responses"].push_back({{"requestId", request.id}, {"grantType", "GRANTED"}});
  run.send(Topic::Responses, answer);
  run.until_idle();
  EXPECT_EQ(run.vehicle.state().last_node_id, "n3");
  EXPECT_TRUE(run.vehicle.state().errors.empty());
}

// The order leads through the zone along x, and leaves the robot its path.
json free_order(const SimulatedRun& run) {
  json order = run.messages.lanes({.id = "free", .nodes = 2, .released = 2});
  order["nodes"][1]["nodePosition"]["x"] = 6.0;
  order["edges"][0].erase("corridor");
  return order;
}

double least_y_inside(const SimulatedRun& run) {
  double least = 10.0;
  for (const Eigen::Vector2d& place : run.places) {
    if (place.x() > 2.6 && place.x() < 3.9) least = std::min(least, place.y());
  }
  return least;
}

TEST(DrivenZones, AreDrivenInTheirDirectionOnly) {
  constexpr double kBack = 3.141592653589793;
  for (const char* limit : {"SOFT", "RESTRICTED", "STRICT"}) {
    for (const double direction : {0.0, kBack}) {
      SCOPED_TRACE(std::string(limit) + " " + std::to_string(direction));
      SimulatedRun run(ProtocolVersion::V3_0_0, {}, wide_hall());
      enable(run,
             {{"zoneType", "DIRECTED"}, {"direction", direction}, {"directedLimitation", limit}},
             0.8);
      run.send(Topic::Order, free_order(run));
      run.until_idle();
      EXPECT_TRUE(run.vehicle.state().errors.empty());
      const bool may_enter =
          std::string(limit) == "SOFT" || (std::string(limit) == "RESTRICTED" && direction == 0.0);
      if (may_enter) {
        EXPECT_LT(least_y_inside(run), 0.3) << limit << " " << direction;
      } else {
        EXPECT_GT(least_y_inside(run), 0.75) << limit << " " << direction;
      }
    }
  }
}

TEST(DrivenZones, RefuseACorridorAgainstTheirDirection) {
  SimulatedRun run(ProtocolVersion::V3_0_0, {}, wide_hall());
  enable(run,
         {{"zoneType", "DIRECTED"},
          {"direction", 3.141592653589793},
          {"directedLimitation", "RESTRICTED"}},
         2.0);
  run.send(Topic::Order, run.messages.lanes({}));
  EXPECT_TRUE(run.has_error(Fault::NoRoute));
}

TEST(DrivenZones, AreDrivenInACorridorAlongTheirDirection) {
  SimulatedRun run(ProtocolVersion::V3_0_0, {}, wide_hall());
  enable(run, {{"zoneType", "DIRECTED"}, {"direction", 0.0}, {"directedLimitation", "RESTRICTED"}},
         2.0);
  run.send(Topic::Order, run.messages.lanes({}));
  run.until_idle();
  EXPECT_EQ(run.vehicle.state().last_node_id, "n3");
  EXPECT_TRUE(run.vehicle.state().errors.empty());
}

}  // namespace
}  // namespace fairway::vda5050::test
