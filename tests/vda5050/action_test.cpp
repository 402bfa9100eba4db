// SPDX-License-Identifier: Apache-2.0
// Instant actions, actions of orders, zones and leave.
#include <algorithm>

#include <gtest/gtest.h>

#include "fleet_double.hpp"

namespace fairway::vda5050::test {
namespace {

class Actions : public testing::TestWithParam<ProtocolVersion> {
 protected:
  FleetDouble fleet{GetParam(), {.robot = {}, .order_actions = {{"beep", 2.0}, {"blink", 1.0}}}};

  // An order whose node or edge has actions.
  void send_with(const std::vector<std::pair<std::string, std::string>>& actions,
                 const char* list) {
    json order = fleet.lanes({});
    for (const auto& [id, blocking] : actions) {
      order[list][1]["actions"].push_back(
          {{"actionType", "beep"}, {"actionId", id}, {"blockingType", blocking}});
    }
    fleet.send(Topic::Order, order);
  }
};

INSTANTIATE_TEST_SUITE_P(Versions,
                         Actions,
                         testing::Values(ProtocolVersion::V2_1_0, ProtocolVersion::V3_0_0));

TEST_P(Actions, CancelOrderWaitsForStandstill) {
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

TEST_P(Actions, CancelOrderWithoutAnOrderFails) {
  fleet.send_instant("cancelOrder", "c");
  EXPECT_EQ(fleet.instant_status("c"), "FAILED");
  EXPECT_EQ(fleet.errors(), std::vector<std::string>{fleet.type(Fault::NothingToCancel)});
  EXPECT_EQ(fleet.state()["errors"][0]["errorReferences"][0]["referenceValue"], "c");
  fleet.send_instant("stateRequest", "s");
  EXPECT_TRUE(fleet.errors().empty());
}

TEST_P(Actions, ANewOrderStartsAfterACancelledOne) {
  fleet.send_order({});
  fleet.send_instant("cancelOrder", "c");
  fleet.send_order({.id = "next"});
  EXPECT_TRUE(fleet.errors().empty());
  EXPECT_EQ(fleet.state()["orderId"], "next");
}

TEST_P(Actions, PauseFinishesAtStandstillAndKeepsTheOrder) {
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

TEST_P(Actions, OrdersAreTakenWhilePaused) {
  fleet.send_instant("startPause", "p");
  fleet.send_order({});
  EXPECT_EQ(fleet.state()["orderId"], "lanes");
  EXPECT_FALSE(fleet.vehicle.may_drive());
}

TEST_P(Actions, OfUnknownTypeFailAndAreNamed) {
  fleet.send_instant("liftTheRoof", "x-1");
  EXPECT_EQ(fleet.instant_status("x-1"), "FAILED");
  EXPECT_EQ(fleet.errors(), std::vector<std::string>{fleet.type(Fault::InvalidAction)});
}

TEST_P(Actions, ThatRepeatAreDoneOnce) {
  fleet.send_instant("startPause", "p");
  fleet.send_instant("stopPause", "q");
  fleet.send_instant("startPause", "p");
  EXPECT_FALSE(fleet.vehicle.paused());
}

TEST_P(Actions, InitialPositionNeedsItsParameters) {
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

TEST_P(Actions, OfANodeStartThereAndHoldTheVehicle) {
  send_with({{"a", "HARD"}}, "nodes");
  EXPECT_EQ(fleet.action_status("a"), "WAITING");
  ASSERT_EQ(fleet.vehicle.route().legs.size(), 1U);
  fleet.drive(0.0, 2.0);
  fleet.arrive(2.0);
  EXPECT_EQ(fleet.action_status("a"), "RUNNING");
  EXPECT_FALSE(fleet.vehicle.may_drive());
  fleet.time += 2.0;
  fleet.move_to({2.0, 0.0});
  EXPECT_EQ(fleet.action_status("a"), "FINISHED");
  EXPECT_TRUE(fleet.vehicle.may_drive());
  EXPECT_EQ(fleet.vehicle.route().legs.size(), 2U);
}

TEST_P(Actions, WithoutBlockingDoNotStopTheVehicle) {
  send_with({{"a", "NONE"}}, "nodes");
  EXPECT_EQ(fleet.vehicle.route().legs.size(), 3U);
  fleet.drive(0.0, 2.5);
  EXPECT_EQ(fleet.action_status("a"), "RUNNING");
  EXPECT_TRUE(fleet.vehicle.may_drive());
}

TEST_P(Actions, RunTogetherOrAloneAsTheyBlock) {
  send_with({{"a", "NONE"}, {"b", "SOFT"}, {"c", "HARD"}, {"d", "NONE"}}, "nodes");
  fleet.drive(0.0, 2.0);
  fleet.arrive(2.0);
  const auto all = [&] {
    return fleet.action_status("a") + " " + fleet.action_status("b") + " " +
           fleet.action_status("c") + " " + fleet.action_status("d");
  };
  EXPECT_EQ(all(), "RUNNING RUNNING WAITING WAITING");
  fleet.time += 2.0;
  fleet.move_to({2.0, 0.0});
  EXPECT_EQ(all(), "FINISHED FINISHED RUNNING WAITING");
  fleet.time += 2.0;
  fleet.move_to({2.0, 0.0});
  EXPECT_EQ(all(), "FINISHED FINISHED FINISHED RUNNING");
  EXPECT_TRUE(fleet.vehicle.may_drive());
}

TEST_P(Actions, OfAnEdgeEndWithIt) {
  send_with({{"a", "NONE"}}, "edges");
  fleet.drive(0.0, 1.0);
  EXPECT_EQ(fleet.action_status("a"), "WAITING");
  fleet.drive(1.0, 2.3);
  EXPECT_EQ(fleet.action_status("a"), "RUNNING");
  fleet.drive(2.3, 4.3);
  EXPECT_EQ(fleet.action_status("a"), "FINISHED");
}

TEST_P(Actions, WaitingOnesFailWithACancel) {
  send_with({{"a", "NONE"}}, "nodes");
  fleet.send_instant("cancelOrder", "c");
  EXPECT_EQ(fleet.action_status("a"), "FAILED");
  EXPECT_TRUE(fleet.vehicle.idle());
}

TEST(ActionsOfVersion3, AreClearedOnRequest) {
  FleetDouble fleet(ProtocolVersion::V3_0_0);
  fleet.send_instant("stateRequest", "s");
  fleet.send_instant("clearInstantActions", "clear");
  EXPECT_EQ(fleet.instant_status("s"), "");
  EXPECT_EQ(fleet.instant_status("clear"), "FINISHED");
}

TEST(ActionsOfVersion3, CancelOnlyTheNamedOrder) {
  FleetDouble fleet(ProtocolVersion::V3_0_0);
  fleet.send_order({});
  fleet.send_instant("cancelOrder", "c", {{"orderId", "another"}});
  EXPECT_EQ(fleet.instant_status("c"), "FAILED");
  EXPECT_TRUE(fleet.vehicle.may_drive());
}

TEST(ActionsOfVersion2, AreClearedByTheNextOrder) {
  FleetDouble fleet(ProtocolVersion::V2_1_0);
  fleet.send_instant("stateRequest", "s");
  EXPECT_EQ(fleet.instant_status("s"), "FINISHED");
  fleet.send_order({});
  EXPECT_EQ(fleet.instant_status("s"), "");
}

TEST(ActionsOfVersion2, AreAlsoReadUnderTheirOldName) {
  FleetDouble fleet(ProtocolVersion::V2_0_0);
  json message = fleet.instant("startPause", "p");
  message["instantActions"] = message["actions"];
  message.erase("actions");
  fleet.send(Topic::InstantActions, message);
  EXPECT_EQ(fleet.instant_status("p"), "FINISHED");
}

json zone_set(const FleetDouble& fleet, const std::string& id) {
  json message = fleet.header();
  const json polygon = json::array({{{"x", 3.0}, {"y", -1.0}},
                                    {{"x", 4.0}, {"y", -1.0}},
                                    {{"x", 4.0}, {"y", 1.0}},
                                    {{"x", 3.0}, {"y", 1.0}}});
  message["zoneSet"] = {
      {"mapId", "floor"},
      {"zoneSetId", id},
      {"zones", json::array({{{"zoneId", "z"}, {"zoneType", "BLOCKED"}, {"vertices", polygon}}})}};
  return message;
}

TEST(ZonesOfVersion3, AreUsedOnceEnabled) {
  FleetDouble fleet(ProtocolVersion::V3_0_0);
  fleet.send(Topic::ZoneSet, zone_set(fleet, "day"));
  EXPECT_TRUE(fleet.vehicle.zones().empty());
  EXPECT_EQ(fleet.state()["zoneSets"][0]["zoneSetStatus"], "DISABLED");
  fleet.send_instant("enableZoneSet", "e", {{"zoneSetId", "day"}});
  EXPECT_EQ(fleet.instant_status("e"), "FINISHED");
  ASSERT_EQ(fleet.vehicle.zones().size(), 1U);
  fleet.send(Topic::ZoneSet, zone_set(fleet, "night"));
  fleet.send_instant("enableZoneSet", "f", {{"zoneSetId", "night"}});
  const json sets = fleet.state()["zoneSets"];
  EXPECT_EQ(sets[0]["zoneSetStatus"], "DISABLED");
  EXPECT_EQ(sets[1]["zoneSetStatus"], "ENABLED");
  fleet.send_instant("deleteZoneSet", "d", {{"zoneSetId", "night"}});
  EXPECT_TRUE(fleet.vehicle.zones().empty());
  fleet.send_instant("enableZoneSet", "g", {{"zoneSetId", "night"}});
  EXPECT_EQ(fleet.instant_status("g"), "FAILED");
}

TEST(ZonesOfVersion3, WithAKnownIdAreRefused) {
  FleetDouble fleet(ProtocolVersion::V3_0_0);
  fleet.send(Topic::ZoneSet, zone_set(fleet, "day"));
  fleet.send(Topic::ZoneSet, zone_set(fleet, "day"));
  EXPECT_EQ(fleet.errors(), std::vector<std::string>{"DUPLICATE_ZONE_SET"});
}

TEST(ZonesOfVersion3, StopAVehicleInsideABlockedOne) {
  FleetDouble fleet(ProtocolVersion::V3_0_0);
  fleet.send_order({});
  fleet.send(Topic::ZoneSet, zone_set(fleet, "day"));
  fleet.send_instant("enableZoneSet", "e", {{"zoneSetId", "day"}});
  fleet.drive(0.0, 2.9);
  EXPECT_EQ(fleet.errors(), std::vector<std::string>{"BLOCKED_ZONE_VIOLATION"});
  EXPECT_FALSE(fleet.vehicle.may_drive());
}

json response(const FleetDouble& fleet, const json& request, const char* grant) {
  json message = fleet.header();
  message["responses"] = json::array({{{"requestId", request}, {"grantType", grant}}});
  return message;
}

TEST(LeaveOfVersion3, IsRequestedAndWidensTheStrip) {
  FleetDouble fleet(ProtocolVersion::V3_0_0);
  fleet.send_order({.width = 0.8, .release_required = true});
  fleet.move_to({0.0, 0.0});
  json requests = fleet.state()["edgeRequests"];
  ASSERT_EQ(requests.size(), 2U);  // of this edge and the next one
  EXPECT_EQ(requests[0]["edgeId"], "e0");
  EXPECT_EQ(requests[0]["requestStatus"], "REQUESTED");
  EXPECT_NE(requests[0]["requestId"], requests[1]["requestId"]);
  EXPECT_DOUBLE_EQ(fleet.vehicle.route().legs[0].strip->left, kLineTolerance);
  fleet.send(Topic::Responses, response(fleet, requests[0]["requestId"], "QUEUED"));
  EXPECT_DOUBLE_EQ(fleet.vehicle.route().legs[0].strip->left, kLineTolerance);
  fleet.send(Topic::Responses, response(fleet, requests[0]["requestId"], "GRANTED"));
  EXPECT_DOUBLE_EQ(fleet.vehicle.route().legs[0].strip->left, 0.8);
  EXPECT_EQ(fleet.state()["edgeRequests"][0]["requestStatus"], "GRANTED");
  fleet.drive(0.0, 2.3);
  requests = fleet.state()["edgeRequests"];
  EXPECT_EQ(requests[0]["edgeId"], "e1") << "the request of an edge that was left is removed";
}

TEST(LeaveOfVersion3, EndsWithItsLease) {
  FleetDouble fleet(ProtocolVersion::V3_0_0);
  fleet.send_order({.release_required = true});
  fleet.move_to({0.0, 0.0});
  json answer = response(fleet, fleet.state()["edgeRequests"][0]["requestId"], "GRANTED");
  answer["responses"][0]["leaseExpiry"] = "2027-01-15T08:01:00.000Z";
  fleet.time = 1.8e9;  // 2027-01-15T08:00:00Z
  fleet.send(Topic::Responses, answer);
  EXPECT_DOUBLE_EQ(fleet.vehicle.route().legs[0].strip->left, 0.5);
  fleet.time = 1.8e9 + 61.0;
  fleet.move_to({0.0, 0.0});
  EXPECT_DOUBLE_EQ(fleet.vehicle.route().legs[0].strip->left, kLineTolerance);
  EXPECT_EQ(fleet.state()["edgeRequests"][0]["requestStatus"], "EXPIRED");
}

TEST(LeaveOfVersion3, ThatIsMissingIsNoObstacle) {
  FleetDouble fleet(ProtocolVersion::V3_0_0);
  fleet.send_order({.release_required = true});
  for (int i = 0; i < 2; ++i) {
    fleet.time += 10.0;
    fleet.vehicle.update(
        {}, {.route = fleet.vehicle.route_revision(), .closed_leg = 0, .gave_up = true},
        fleet.time);
  }
  EXPECT_TRUE(fleet.errors().empty());
}

}  // namespace
}  // namespace fairway::vda5050::test
