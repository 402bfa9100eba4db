// SPDX-License-Identifier: Apache-2.0
// Zone sets of version 3: which zones are in force.
#include <gtest/gtest.h>

#include "vda5050/driving/fleet_double.hpp"

namespace fairway::vda5050::test {
namespace {

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

}  // namespace
}  // namespace fairway::vda5050::test
