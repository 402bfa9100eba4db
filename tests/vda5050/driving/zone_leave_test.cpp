// SPDX-License-Identifier: Apache-2.0
// Leave of version 3 to enter a zone.
#include <gtest/gtest.h>

#include "fleet_double.hpp"

namespace fairway::vda5050::test {
namespace {

// A zone from x = 3 to x = 4 across the lane, that needs leave.
void enable_zone(FleetDouble& fleet, const char* behavior = "STOP") {
  json message = fleet.header();
  const json polygon = json::array({{{"x", 3.0}, {"y", -1.0}},
                                    {{"x", 4.0}, {"y", -1.0}},
                                    {{"x", 4.0}, {"y", 1.0}},
                                    {{"x", 3.0}, {"y", 1.0}}});
  message["zoneSet"] = {{"mapId", "floor"},
                        {"zoneSetId", "day"},
                        {"zones", json::array({{{"zoneId", "door"},
                                                {"zoneType", "RELEASE"},
                                                {"releaseLossBehavior", behavior},
                                                {"vertices", polygon}}})}};
  fleet.send(Topic::ZoneSet, message);
  fleet.send_instant("enableZoneSet", "e", {{"zoneSetId", "day"}});
}

json first_request(FleetDouble& fleet) {
  const json state = fleet.state();
  return state["zoneRequests"].empty() ? json() : state["zoneRequests"][0];
}

void answer(FleetDouble& fleet, const char* grant, const char* lease = nullptr) {
  json message = fleet.header();
  json response{{"requestId", first_request(fleet)["requestId"]}, {"grantType", grant}};
  if (lease != nullptr) response["leaseExpiry"] = lease;
  message["responses"] = json::array({response});
  fleet.send(Topic::Responses, message);
}

TEST(ZonesThatNeedLeave, AreClosedUntilItIsGranted) {
  FleetDouble fleet(ProtocolVersion::V3_0_0);
  enable_zone(fleet);
  fleet.move_to({0.0, 0.0});
  EXPECT_TRUE(first_request(fleet).is_null()) << "no order leads through the zone";
  ASSERT_EQ(fleet.vehicle.zones().size(), 1U);
  fleet.send_order({});
  EXPECT_TRUE(fleet.errors().empty()) << "the zone does not refuse an order";
  fleet.move_to({0.0, 0.0});
  const json request = first_request(fleet);
  EXPECT_EQ(request["requestType"], "ACCESS");
  EXPECT_EQ(request["zoneId"], "door");
  EXPECT_EQ(request["zoneSetId"], "day");
  EXPECT_EQ(request["requestStatus"], "REQUESTED");
  answer(fleet, "QUEUED");
  EXPECT_EQ(first_request(fleet)["requestStatus"], "REQUESTED");
  EXPECT_EQ(fleet.vehicle.zones().size(), 1U);
  const std::uint64_t before = fleet.vehicle.route_revision();
  answer(fleet, "GRANTED");
  EXPECT_EQ(first_request(fleet)["requestStatus"], "GRANTED");
  EXPECT_TRUE(fleet.vehicle.zones().empty());
  EXPECT_NE(fleet.vehicle.route_revision(), before) << "the driver plans again";
  fleet.drive(0.0, 5.0);
  EXPECT_TRUE(fleet.errors().empty());
  EXPECT_TRUE(first_request(fleet).is_null()) << "the request ends behind the zone";
  EXPECT_EQ(fleet.vehicle.zones().size(), 1U) << "the zone is closed again";
}

TEST(ZonesThatNeedLeave, CloseAgainWhenTheLeaseEndsBeforeThem) {
  FleetDouble fleet(ProtocolVersion::V3_0_0);
  enable_zone(fleet);
  fleet.send_order({});
  fleet.move_to({0.0, 0.0});
  fleet.time = 1.8e9;  // 2027-01-15T08:00:00Z
  answer(fleet, "GRANTED", "2027-01-15T08:01:00.000Z");
  EXPECT_TRUE(fleet.vehicle.zones().empty());
  fleet.time = 1.8e9 + 61.0;
  fleet.move_to({0.0, 0.0});
  EXPECT_EQ(fleet.vehicle.zones().size(), 1U);
  EXPECT_EQ(first_request(fleet)["requestStatus"], "EXPIRED");
  EXPECT_TRUE(fleet.errors().empty());
}

TEST(ZonesThatNeedLeave, HoldAVehicleInsideThatLosesIt) {
  FleetDouble fleet(ProtocolVersion::V3_0_0);
  enable_zone(fleet, "STOP");
  fleet.send_order({});
  fleet.move_to({0.0, 0.0});
  answer(fleet, "GRANTED");
  fleet.drive(0.0, 3.5);
  answer(fleet, "REVOKED");
  EXPECT_FALSE(fleet.vehicle.may_drive());
  EXPECT_EQ(fleet.errors(), std::vector<std::string>{"RELEASE_LOST"});
  answer(fleet, "GRANTED");
  EXPECT_TRUE(fleet.vehicle.may_drive());
  EXPECT_TRUE(fleet.errors().empty());
}

TEST(ZonesThatNeedLeave, LetAVehicleGoOnThatLosesItIfTheySaySo) {
  for (const char* behavior : {"CONTINUE", "EVACUATE"}) {
    FleetDouble fleet(ProtocolVersion::V3_0_0);
    enable_zone(fleet, behavior);
    fleet.send_order({});
    fleet.move_to({0.0, 0.0});
    answer(fleet, "GRANTED");
    fleet.drive(0.0, 3.5);
    answer(fleet, "REVOKED");
    EXPECT_TRUE(fleet.vehicle.may_drive()) << behavior;
    EXPECT_TRUE(fleet.vehicle.zones().empty()) << "the vehicle is inside, and must get out";
    EXPECT_EQ(fleet.errors(), std::vector<std::string>{"RELEASE_LOST"});
    fleet.drive(3.5, 4.5);
    EXPECT_TRUE(fleet.errors().empty());
  }
}

TEST(ZonesThatNeedLeave, AreNoObstacleWhileTheVehicleWaits) {
  FleetDouble fleet(ProtocolVersion::V3_0_0);
  enable_zone(fleet);
  fleet.send_order({});
  for (int i = 0; i < 2; ++i) {
    fleet.time += 10.0;
    fleet.vehicle.update(
        {}, {.route = fleet.vehicle.route_revision(), .closed_leg = 1, .gave_up = true},
        fleet.time);
  }
  EXPECT_TRUE(fleet.errors().empty());
  EXPECT_TRUE(fleet.vehicle.may_drive());
}

TEST(ZonesThatNeedLeave, RequestItAgainForAnotherOrder) {
  FleetDouble fleet(ProtocolVersion::V3_0_0);
  enable_zone(fleet);
  fleet.send_order({});
  fleet.move_to({0.0, 0.0});
  const json first = first_request(fleet)["requestId"];
  answer(fleet, "GRANTED");
  fleet.send_instant("cancelOrder", "c");
  fleet.move_to({0.0, 0.0});
  EXPECT_TRUE(first_request(fleet).is_null());
  fleet.send_order({.id = "second"});
  fleet.move_to({0.0, 0.0});
  EXPECT_EQ(first_request(fleet)["requestStatus"], "REQUESTED");
  EXPECT_NE(first_request(fleet)["requestId"], first);
}

}  // namespace
}  // namespace fairway::vda5050::test
