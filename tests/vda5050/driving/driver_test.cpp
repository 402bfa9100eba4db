// SPDX-License-Identifier: Apache-2.0
// Orders that are driven in the simulator, without a broker.
#include <algorithm>

#include <gtest/gtest.h>

#include "simulated_run.hpp"

namespace fairway::vda5050::test {
namespace {

// A hall of 14 m by 6 m with its corner at (-2, -3), and a block in it if wanted.
OccupancyGrid hall(const std::optional<OrientedRectangle>& block = {}) {
  OccupancyGrid grid(
      {.width = 280, .height = 120, .resolution = 0.05, .origin = {{-2.0, -3.0}, 0.0}});
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 280; ++x) {
      const CellIndex cell{.x = x, .y = y};
      const bool wall = x == 0 || y == 0 || x == 279 || y == 119;
      const bool blocked = block && block->contains(grid.frame().center(cell));
      grid.set(cell, wall || blocked ? CellState::Occupied : CellState::Free);
    }
  }
  return grid;
}

OrientedRectangle box(double x0, double y0, double x1, double y1) {
  OrientedRectangle rectangle;
  rectangle.min = {x0, y0};
  rectangle.max = {x1, y1};
  return rectangle;
}

class DrivenOrders : public testing::TestWithParam<ProtocolVersion> {};

INSTANTIATE_TEST_SUITE_P(Versions,
                         DrivenOrders,
                         testing::Values(ProtocolVersion::V2_1_0, ProtocolVersion::V3_0_0));

TEST_P(DrivenOrders, FlowThroughTheirNodes) {
  SimulatedRun run(GetParam(), {}, hall());
  run.send(Topic::Order, run.messages.lanes({.nodes = 5, .released = 5}));
  run.until_idle();
  EXPECT_EQ(run.vehicle.state().last_node_id, "n4");
  EXPECT_EQ(run.stops, 1);
  EXPECT_LT(run.widest(), 0.1);
}

TEST_P(DrivenOrders, PassAnObstacleInsideTheirCorridor) {
  SimulatedRun run(GetParam(), {}, hall(box(2.6, -3.0, 3.4, 0.2)));
  run.send(Topic::Order, run.messages.lanes({.width = 0.7}));
  run.until_idle();
  EXPECT_GT(run.widest(), 0.45);
  EXPECT_LE(run.widest(), 0.7 + 0.03);
}

TEST_P(DrivenOrders, AreRefusedIfTheMapClosesTheirCorridor) {
  SimulatedRun run(GetParam(), {}, hall(box(2.6, -3.0, 3.4, 0.4)));
  run.send(Topic::Order, run.messages.lanes({.width = 0.6}));
  EXPECT_TRUE(run.has_error(Fault::NoRoute));
}

TEST_P(DrivenOrders, KeepTheBodyInsideACorridorOfTheContour) {
  SimulatedRun run(GetParam(), {}, hall(box(2.6, -3.0, 3.4, 0.1)));
  json order = run.messages.lanes({.width = 0.8});
  const char* key = run.messages.third() ? "corridorReferencePoint" : "corridorRefPoint";
  for (json& edge : order["edges"])
    edge["corridor"][key] = "CONTOUR";
  run.send(Topic::Order, order);
  run.until_idle();
  EXPECT_GT(run.widest(), 0.35);
  EXPECT_LE(run.widest(), 0.8 - 0.25 + 0.03);
}

TEST_P(DrivenOrders, StopAtTheEndOfTheBase) {
  SimulatedRun run(GetParam(), {}, hall());
  run.send(Topic::Order, run.messages.lanes({.nodes = 5, .released = 3}));
  run.until([&] { return run.vehicle.state().last_node_id == "n2"; });
  for (int i = 0; i < 20; ++i)
    run.cycle();
  EXPECT_LE(run.furthest(), 4.1);
  EXPECT_FALSE(run.vehicle.idle());
  run.send(Topic::Order, run.messages.lanes({.update = 1, .first = 2, .nodes = 3, .released = 3}));
  run.until_idle();
  EXPECT_EQ(run.vehicle.state().last_node_id, "n4");
}

TEST_P(DrivenOrders, ContinueWithoutAStopAfterAnUpdateInTime) {
  SimulatedRun run(GetParam(), {}, hall());
  run.send(Topic::Order, run.messages.lanes({.nodes = 5, .released = 3}));
  run.until([&] { return run.vehicle.state().last_node_id == "n1"; });
  run.send(Topic::Order, run.messages.lanes({.update = 1, .first = 2, .nodes = 3, .released = 3}));
  run.until_idle();
  EXPECT_EQ(run.stops, 1);
}

TEST_P(DrivenOrders, KeepTheSpeedOfTheirEdges) {
  SimulatedRun run(GetParam(), {}, hall());
  json order = run.messages.lanes({.nodes = 4, .released = 4});
  order["edges"][1][run.messages.third() ? "maximumSpeed" : "maxSpeed"] = 0.4;
  run.send(Topic::Order, order);
  run.until_idle();
  double slow = 0.0;
  for (std::size_t i = 0; i < run.places.size(); ++i) {
    if (run.places[i].x() > 2.0 && run.places[i].x() < 4.0) slow = std::max(slow, run.speeds[i]);
  }
  EXPECT_LE(slow, 0.4 + 1e-3);
  EXPECT_GT(*std::max_element(run.speeds.begin(), run.speeds.end()), 0.8);
}

TEST_P(DrivenOrders, PauseAndContinue) {
  SimulatedRun run(GetParam(), {}, hall());
  run.send(Topic::Order, run.messages.lanes({}));
  run.until([&] { return run.places.back().x() > 1.0; });
  run.send(Topic::InstantActions, run.messages.instant("startPause", "p"));
  run.until([&] { return run.vehicle.state().instant_actions[0].done(); });
  const Eigen::Vector2d here = run.places.back();
  for (int i = 0; i < 10; ++i)
    run.cycle();
  EXPECT_EQ(run.places.back(), here);
  run.send(Topic::InstantActions, run.messages.instant("stopPause", "q"));
  run.until_idle();
  EXPECT_EQ(run.vehicle.state().last_node_id, "n3");
}

TEST_P(DrivenOrders, EndWhereTheyAreCancelled) {
  SimulatedRun run(GetParam(), {}, hall());
  run.send(Topic::Order, run.messages.lanes({}));
  run.until([&] { return run.places.back().x() > 1.0; });
  run.send(Topic::InstantActions, run.messages.instant("cancelOrder", "c"));
  run.until_idle();
  EXPECT_LT(run.places.back().x(), 2.0);
  json next = run.messages.lanes({.id = "next", .first = 0, .nodes = 3, .released = 3});
  next["nodes"][0]["nodePosition"]["allowedDeviationXY"] = run.messages.deviation(2.0);
  run.send(Topic::Order, next);
  run.until_idle();
  EXPECT_EQ(run.vehicle.state().last_node_id, "n2");
}

TEST_P(DrivenOrders, TurnOnTheSpot) {
  SimulatedRun run(GetParam(), {}, hall());
  json order = run.messages.lanes({.nodes = 2, .released = 2});
  order["nodes"][1]["nodePosition"]["x"] = 0.0;
  order["nodes"][1]["nodePosition"]["theta"] = 1.57;
  order["nodes"][1]["nodePosition"]["allowedDeviationTheta"] = 0.1;
  run.send(Topic::Order, order);
  run.until_idle();
  EXPECT_EQ(run.vehicle.state().last_node_id, "n1");
  EXPECT_NEAR(run.vehicle.state().motion.pose.heading, 1.57, 0.12);
}

TEST_P(DrivenOrders, WaitForAnObstacleThatTheMapDoesNotHave) {
  SimulatedRun run(GetParam(), {}, hall(box(3.0, -3.0, 3.4, 3.0)), Sensing::Lidar, hall());
  run.send(Topic::Order, run.messages.lanes({}));
  run.until([&] { return run.has_error(Fault::CorridorClosed); });
  run.until([&] { return run.has_error(Fault::NodeUnreachable); });
  EXPECT_LE(run.widest(), 0.53);
  EXPECT_FALSE(run.vehicle.may_drive());
}

TEST(DrivenOrdersOfVersion3, GoRoundABlockedZone) {
  SimulatedRun run(ProtocolVersion::V3_0_0, {}, hall());
  json zones = run.messages.header();
  zones["zoneSet"] = {{"mapId", "floor"}, {"zoneSetId", "day"}, {"zones", json::array()}};
  zones["zoneSet"]["zones"].push_back({{"zoneId", "wet"},
                                       {"zoneType", "BLOCKED"},
                                       {"vertices",
                                        {{{"x", 2.7}, {"y", -2.0}},
                                         {{"x", 3.3}, {"y", -2.0}},
                                         {{"x", 3.3}, {"y", 0.5}},
                                         {{"x", 2.7}, {"y", 0.5}}}}});
  run.send(Topic::ZoneSet, zones);
  run.send(Topic::InstantActions,
           run.messages.instant("enableZoneSet", "e", {{"zoneSetId", "day"}}));
  run.send(Topic::Order, run.messages.lanes({.id = "narrow", .width = 0.6}));
  EXPECT_TRUE(run.has_error(Fault::NoRoute));
  json free = run.messages.lanes({.id = "free"});
  for (json& edge : free["edges"])
    edge.erase("corridor");
  run.send(Topic::Order, free);
  run.until_idle();
  EXPECT_EQ(run.vehicle.state().last_node_id, "n3");
  for (const Eigen::Vector2d& place : run.places) {
    if (place.x() > 2.7 && place.x() < 3.3) {
      EXPECT_GT(place.y(), 0.75 - 1e-6);
    }
  }
}

TEST(DrivenOrdersOfVersion3, GoAroundAZoneWithAPenalty) {
  SimulatedRun run(ProtocolVersion::V3_0_0, {}, hall());
  json zones = run.messages.header();
  zones["zoneSet"] = {{"mapId", "floor"}, {"zoneSetId", "day"}, {"zones", json::array()}};
  zones["zoneSet"]["zones"].push_back({{"zoneId", "busy"},
                                       {"zoneType", "PENALTY"},
                                       {"penaltyFactor", 0.9},
                                       {"vertices",
                                        {{{"x", 2.5}, {"y", -2.0}},
                                         {{"x", 4.0}, {"y", -2.0}},
                                         {{"x", 4.0}, {"y", 0.6}},
                                         {{"x", 2.5}, {"y", 0.6}}}}});
  run.send(Topic::ZoneSet, zones);
  run.send(Topic::InstantActions,
           run.messages.instant("enableZoneSet", "e", {{"zoneSetId", "day"}}));
  json order = run.messages.lanes({.id = "free", .nodes = 2, .released = 2});
  order["nodes"][1]["nodePosition"]["x"] = 6.0;
  order["edges"][0].erase("corridor");
  run.send(Topic::Order, order);
  run.until_idle();
  for (const Eigen::Vector2d& place : run.places) {
    if (place.x() > 2.5 && place.x() < 4.0) {
      EXPECT_GT(place.y(), 0.6 - 0.05) << place.x();
    }
  }
}

TEST(DrivenOrdersOfVersion3, StayOnTheLineUntilTheyHaveLeave) {
  SimulatedRun run(ProtocolVersion::V3_0_0, {}, hall(box(2.6, -3.0, 3.4, 0.2)));
  run.send(Topic::Order, run.messages.lanes({.width = 0.8, .release_required = true}));
  for (int i = 0; i < 100; ++i)
    run.cycle();
  EXPECT_LE(run.widest(), kLineTolerance + 0.03);
  EXPECT_TRUE(run.vehicle.state().errors.empty());
  json answer = run.messages.header();
  answer["responses"] = json::array();
  for (const EdgeRequest& request : run.vehicle.state().edge_requests)
    answer["responses"].push_back({{"requestId", request.id}, {"grantType", "GRANTED"}});
  run.send(Topic::Responses, answer);
  run.until([&] { return run.vehicle.state().last_node_id == "n2"; });
  EXPECT_LE(run.widest(), 0.83);
}

json answers(const SimulatedRun& run, const char* grant) {
  json message = run.messages.header();
  message["responses"] = json::array();
  for (const EdgeRequest& request : run.vehicle.state().edge_requests)
    message["responses"].push_back({{"requestId", request.id}, {"grantType", grant}});
  return message;
}

// Drives beside the line with leave, and then loses it.
void lose_leave(SimulatedRun& run, const char* behavior) {
  json order = run.messages.lanes({.width = 0.8, .release_required = true});
  for (json& edge : order["edges"])
    edge["corridor"]["releaseLossBehavior"] = behavior;
  run.send(Topic::Order, order);
  run.cycle();
  run.send(Topic::Responses, answers(run, "GRANTED"));
  run.until([&] { return run.widest() > 0.4; });
  run.send(Topic::Responses, answers(run, "REVOKED"));
  run.cycle();
  EXPECT_TRUE(run.has_error(Fault::ReleaseLost));
}

TEST(DrivenOrdersOfVersion3, ReturnToTheLineWhenTheyLoseTheirLeave) {
  SimulatedRun run(ProtocolVersion::V3_0_0, {}, hall(box(2.6, -3.0, 3.4, 0.2)));
  lose_leave(run, "RETURN");
  run.until([&] { return !run.has_error(Fault::ReleaseLost) && !run.driving(); });
  EXPECT_LE(std::abs(run.places.back().y()), kLineTolerance + 0.03);
  EXPECT_LT(run.places.back().x(), 2.6);
  EXPECT_STREQ(run.vehicle.state().edge_requests[0].edge_id.c_str(), "e1");
}

TEST(DrivenOrdersOfVersion3, StopWhereTheyLoseTheirLeave) {
  SimulatedRun run(ProtocolVersion::V3_0_0, {}, hall(box(2.6, -3.0, 3.4, 0.2)));
  lose_leave(run, "STOP");
  run.until([&] { return !run.driving(); });
  const Eigen::Vector2d here = run.places.back();
  for (int i = 0; i < 20; ++i)
    run.cycle();
  EXPECT_EQ(run.places.back(), here);
  EXPECT_TRUE(run.has_error(Fault::ReleaseLost));
}

}  // namespace
}  // namespace fairway::vda5050::test
