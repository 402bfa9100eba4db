// SPDX-License-Identifier: Apache-2.0
// What becomes of an order that is taken, in every version.
#include <algorithm>

#include <gtest/gtest.h>

#include "vda5050/driving/fleet_double.hpp"

namespace fairway::vda5050::test {
namespace {

class Orders : public testing::TestWithParam<ProtocolVersion> {
 protected:
  FleetDouble fleet{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(Versions,
                         Orders,
                         testing::Values(ProtocolVersion::V2_0_0,
                                         ProtocolVersion::V2_1_0,
                                         ProtocolVersion::V3_0_0));

TEST_P(Orders, ListsAllNodesButTheFirst) {
  fleet.send_order({});
  const json state = fleet.state();
  EXPECT_EQ(state["orderId"], "lanes");
  EXPECT_EQ(state["lastNodeId"], "n0");
  ASSERT_EQ(state["nodeStates"].size(), 3U);
  EXPECT_EQ(state["nodeStates"][0]["nodeId"], "n1");
  EXPECT_EQ(state["edgeStates"].size(), 3U);
  EXPECT_TRUE(state["errors"].empty()) << state["errors"];
}

// The driver may stop at a node on the way; one report passes one node.
TEST_P(Orders, PassANodeAtWhichTheDriverStopped) {
  fleet.send_order({});
  fleet.drive(0.0, 1.9);
  EXPECT_EQ(fleet.state()["lastNodeId"], "n0");
  fleet.stop_at_node(1.9);
  EXPECT_EQ(fleet.state()["lastNodeId"], "n1");
  fleet.stop_at_node(2.9);
  EXPECT_EQ(fleet.state()["lastNodeId"], "n1");
}

TEST_P(Orders, RemoveNodesAndEdgesOnTheWay) {
  fleet.send_order({});
  fleet.drive(0.0, 2.5);
  const json state = fleet.state();
  EXPECT_EQ(state["lastNodeId"], "n1");
  EXPECT_EQ(state["lastNodeSequenceId"], 2);
  EXPECT_EQ(state["nodeStates"].size(), 2U);
  EXPECT_EQ(state["edgeStates"].size(), 2U);
  EXPECT_NEAR(state["distanceSinceLastNode"].get<double>(), 0.5, 0.15);
}

TEST_P(Orders, EndAtTheLastNodeOnlyOnArrival) {
  fleet.send_order({});
  fleet.drive(0.0, 6.0);
  EXPECT_FALSE(fleet.vehicle.idle());
  fleet.arrive(6.0);
  EXPECT_TRUE(fleet.vehicle.idle());
  EXPECT_EQ(fleet.state()["lastNodeId"], "n3");
}

TEST_P(Orders, NeverEnterTheHorizon) {
  fleet.send_order({.nodes = 4, .released = 2});
  ASSERT_EQ(fleet.vehicle.route().legs.size(), 1U);
  fleet.drive(0.0, 2.0);
  fleet.arrive(2.0);
  EXPECT_EQ(fleet.state()["lastNodeId"], "n1");
  EXPECT_FALSE(fleet.vehicle.idle());
  EXPECT_FALSE(fleet.vehicle.may_drive());
  EXPECT_EQ(fleet.state()["newBaseRequest"], true);
}

TEST_P(Orders, AreExtendedAtTheEndOfTheBase) {
  fleet.send_order({.nodes = 4, .released = 2});
  fleet.drive(0.0, 1.0);
  fleet.send_order({.update = 1, .first = 1, .nodes = 5, .released = 3});
  const json state = fleet.state();
  EXPECT_EQ(state["orderUpdateId"], 1);
  EXPECT_EQ(state["nodeStates"].size(), 5U);
  EXPECT_EQ(fleet.vehicle.route().legs.size(), 3U);
  EXPECT_TRUE(state["errors"].empty()) << state["errors"];
}

TEST_P(Orders, AreExtendedAfterTheEndToo) {
  fleet.send_order({.nodes = 2, .released = 2});
  fleet.drive(0.0, 2.0);
  fleet.arrive(2.0);
  ASSERT_TRUE(fleet.vehicle.idle());
  fleet.send_order({.update = 1, .first = 1, .nodes = 2, .released = 2});
  EXPECT_TRUE(fleet.vehicle.may_drive());
  EXPECT_EQ(fleet.state()["nodeStates"].size(), 1U);
}

TEST_P(Orders, LoseTheirHorizonByAnUpdateOfOneNode) {
  fleet.send_order({.nodes = 4, .released = 2});
  fleet.send_order({.update = 1, .first = 1, .nodes = 1, .released = 1});
  EXPECT_EQ(fleet.state()["nodeStates"].size(), 1U);
}

TEST_P(Orders, IgnoreARepeatedMessage) {
  fleet.send_order({});
  fleet.drive(0.0, 2.5);
  fleet.send_order({});
  EXPECT_TRUE(fleet.errors().empty());
  EXPECT_EQ(fleet.state()["nodeStates"].size(), 2U);
}

TEST_P(Orders, AreClearedByManualMode) {
  fleet.send_order({});
  fleet.vehicle.set_mode(OperatingMode::Manual);
  EXPECT_TRUE(fleet.vehicle.idle());
  EXPECT_FALSE(fleet.vehicle.may_drive());
}

TEST_P(Orders, NameTheEdgeWhoseCorridorIsLeft) {
  fleet.send_order({});
  fleet.drive(0.0, 1.0);
  fleet.move_to({1.0, 0.6});
  EXPECT_TRUE(fleet.has_error(Fault::OutsideCorridor));
  EXPECT_FALSE(fleet.vehicle.may_drive());
  const json error = fleet.state()["errors"][0];
  EXPECT_EQ(error["errorLevel"], fleet.third() ? "CRITICAL" : "WARNING");
  EXPECT_EQ(error["errorReferences"][0]["referenceValue"], "e0");
  fleet.move_to({1.0, 0.4});
  EXPECT_TRUE(fleet.errors().empty());
  EXPECT_TRUE(fleet.vehicle.may_drive());
}

TEST_P(Orders, WaitForAClosedCorridorAndThenGiveUp) {
  fleet.send_order({});
  const auto wait = [&](double seconds, bool gave_up) {
    fleet.time += seconds;
    VehicleMotion motion;
    fleet.vehicle.update(
        motion, {.route = fleet.vehicle.route_revision(), .closed_leg = 0, .gave_up = gave_up},
        fleet.time);
  };
  wait(0.0, false);
  EXPECT_TRUE(fleet.errors().empty());
  wait(4.0, false);
  EXPECT_TRUE(fleet.has_error(Fault::CorridorClosed));
  wait(20.0, true);
  EXPECT_EQ(fleet.errors(), std::vector<std::string>{fleet.type(Fault::NodeUnreachable)});
  EXPECT_FALSE(fleet.vehicle.may_drive());
  EXPECT_EQ(fleet.state()["errors"][0]["errorReferences"][0]["referenceValue"], "n1");
  fleet.send_instant("cancelOrder", "c");
  EXPECT_TRUE(fleet.errors().empty());
  EXPECT_TRUE(fleet.vehicle.idle());
}

}  // namespace
}  // namespace fairway::vda5050::test
