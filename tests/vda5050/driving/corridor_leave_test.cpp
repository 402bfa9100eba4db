// SPDX-License-Identifier: Apache-2.0
// Leave of version 3 to use a corridor.
#include <gtest/gtest.h>

#include "fleet_double.hpp"

namespace fairway::vda5050::test {
namespace {

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
