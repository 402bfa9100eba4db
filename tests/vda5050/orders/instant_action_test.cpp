// SPDX-License-Identifier: Apache-2.0
// Instant actions: cancel, pause, initial position, and their states.
#include <gtest/gtest.h>

#include "vda5050/driving/fleet_double.hpp"

namespace fairway::vda5050::test {
namespace {

class InstantActions : public testing::TestWithParam<ProtocolVersion> {
 protected:
  FleetDouble fleet{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(Versions,
                         InstantActions,
                         testing::Values(ProtocolVersion::V2_1_0, ProtocolVersion::V3_0_0));

TEST_P(InstantActions, CancelOrderWaitsForStandstill) {
  fleet.send_order({});
  fleet.drive(0.0, 1.0);
  fleet.send_instant("cancelOrder", "c");
  EXPECT_EQ(fleet.instant_status("c"), "RUNNING");
  EXPECT_FALSE(fleet.vehicle.may_drive());
  EXPECT_TRUE(fleet.vehicle.route().legs.empty());
  fleet.move_to({1.2, 0.0});
  EXPECT_EQ(fleet.instant_status("c"), "FINISHED");
  const json state = fleet.state();
  EXPECT_TRUE(state["nodeStates"].empty());
  EXPECT_TRUE(state["edgeStates"].empty());
  EXPECT_EQ(state["orderId"], "lanes");
  EXPECT_EQ(state["lastNodeId"], "n0");
  fleet.send_order({.update = 1, .first = 3, .nodes = 2, .released = 2});
  EXPECT_EQ(fleet.errors(), std::vector<std::string>{fleet.type(Fault::UpdateAfterCancel)});
}

TEST_P(InstantActions, CancelOrderWithoutAnOrderFails) {
  fleet.send_instant("cancelOrder", "c");
  EXPECT_EQ(fleet.instant_status("c"), "FAILED");
  EXPECT_EQ(fleet.errors(), std::vector<std::string>{fleet.type(Fault::NothingToCancel)});
  EXPECT_EQ(fleet.state()["errors"][0]["errorReferences"][0]["referenceValue"], "c");
  fleet.send_instant("stateRequest", "s");
  EXPECT_TRUE(fleet.errors().empty());
}

TEST_P(InstantActions, ANewOrderStartsAfterACancelledOne) {
  fleet.send_order({});
  fleet.send_instant("cancelOrder", "c");
  fleet.send_order({.id = "next"});
  EXPECT_TRUE(fleet.errors().empty());
  EXPECT_EQ(fleet.state()["orderId"], "next");
}

TEST_P(InstantActions, PauseFinishesAtStandstillAndKeepsTheOrder) {
  fleet.send_order({});
  fleet.drive(0.0, 1.0);
  fleet.send_instant("startPause", "p");
  EXPECT_EQ(fleet.instant_status("p"), "RUNNING");
  EXPECT_EQ(fleet.state()["paused"], true);
  EXPECT_FALSE(fleet.vehicle.may_drive());
  fleet.move_to({1.2, 0.0});
  EXPECT_EQ(fleet.instant_status("p"), "FINISHED");
  fleet.send_instant("stopPause", "q");
  EXPECT_EQ(fleet.instant_status("q"), "FINISHED");
  EXPECT_TRUE(fleet.vehicle.may_drive());
  EXPECT_EQ(fleet.state()["paused"], false);
}

TEST_P(InstantActions, OrdersAreTakenWhilePaused) {
  fleet.send_instant("startPause", "p");
  fleet.send_order({});
  EXPECT_EQ(fleet.state()["orderId"], "lanes");
  EXPECT_FALSE(fleet.vehicle.may_drive());
}

TEST_P(InstantActions, OfUnknownTypeFailAndAreNamed) {
  fleet.send_instant("liftTheRoof", "x-1");
  EXPECT_EQ(fleet.instant_status("x-1"), "FAILED");
  EXPECT_EQ(fleet.errors(), std::vector<std::string>{fleet.type(Fault::InvalidAction)});
}

TEST_P(InstantActions, ThatRepeatAreDoneOnce) {
  fleet.send_instant("startPause", "p");
  fleet.send_instant("stopPause", "q");
  fleet.send_instant("startPause", "p");
  EXPECT_FALSE(fleet.vehicle.paused());
}

TEST_P(InstantActions, InitialPositionNeedsItsParameters) {
  const char* type = fleet.third() ? "initializePosition" : "initPosition";
  const json place{
      {"x", "1.5"}, {"y", 2.0}, {"theta", 0.5}, {"mapId", "floor"}, {"lastNodeId", "home"}};
  fleet.send_instant(type, "good", place);
  EXPECT_EQ(fleet.instant_status("good"), "FINISHED");
  EXPECT_EQ(fleet.state()["lastNodeId"], "home");
  for (const char* key : {"x", "y", "theta", "mapId"}) {
    json less = place;
    less.erase(key);
    fleet.send_instant(type, std::string("no ") + key, less);
    EXPECT_EQ(fleet.instant_status(std::string("no ") + key), "FAILED") << key;
  }
  json elsewhere = place;
  elsewhere["mapId"] = "roof";
  fleet.send_instant(type, "roof", elsewhere);
  EXPECT_EQ(fleet.instant_status("roof"), "FAILED");
}

TEST(InstantActionsOfVersion3, AreClearedOnRequest) {
  FleetDouble fleet(ProtocolVersion::V3_0_0);
  fleet.send_instant("stateRequest", "s");
  fleet.send_instant("clearInstantActions", "clear");
  EXPECT_EQ(fleet.instant_status("s"), "");
  EXPECT_EQ(fleet.instant_status("clear"), "FINISHED");
}

TEST(InstantActionsOfVersion3, CancelOnlyTheNamedOrder) {
  FleetDouble fleet(ProtocolVersion::V3_0_0);
  fleet.send_order({});
  fleet.send_instant("cancelOrder", "c", {{"orderId", "another"}});
  EXPECT_EQ(fleet.instant_status("c"), "FAILED");
  EXPECT_TRUE(fleet.vehicle.may_drive());
}

TEST(InstantActionsOfVersion2, AreClearedByTheNextOrder) {
  FleetDouble fleet(ProtocolVersion::V2_1_0);
  fleet.send_instant("stateRequest", "s");
  EXPECT_EQ(fleet.instant_status("s"), "FINISHED");
  fleet.send_order({});
  EXPECT_EQ(fleet.instant_status("s"), "");
}

TEST(InstantActionsOfVersion2, AreAlsoReadUnderTheirOldName) {
  FleetDouble fleet(ProtocolVersion::V2_0_0);
  json message = fleet.instant("startPause", "p");
  message["instantActions"] = message["actions"];
  message.erase("actions");
  fleet.send(Topic::InstantActions, message);
  EXPECT_EQ(fleet.instant_status("p"), "FINISHED");
}

}  // namespace
}  // namespace fairway::vda5050::test
