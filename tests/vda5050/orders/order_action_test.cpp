// SPDX-License-Identifier: Apache-2.0
// Actions at the nodes and on the edges of an order.
#include <gtest/gtest.h>

#include "vda5050/driving/fleet_double.hpp"

namespace fairway::vda5050::test {
namespace {

class OrderActions : public testing::TestWithParam<ProtocolVersion> {
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
                         OrderActions,
                         testing::Values(ProtocolVersion::V2_1_0, ProtocolVersion::V3_0_0));

TEST_P(OrderActions, OfANodeStartThereAndHoldTheVehicle) {
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

TEST_P(OrderActions, WithoutBlockingDoNotStopTheVehicle) {
  send_with({{"a", "NONE"}}, "nodes");
  EXPECT_EQ(fleet.vehicle.route().legs.size(), 3U);
  fleet.drive(0.0, 2.5);
  EXPECT_EQ(fleet.action_status("a"), "RUNNING");
  EXPECT_TRUE(fleet.vehicle.may_drive());
}

TEST_P(OrderActions, RunTogetherOrAloneAsTheyBlock) {
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

TEST_P(OrderActions, OfAnEdgeEndWithIt) {
  send_with({{"a", "NONE"}}, "edges");
  fleet.drive(0.0, 1.0);
  EXPECT_EQ(fleet.action_status("a"), "WAITING");
  fleet.drive(1.0, 2.3);
  EXPECT_EQ(fleet.action_status("a"), "RUNNING");
  fleet.drive(2.3, 4.3);
  EXPECT_EQ(fleet.action_status("a"), "FINISHED");
}

TEST_P(OrderActions, WaitingOnesFailWithACancel) {
  send_with({{"a", "NONE"}}, "nodes");
  fleet.send_instant("cancelOrder", "c");
  EXPECT_EQ(fleet.action_status("a"), "FAILED");
  EXPECT_TRUE(fleet.vehicle.idle());
}

}  // namespace
}  // namespace fairway::vda5050::test
